#include "tracer/math/inverse4.h"

#include <cmath>

namespace durer {
namespace {

// Determinant of the 3x3 matrix that is left without a row and a column. The order of its products
// is povray's, to the last bit (found by the roots of sor on povray 3.7).
double minor(const Matrix4& m, int row, int column) {
  int rows[3], columns[3];
  for (int i = 0, r = 0, c = 0; i < 4; ++i) {
    if (i != row) rows[r++] = i;
    if (i != column) columns[c++] = i;
  }
  const auto at = [&](int i, int j) { return m[rows[i]][columns[j]]; };
  return at(0, 0) * at(1, 1) * at(2, 2) + at(0, 1) * at(1, 2) * at(2, 0) +
         at(0, 2) * at(1, 0) * at(2, 1) - at(2, 0) * at(1, 1) * at(0, 2) -
         at(2, 1) * at(1, 2) * at(0, 0) - at(2, 2) * at(1, 0) * at(0, 1);
}

}  // namespace

bool invert(const Matrix4& m, Matrix4& inverse) {
  Matrix4 minors;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) minors[i][j] = minor(m, i, j);
  }
  const double determinant = m[0][0] * minors[0][0] - m[0][1] * minors[0][1] +
                             m[0][2] * minors[0][2] - m[0][3] * minors[0][3];
  if (determinant == 0 || !std::isfinite(1 / determinant)) return false;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double sign = (i + j) % 2 == 0 ? 1 : -1;
      inverse[i][j] = sign * minors[j][i] / determinant;
    }
  }
  return true;
}

}  // namespace durer
