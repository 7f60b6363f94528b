#include "tracer/sampling/lens.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace durer {
namespace {

// POV-Ray's grids; further points go where these leave room.
const std::vector<Vec2> kGrid4 = {{-0.25, 0.25}, {0.25, 0.25}, {-0.25, -0.25}, {0.25, -0.25}};
const std::vector<Vec2> kGrid7 = {
    {-0.288675, 0},     {0, 0},           {0.288675, 0},    {-0.144338, 0.25},
    {-0.144338, -0.25}, {0.144338, 0.25}, {0.144338, -0.25}};
const std::vector<Vec2> kGrid19 = {{-0.192450, 0.333333},
                                   {-0.192450, -0.333333},
                                   {0.192450, 0.333333},
                                   {0.192450, -0.333333},
                                   {0.384900, 0},
                                   {-0.384900, 0},
                                   {0, 0},
                                   {0, 0.333333},
                                   {0, -0.333333},
                                   {-0.288675, 0.166667},
                                   {-0.288675, -0.166667},
                                   {0.288675, 0.166667},
                                   {0.288675, -0.166667},
                                   {-0.096225, 0.166667},
                                   {-0.096225, -0.166667},
                                   {0.096225, 0.166667},
                                   {0.096225, -0.166667},
                                   {-0.192450, 0},
                                   {0.192450, 0}};
const std::vector<Vec2> kGrid37 = {{0, 0},
                                   {-0.216506, 0.375},
                                   {0.216506, -0.375},
                                   {-0.216506, -0.375},
                                   {0.216506, 0.375},
                                   {-0.433013, 0},
                                   {0.433013, 0},
                                   {-0.144338, 0.25},
                                   {0.144338, -0.25},
                                   {-0.144338, -0.25},
                                   {0.144338, 0.25},
                                   {-0.288675, 0},
                                   {0.288675, 0},
                                   {-0.072169, 0.125},
                                   {0.072169, -0.125},
                                   {-0.072169, -0.125},
                                   {0.072169, 0.125},
                                   {-0.144338, 0},
                                   {0.144338, 0},
                                   {-0.360844, 0.125},
                                   {-0.360844, -0.125},
                                   {0.360844, 0.125},
                                   {0.360844, -0.125},
                                   {-0.288675, 0.25},
                                   {-0.288675, -0.25},
                                   {0.288675, 0.25},
                                   {0.288675, -0.25},
                                   {-0.072169, 0.375},
                                   {-0.072169, -0.375},
                                   {0.072169, 0.375},
                                   {0.072169, -0.375},
                                   {-0.216506, 0.125},
                                   {-0.216506, -0.125},
                                   {0.216506, 0.125},
                                   {0.216506, -0.125},
                                   {0, 0.25},
                                   {0, -0.25}};

// Halton's sequence: the digits of index + 1 in a base, mirrored at the point.
double radical_inverse(int base, uint64_t index) {
  double value = 0, weight = 1.0 / base;
  for (uint64_t rest = index + 1; rest > 0; rest /= base, weight /= base) {
    value += static_cast<double>(rest % base) * weight;
  }
  return value;
}

// The index-th of points spread evenly over the disc of radius 1/2.
Vec2 disc_point(uint64_t index) {
  const double r = std::sqrt(0.25 * radical_inverse(2, index));
  const double angle = 2 * M_PI * radical_inverse(3, index);
  return {r * std::cos(angle), r * std::sin(angle)};
}

// Which cells of a square grid over the lens hold a point.
class CellGrid {
 public:
  explicit CellGrid(int points)
      : side_(2 * static_cast<int>(std::ceil(std::sqrt(points / M_PI))) + 1),
        taken_(static_cast<size_t>(side_) * side_) {}
  bool is_taken(const Vec2& p) const { return taken_[cell(p)]; }
  void take(const Vec2& p) { taken_[cell(p)] = true; }

 private:
  int row(double coordinate) const {
    return std::clamp(static_cast<int>(std::floor((coordinate + 0.5) * side_)), 0, side_ - 1);
  }
  size_t cell(const Vec2& p) const {
    return static_cast<size_t>(row(p.y)) * side_ + static_cast<size_t>(row(p.x));
  }

  int side_;
  std::vector<bool> taken_;
};

void add_points_between(int count, std::vector<Vec2>& points) {
  CellGrid grid(count);
  for (const Vec2& p : points) grid.take(p);
  const int64_t most_draws = int64_t{10} * count;
  int64_t draws_left = most_draws;
  uint64_t index = 0;
  const auto draw = [&] {
    --draws_left;
    const Vec2 p = disc_point(index);
    index = (index + 1) % static_cast<uint64_t>(most_draws);
    return p;
  };
  for (int i = static_cast<int>(points.size()); i < count; ++i) {
    Vec2 p = draw();
    while ((grid.is_taken(p) || dot(p, p) > 0.25) && draws_left > count - i) p = draw();
    grid.take(p);
    points.push_back(p);
  }
}

}  // namespace

LensPattern round_lens(int count) {
  LensPattern lens;
  const std::vector<Vec2>* grid = &kGrid4;
  if (count >= 37) {
    grid = &kGrid37;
    lens.first_batches = {7, 6, 6, 4, 4, 4, 4, 2};
  } else if (count >= 19) {
    grid = &kGrid19;
    lens.first_batches = {7, 6, 6};
  } else if (count >= 7) {
    grid = &kGrid7;
    lens.first_batches = {7};
  }
  const size_t from_grid = std::min(grid->size(), static_cast<size_t>(count));
  lens.points.assign(grid->begin(), grid->begin() + static_cast<ptrdiff_t>(from_grid));
  lens.points.reserve(static_cast<size_t>(count));
  add_points_between(count, lens.points);
  // Half the distance of the grid's neighbours where the grid is all.
  switch (count) {
    case 7:
      lens.jitter = 0.144338;
      break;
    case 19:
      lens.jitter = 0.096225;
      break;
    case 37:
      lens.jitter = 0.0721688;
      break;
    default:
      lens.jitter = 0.5 / std::sqrt(count);
  }
  return lens;
}

LensPattern shaped_lens(int count, const std::function<double(const Vec2&)>& brightness) {
  LensPattern lens;
  lens.jitter = 0.5 / std::sqrt(count);
  lens.points.reserve(static_cast<size_t>(count));
  // POV-Ray's stream of random numbers, which leaves out the first.
  std::mt19937 random;
  random.discard(1);
  const double squared_count = static_cast<double>(count) * count;
  // What is dark for long becomes a little brighter with every draw: the search ends.
  uint64_t draws = 0;
  while (lens.points.size() < static_cast<size_t>(count)) {
    const Vec2 p(radical_inverse(2, draws) - 0.5, radical_inverse(3, draws) - 0.5);
    const double weight = brightness(p + Vec2(0.5)) + static_cast<double>(draws) / squared_count;
    ++draws;
    if (static_cast<double>(random()) * 0x1p-32 <= weight) lens.points.push_back(p);
  }
  return lens;
}

}  // namespace durer
