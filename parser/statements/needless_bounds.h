// bounded_by where it is of no use (spec/geometry.md 2): one warning each, as POV-Ray has them.
#pragma once

#include <unordered_set>

#include "parser/parser.h"
#include "tracer/scene/object.h"

namespace durer {

class NeedlessBounds {
 public:
  explicit NeedlessBounds(Parser& parser) : parser_(parser) {}

  // Of an object at scene level, just read, and of what stands for itself in it.
  void warn_about(const ObjectPtr& object) { count(object); }

 private:
  int count(const ObjectPtr& object);
  // Of what stands for itself in a union; of the union's own bounds.
  int count_in_members(const std::shared_ptr<const ShapeNode>& shape);
  int count_of_union(const ShapeNode& shape);
  bool is_finite(const ObjectPtr& object);

  Parser& parser_;
  // Unions in whose members nothing was found.
  std::unordered_set<std::shared_ptr<const ShapeNode>> clean_;
};

}  // namespace durer
