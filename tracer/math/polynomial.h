// Real roots of polynomials, in the order and with the quirks of spec/geometry.md 11: which of two
// nearly equal roots is found, or lost, decides pixels on the rims of tori and quartics.
#pragma once

namespace durer {

inline constexpr int kMostPolynomialDegree = 35;
// Where Sturm's method stops looking. Where only roots up to 1 are wanted: the first of the halves of
// that range to hold them all, so that the intervals in which roots are looked for stay the same.
inline constexpr double kFarthestRoot = 1e7;
inline constexpr double kFarthestParameter = 1e7 / (1 << 23);

// Solves c[0]·x^degree + … + c[degree] = 0. Writes the roots (at most `degree`) in the solver's
// order and returns their count. epsilon > 0: a root that near zero is eliminated. Sturm finds only
// roots in (0, farthest], ascending, multiple ones once.
int solve_polynomial(int degree, const double* c, bool sturm, double epsilon, double* roots,
                     double farthest = kFarthestRoot);

int solve_quadratic(const double* c, double* roots);
int solve_cubic(const double* c, double* roots);
int solve_quartic(const double* c, double* roots);
int solve_sturm(int degree, const double* c, double* roots, double farthest = kFarthestRoot);

}  // namespace durer
