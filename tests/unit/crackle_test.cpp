// crackle finds the same points among four cells at once, kept or not, as one that looks at every cell.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tracer/math/lattice_hash.h"
#include "tracer/patterns/crackle_features.h"
#include "tracer/patterns/noise.h"

namespace durer {
namespace {

std::vector<double> distances_by_hand(const Vec3& cell, const Vec3& p) {
  const std::vector<double>& random = pattern_random_table();
  std::vector<double> squares;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const Vec3 corner = cell + Vec3(x, y, z);
        const int q = hash_cell(static_cast<int>(static_cast<int64_t>(corner.x) & 4095),
                                static_cast<int>(static_cast<int64_t>(corner.y) & 4095),
                                static_cast<int>(static_cast<int64_t>(corner.z) & 4095));
        const Vec3 way = corner + Vec3(random[q], random[q + 1], random[q + 2]) - p;
        squares.push_back(dot(way, way));
      }
    }
  }
  std::sort(squares.begin(), squares.end());
  return squares;
}

TEST(CrackleFeatures, AreTheNearest) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 20000; ++i) {
    // Places that come again, of either sign, and some far off.
    const double reach = i % 5 == 0 ? 1e6 : 3;
    const Vec3 p(reach * (2 * unit(random) - 1), reach * (2 * unit(random) - 1),
                 reach * (2 * unit(random) - 1));
    const Vec3 cell = glm::floor(p);
    const AdjacentFeatures& features = features_around(cell);
    double squares[3];
    find_nearest(features, p, squares);
    const std::vector<double> expected = distances_by_hand(cell, p);
    for (int k = 0; k < 3; ++k) ASSERT_EQ(squares[k], expected[k]) << "point " << i;
    const Vec3 way = feature_at(features, p, squares[0]) - p;
    ASSERT_EQ(dot(way, way), expected[0]);
  }
}

TEST(CrackleFeatures, AreNoneOfWhatIsNoPoint) {
  const AdjacentFeatures& features = features_around(Vec3(2, -1, 0));
  for (const double odd : {std::nan(""), HUGE_VAL}) {
    double squares[3];
    find_nearest(features, Vec3(odd, 0.5, 0.5), squares);
    for (const double square : squares) EXPECT_EQ(square, 1e300);
    EXPECT_EQ(feature_at(features, Vec3(odd, 0.5, 0.5), squares[0]), Vec3(0));
  }
}

}  // namespace
}  // namespace durer
