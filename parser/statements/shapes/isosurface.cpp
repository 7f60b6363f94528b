// isosurface, parametric (spec/functions.md 7, 8).
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {
namespace {

ContainerNode parse_container(Parser& parser) {
  ContainerNode node;
  parser.expect_open("contained_by");
  if (parser.accept(Keyword::sphere)) {
    node.is_sphere = true;
    parser.expect_open("sphere");
    node.center = parser.parse_vector();
    parser.accept_comma();
    node.radius = parser.parse_float();
    parser.expect_close("sphere");
  } else if (parser.accept(Keyword::box)) {
    parser.expect_open("box");
    node.corner1 = parser.parse_vector();
    parser.accept_comma();
    node.corner2 = parser.parse_vector();
    parser.expect_close("box");
  } else {
    parser.error_expected("sphere or box");
  }
  parser.expect_close("contained_by");
  return node;
}

std::shared_ptr<const FunctionNode> expect_function(Parser& parser, FunctionParameters defaults) {
  if (!parser.accept(Keyword::function)) parser.error_expected("function");
  return parser.parse_function(defaults);
}

}  // namespace

ShapeNode parse_isosurface(Parser& parser) {
  IsosurfaceNode node;
  node.function = expect_function(parser, FunctionParameters::xyz);
  for (;;) {
    if (parser.accept(Keyword::contained_by)) {
      node.container = parse_container(parser);
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
    } else if (parser.accept(Keyword::all_intersections)) {
      node.all_intersections = true;
    } else {
      break;
    }
  }
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
  node.u_range = {low.x, high.x};
  node.v_range = {low.y, high.y};
  for (;;) {
    if (parser.accept(Keyword::contained_by)) {
      node.container = parse_container(parser);
    } else if (parser.accept(Keyword::accuracy)) {
      node.accuracy = parser.parse_float();
    } else if (parser.accept(Keyword::max_gradient)) {
      node.max_gradient = parser.parse_float();
    } else if (parser.accept(Keyword::precompute)) {
      node.precompute_depth = parser.parse_int();
      parser.accept_comma();
      for (;;) {
        if (parser.accept(Keyword::x)) {
          node.precompute[0] = true;
        } else if (parser.accept(Keyword::y)) {
          node.precompute[1] = true;
        } else if (parser.accept(Keyword::z)) {
          node.precompute[2] = true;
        } else {
          break;
        }
        parser.accept_comma();
      }
    } else {
      break;
    }
  }
  return node;
}

}  // namespace durer
