#include "tracer/sampling/jitter.h"

#include <gtest/gtest.h>

namespace durer {
namespace {

// spec/shading.md 2.2, checked there by reproducing POV-Ray's antialiased pictures.
TEST(SampleJitter, AgreesWithThePublishedExamples) {
  EXPECT_NEAR(sample_jitter(0, 0).x, 0.084015, 1e-6);
  EXPECT_NEAR(sample_jitter(0, 0).y, 0.084015, 1e-6);
  EXPECT_NEAR(sample_jitter(1.5, 2.25).x, -0.306641, 1e-6);
  EXPECT_NEAR(sample_jitter(1.5, 2.25).y, -0.197235, 1e-6);
  EXPECT_NEAR(sample_jitter(-1, 3).x, 0.277374, 1e-6);
  EXPECT_NEAR(sample_jitter(-1, 3).y, 0.353516, 1e-6);
}

}  // namespace
}  // namespace durer
