// Inverse of a 4x4 matrix by its cofactors.
#pragma once

#include <array>

namespace durer {

using Matrix4 = std::array<std::array<double, 4>, 4>;

// False, with the result left alone, where the determinant is 0 or its reciprocal is no number.
bool invert(const Matrix4& matrix, Matrix4& inverse);

}  // namespace durer
