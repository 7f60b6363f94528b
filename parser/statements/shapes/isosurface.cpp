// isosurface, parametric (spec/functions.md 7, 8).
#include <algorithm>

#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {
namespace {

void parse_container(Parser& parser, ContainerNode& node) {
  parser.expect_open("contained_by");
  if (parser.accept(Keyword::sphere)) {
    node = {};
    node.is_sphere = true;
    parser.expect_open("sphere");
    node.center = parser.parse_vector();
    parser.accept_comma();
    node.radius = parser.parse_float();
    parser.expect_close("sphere");
  } else if (parser.accept(Keyword::box)) {
    node = {};
    parser.expect_open("box");
    node.corner1 = parser.parse_vector();
    parser.accept_comma();
    node.corner2 = parser.parse_vector();
    parser.expect_close("box");
    const Vec3 low = glm::min(node.corner1, node.corner2);
    node.corner2 = glm::max(node.corner1, node.corner2);
    node.corner1 = low;
  }
  // Empty braces leave what was there.
  parser.expect_close("contained_by");
}

std::shared_ptr<const FunctionNode> expect_function(Parser& parser, FunctionParameters defaults) {
  if (!parser.accept(Keyword::function)) parser.error_expected("function");
  return parser.parse_function(defaults);
}

constexpr int kMostTrace = 10;

// Values that make no sense are replaced by the nearest that does.
void check(Parser& parser, IsosurfaceNode& node) {
  if (node.accuracy <= 0) {
    parser.warning("the accuracy of an isosurface must be positive; 0.001 is used");
    node.accuracy = 0.001;
  }
  if (node.max_gradient <= 0) {
    parser.warning("the max_gradient of an isosurface must be positive; 1.1 is used");
    node.max_gradient = 1.1;
  }
  if (node.max_trace < 1 || node.max_trace > kMostTrace) {
    node.max_trace = std::clamp(node.max_trace, 1, kMostTrace);
    parser.warning("the max_trace of an isosurface lies between 1 and 10; " +
                   std::to_string(node.max_trace) + " is used");
  }
}

}  // namespace

ShapeNode parse_isosurface(Parser& parser) {
  IsosurfaceNode node;
  node.function = expect_function(parser, FunctionParameters::xyz);
  for (;;) {
    if (parser.accept(Keyword::contained_by)) {
      parse_container(parser, node.container);
    } else if (parser.accept(Keyword::threshold)) {
      node.threshold = parser.parse_float();
    } else if (parser.accept(Keyword::accuracy)) {
      node.accuracy = parser.parse_float();
    } else if (parser.accept(Keyword::max_gradient)) {
      node.max_gradient = parser.parse_float();
    } else if (parser.accept(Keyword::evaluate)) {
      node.evaluate = true;
      for (int i = 0; i < 3; ++i) {
        node.evaluate_parameters[i] = parser.parse_float();
        parser.accept_comma();
      }
    } else if (parser.accept(Keyword::open)) {
      node.open = true;
    } else if (parser.accept(Keyword::max_trace)) {
      node.max_trace = parser.parse_int();
      node.all_intersections = false;
    } else if (parser.accept(Keyword::all_intersections)) {
      node.max_trace = kMostTrace;
      node.all_intersections = true;
    } else {
      break;
    }
  }
  check(parser, node);
  return node;
}

ShapeNode parse_parametric(Parser& parser) {
  ParametricNode node;
  for (auto& function : node.function) {
    function = expect_function(parser, FunctionParameters::uvw);
    parser.accept_comma();
  }
  const Vec2 low = parser.parse_uv();
  parser.accept_comma();
  const Vec2 high = parser.parse_uv();
  node.u_range = {std::min(low.x, high.x), std::max(low.x, high.x)};
  node.v_range = {std::min(low.y, high.y), std::max(low.y, high.y)};
  for (;;) {
    if (parser.accept(Keyword::contained_by)) {
      parse_container(parser, node.container);
    } else if (parser.accept(Keyword::accuracy)) {
      node.accuracy = parser.parse_float();
    } else if (parser.accept(Keyword::max_gradient)) {
      node.max_gradient = parser.parse_float();
    } else if (parser.accept(Keyword::precompute)) {
      node.precompute_depth = parser.parse_int();
      parser.accept_comma();
      // Each at most once, in this order; a second `precompute` keeps those of the first.
      constexpr Keyword kAxes[] = {Keyword::x, Keyword::y, Keyword::z};
      for (int axis = 0; axis < 3; ++axis) {
        if (!parser.accept(kAxes[axis])) continue;
        node.precompute[axis] = true;
        parser.accept_comma();
      }
      const auto& axes = node.precompute;
      if ((axes[0] || axes[1] || axes[2]) &&
          (node.precompute_depth < 1 || node.precompute_depth > 20)) {
        parser.error("the depth of precompute lies between 1 and 20");
      }
    } else {
      break;
    }
  }
  return node;
}

}  // namespace durer
