// Polynomials made of roots that are known.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tracer/math/polynomial.h"

namespace durer {
namespace {

// Leading coefficient first; takes the factor with these coefficients.
void multiply(std::vector<double>& c, const std::vector<double>& factor) {
  std::vector<double> product(c.size() + factor.size() - 1, 0);
  for (size_t i = 0; i < c.size(); ++i) {
    for (size_t k = 0; k < factor.size(); ++k) product[i + k] += c[i] * factor[k];
  }
  c = product;
}

TEST(Polynomials, SturmFindsSeparateRoots) {
  // (x-1)(x-2)(x-3)(x-4)(x-5)
  const double c[] = {1, -15, 85, -225, 274, -120};
  double roots[5];
  ASSERT_EQ(solve_polynomial(5, c, true, 0, roots), 5);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(roots[i], i + 1, 1e-9);
  const double quartic[] = {1, -10, 35, -50, 24};
  ASSERT_EQ(solve_polynomial(4, quartic, false, 0, roots), 4);
}

// Degrees with a way of their own (3 to 6) and others; few and many roots, negative and complex ones
// among them; near to 0, where regula falsi is left out, and not.
TEST(Polynomials, SturmFindsThePositiveRoots) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int total = 0;
  for (int degree = 3; degree <= 8; ++degree) {
    for (int trial = 0; trial < 3000; ++trial) {
      std::vector<double> c{-1.5 + 4 * unit(random)}, expected;
      const double size = std::pow(10, 2 * unit(random));
      int left = degree;
      while (left > 0) {
        if (left > 1 && unit(random) < 0.3) {
          const double re = size * (2 * unit(random) - 1), im = size * (0.3 + unit(random));
          multiply(c, {1, -2 * re, re * re + im * im});
          left -= 2;
          continue;
        }
        const double root = size * (2 * unit(random) - 0.6);
        multiply(c, {1, -root});
        if (root > 0) expected.push_back(root);
        --left;
      }
      std::sort(expected.begin(), expected.end());
      // Coefficients of 0, roots near 0 and roots that nearly meet have rules of their own.
      bool separate = std::abs(c[0]) > 0.1;
      for (size_t i = 0; i < expected.size(); ++i) {
        separate &= expected[i] - (i ? expected[i - 1] : 0) > 0.1 * size;
      }
      if (!separate) continue;
      double roots[8];
      ASSERT_EQ(solve_sturm(degree, c.data(), roots), static_cast<int>(expected.size()))
          << "degree " << degree << ", trial " << trial;
      for (size_t i = 0; i < expected.size(); ++i) {
        ASSERT_NEAR(roots[i], expected[i], 1e-5 * size) << "degree " << degree;
      }
      total += static_cast<int>(expected.size());
    }
  }
  EXPECT_GT(total, 10000);
}

// The fiftieth point that is tried on the way from 0 to 1e7 is the root, to 1e7/2^50.
TEST(Polynomials, WhatRegulaFalsiCannotFindIsHalved) {
  // x^4 + x^3 + x^2 + x - 4 is 0 at 1 and crosses nowhere else on the positive side.
  const double c[] = {1, 1, 1, 1, -4};
  double root;
  ASSERT_EQ(solve_sturm(4, c, &root), 1);
  const double cell = 1e7 / std::exp2(50);
  EXPECT_NEAR(root, 1, cell);
  // The border of two cells, to the last bit, which the forty-ninth was not.
  EXPECT_EQ(std::fmod(root / cell, 2), 1);
}

}  // namespace
}  // namespace durer
