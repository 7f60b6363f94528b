#include <gtest/gtest.h>

#include <cfenv>

// The renderer's promises of equal bits rest on round-to-nearest.
TEST(Environment, RoundsToNearest) { EXPECT_EQ(std::fegetround(), FE_TONEAREST); }
