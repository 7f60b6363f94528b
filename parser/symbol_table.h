// Identifiers and their scopes (spec/language.md 12): dynamic scoping, a lookup is one array access.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "parser/token.h"
#include "parser/value.h"

namespace durer {

struct Entry;

// A variable, or an element inside the arrays of one: what a macro parameter is an alias of.
struct Reference {
  static constexpr int kMostLevels = 8;

  Entry* entry = nullptr;
  int levels = 0;
  // Flat index into the array, then into the array in that element, and so on.
  std::array<int64_t, kMostLevels> path;
};

struct Deprecation {
  std::string text;
  bool once = false;
  bool reported = false;
};

// One live identifier. Entries of a name form a stack, innermost on top.
struct Entry {
  Value value;
  Name name = 0;
  uint32_t scope = 0;     // 0: global
  uint32_t position = 0;  // in its scope's list
  uint32_t references = 0;  // aliases of this entry; keeps a dead one from being reused
  bool live = true;
  Entry* shadowed = nullptr;
  Reference* alias = nullptr;  // set: this entry stands for that variable
  std::unique_ptr<Reference> alias_memory;  // kept for the next entry in this place
  std::unique_ptr<Deprecation> deprecation;
};

class SymbolTable {
 public:
  SymbolTable();
  ~SymbolTable();
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;

  // The innermost visible entry, or null.
  Entry* find(Name name) const { return name < tops_.size() ? tops_[name] : nullptr; }
  // A new entry, visible unless a scope inside `scope` has the name. `scope` <= innermost().
  Entry& add(Name name, uint32_t scope);
  // Removes a visible entry; aliases of it die with it.
  void remove(Entry& entry);
  void make_alias(Entry& entry, const Reference& target);
  // Keeps an entry from being reused while somebody looks whether it stays alive.
  static void hold(Entry& entry) { ++entry.references; }
  void drop(Entry& entry) {
    if (--entry.references == 0 && !entry.live) free_.push_back(&entry);
  }

  uint32_t innermost() const { return depth_ - 1; }
  // Tables below the global one.
  uint32_t nested() const { return depth_ - 1; }
  void push_scope();
  void pop_scope();

  // Calls f(name) for each visible name: for suggestions.
  template <typename F>
  void for_each_name(F f) const {
    for (size_t i = 0; i < tops_.size(); ++i) {
      if (tops_[i]) f(static_cast<Name>(i));
    }
  }

 private:
  void unlink(Entry& entry);
  void release(Entry* entry);

  std::vector<Entry*> tops_;  // by name
  std::vector<std::vector<Entry*>> scopes_;
  uint32_t depth_ = 0;
  std::vector<std::unique_ptr<Entry[]>> blocks_;
  std::vector<Entry*> free_;
};

}  // namespace durer
