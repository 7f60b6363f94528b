// The expression tree between TapeBuilder and the tape: private to this room.
#pragma once

#include <utility>
#include <vector>

#include "tracer/functions/instruction.h"
#include "tracer/functions/tape.h"

namespace durer {

enum class ExpressionKind : uint8_t {
  constant, parameter, loop_variable, negate, parenthesized, binary, sequence, float_call,
  function_call, self_call, loop,
};

struct TapeBuilder::Expression {
  struct Node {
    explicit Node(ExpressionKind node_kind) : kind(node_kind) {}

    ExpressionKind kind;
    bool as_written = false;  // constant: a literal or identifier, not a folded number
    bool expand_power = false;  // float_call pow: in folded position
    bool product = false;       // loop
    BinaryOperator op{};
    FloatFunction function{};
    FunctionMember member{};
    int index = 0;  // parameter, loop
    double value = 0;
    FunctionHandle callee;
    std::vector<Term> children;
    std::vector<BinaryOperator> operators;  // sequence: between children
  };

  int parameter_count = 0;
  int loop_count = 0;
  bool zero_power = false;
  std::vector<Node> nodes;

  TapeBuilder::Term add(Node node) {
    nodes.push_back(std::move(node));
    return {static_cast<int32_t>(nodes.size()) - 1};
  }
  Node& node(Term t) { return nodes[static_cast<size_t>(t.id)]; }

  bool is_constant(Term t) { return node(t).kind == ExpressionKind::constant; }

  bool contains_variable(Term t) {
    const Node& n = node(t);
    if (n.kind == ExpressionKind::parameter || n.kind == ExpressionKind::loop_variable) return true;
    for (Term child : n.children)
      if (contains_variable(child)) return true;
    return false;
  }

  // Turns chains of one level into sequences and folds them where `folding`.
  Term fold(Term t, bool folding);
  Term fold_sequence(Term t, bool folding);
  void fold_float_call(Term t, bool folding);
};

// Writes the tape of a folded expression (tape_emitter.cpp).
Tape write_tape(TapeBuilder::Expression& expression, TapeBuilder::Term body);

}  // namespace durer
