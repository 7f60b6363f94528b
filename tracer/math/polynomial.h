// Real roots of polynomials, in the order and with the quirks of spec/geometry.md 11: which of two
// nearly equal roots is found, or lost, decides pixels on the rims of tori and quartics.
#pragma once

namespace durer {

inline constexpr int kMostPolynomialDegree = 35;

// Solves c[0]·x^degree + … + c[degree] = 0. Writes the roots (at most `degree`) in the solver's
// order and returns their count. epsilon > 0: a root that near zero is eliminated. Sturm finds only
// roots in (0, 1e7], ascending, multiple ones once.
int solve_polynomial(int degree, const double* c, bool sturm, double epsilon, double* roots);

int solve_quadratic(const double* c, double* roots);
int solve_cubic(const double* c, double* roots);
int solve_quartic(const double* c, double* roots);
int solve_sturm(int degree, const double* c, double* roots);

}  // namespace durer
