#include "parser/symbol_table.h"

namespace durer {
namespace {

constexpr size_t kEntriesPerBlock = 256;

}  // namespace

SymbolTable::SymbolTable() { push_scope(); }
SymbolTable::~SymbolTable() = default;

Entry& SymbolTable::add(Name name, uint32_t scope) {
  if (free_.empty()) {
    blocks_.push_back(std::make_unique<Entry[]>(kEntriesPerBlock));
    for (size_t i = kEntriesPerBlock; i-- > 0;) free_.push_back(&blocks_.back()[i]);
  }
  Entry* entry = free_.back();
  free_.pop_back();
  if (name >= tops_.size()) tops_.resize(name + 256);
  entry->name = name;
  entry->scope = scope;
  entry->live = true;
  Entry** link = &tops_[name];
  while (*link && (*link)->scope > scope) link = &(*link)->shadowed;
  entry->shadowed = *link;
  *link = entry;
  entry->position = static_cast<uint32_t>(scopes_[scope].size());
  scopes_[scope].push_back(entry);
  return *entry;
}

void SymbolTable::remove(Entry& entry) {
  unlink(entry);
  std::vector<Entry*>& scope = scopes_[entry.scope];
  scope[entry.position] = scope.back();
  scope[entry.position]->position = entry.position;
  scope.pop_back();
  entry.live = false;
  release(&entry);
}

void SymbolTable::unlink(Entry& entry) {
  // Usually the top of its stack; a variable removed through an alias may be further down.
  Entry** link = &tops_[entry.name];
  while (*link && *link != &entry) link = &(*link)->shadowed;
  if (*link) *link = entry.shadowed;
}

void SymbolTable::make_alias(Entry& entry, const Reference& target) {
  ++target.entry->references;
  if (!entry.alias_memory) entry.alias_memory = std::make_unique<Reference>();
  entry.alias = entry.alias_memory.get();
  *entry.alias = target;
}

void SymbolTable::release(Entry* entry) {
  entry->value = Value();
  entry->deprecation.reset();
  if (entry->alias) {
    Entry* target = entry->alias->entry;
    entry->alias = nullptr;
    drop(*target);
  }
  if (entry->references == 0) free_.push_back(entry);
}

void SymbolTable::push_scope() {
  if (scopes_.size() == depth_) scopes_.emplace_back();
  ++depth_;
}

void SymbolTable::pop_scope() {
  std::vector<Entry*>& scope = scopes_[depth_ - 1];
  while (!scope.empty()) {
    Entry* entry = scope.back();
    scope.pop_back();
    unlink(*entry);
    entry->live = false;
    release(entry);
  }
  --depth_;
}

}  // namespace durer
