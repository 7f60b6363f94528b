#include "parser/statements/transformations.h"

#include <cmath>

#include "parser/parser.h"
#include "parser/statements/statements.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

Transform parse_scale(Parser& parser) {
  Vec3 by = parser.parse_vector();
  for (int axis = 0; axis < 3; ++axis) {
    if (by[axis] != 0) continue;
    by[axis] = 1;
    parser.warning(std::string("scaling ") + "XYZ"[axis] + " by 0 is not possible; 1 is used");
  }
  return Transform::scaling(by);
}

Transform parse_matrix(Parser& parser) {
  double n[12];
  parser.parse_number_list(n, 12, "matrix");
  Matrix m;
  for (int i = 0; i < 4; ++i) m.row[i] = {n[3 * i], n[3 * i + 1], n[3 * i + 2]};
  for (int column = 0; column < 3; ++column) {
    if (std::abs(m.row[0][column]) < kEpsilon && std::abs(m.row[1][column]) < kEpsilon &&
        std::abs(m.row[2][column]) < kEpsilon) {
      parser.warning("a column of the matrix is all zero; its diagonal entry is set to 1");
      m.row[column][column] = 1;
    }
  }
  Transform result;
  if (!Transform::from_matrix(m, result)) {
    parser.error("the matrix is singular: it flattens space and cannot be undone");
  }
  return result;
}

}  // namespace

bool accept_transformation(Parser& parser, Transform& transform) {
  const Token& token = parser.peek();
  if (token.kind != TokenKind::keyword) return false;
  switch (token.keyword) {
    case Keyword::translate:
      parser.next();
      transform = Transform::translation(parser.parse_vector());
      return true;
    case Keyword::rotate:
      parser.next();
      transform = Transform::rotation(parser.parse_vector());
      return true;
    case Keyword::scale:
      parser.next();
      transform = parse_scale(parser);
      return true;
    case Keyword::matrix:
      parser.next();
      transform = parse_matrix(parser);
      return true;
    case Keyword::transform:
      parser.next();
      if (const auto named = parser.accept_identifier<Transform>(ValueKind::transform)) {
        transform = *named;
      } else {
        transform = parse_transform_block(parser);
      }
      return true;
    default:
      return false;
  }
}

Transform parse_transformations(Parser& parser) {
  Transform all, one;
  while (accept_transformation(parser, one)) all = all.then(one);
  return all;
}

// `inverse` anywhere inverts the whole block.
Transform parse_transform_block(Parser& parser) {
  parser.expect_open("transform");
  Transform all, one;
  bool inverse = false;
  for (;;) {
    if (parser.accept(Keyword::inverse)) {
      inverse = true;
    } else if (const auto named = parser.accept_identifier<Transform>(ValueKind::transform)) {
      all = all.then(*named);
    } else if (accept_transformation(parser, one)) {
      all = all.then(one);
    } else {
      break;
    }
  }
  parser.expect_close("transform");
  return inverse ? all.inverted() : all;
}

}  // namespace durer
