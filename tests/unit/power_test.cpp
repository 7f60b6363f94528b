#include "tracer/math/power.h"

#include <gtest/gtest.h>

namespace durer {
namespace {

TEST(Power, AgreesWithTheLibrary) {
  for (const double exponent :
       {0.0, 1.0, 2.0, 3.0, 20.0, 40.0, 400.0, 1023.0, 1024.0, 1025.0, 2.5, -2.0, -0.5}) {
    for (double base = 0.05; base < 1.2; base += 0.0625) {
      const double expected = std::pow(base, exponent);
      EXPECT_NEAR(power(base, exponent), expected, 1.2e-16 * (std::abs(exponent) + 1) * expected)
          << base << '^' << exponent;
    }
    EXPECT_EQ(power(1, exponent), 1);
  }
  EXPECT_EQ(power(0, 0), 1);
  EXPECT_EQ(power(0, 7), 0);
}

}  // namespace
}  // namespace durer
