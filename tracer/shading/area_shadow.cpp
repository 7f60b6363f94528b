// Soft shadows: the hierarchical mean over an area light's grid (spec/shading.md 9.3).
#include <array>
#include <cmath>

#include "tracer/lights/area_light_grid.h"
#include "tracer/math/uncleared.h"
#include "tracer/shading/direct_light.h"

namespace durer {
namespace {

constexpr uint32_t kPurposeAreaLight = 1;

double color_distance(const RGB& a, const RGB& b) {
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
}

// What is known of a grid's samples. Grids up to a size are kept on the stack, larger ones are traced
// again when asked again: the jitter is a function of the grid point, so the answers agree.
class KnownSamples {
 public:
  explicit KnownSamples(int cells) : is_kept_(cells <= kMost) {}

  const RGB* find(int cell) const {
    return is_kept_ && known_[cell / 64u] >> cell % 64u & 1 ? &color_[cell].value : nullptr;
  }
  void keep(int cell, const RGB& color) {
    if (!is_kept_) return;
    known_[cell / 64u] |= uint64_t{1} << cell % 64u;
    color_[cell].emplace(color);
  }

 private:
  static constexpr int kMost = 1024;

  bool is_kept_;
  std::array<uint64_t, kMost / 64> known_{};  // a bit for each grid point
  std::array<Uncleared<RGB>, kMost> color_;
};

// Each rectangle is the mean of its corners; where they are uneven, of its quarters.
// void trace(const int (&column)[4], const int (&row)[4], RGB (&color)[4])
template <typename Trace>
class AreaMean {
 public:
  AreaMean(int adaptive, const Trace& trace) : adaptive_(adaptive), trace_(trace) {}

  RGB of(int u1, int v1, int u2, int v2, int level) const {
    RGB corner[4];
    trace_({u1, u2, u1, u2}, {v1, v1, v2, v2}, corner);
    if (u2 - u1 > 1 || v2 - v1 > 1) {
      const bool uneven = color_distance(corner[0], corner[1]) > 0.1 ||
                          color_distance(corner[1], corner[3]) > 0.1 ||
                          color_distance(corner[3], corner[2]) > 0.1 ||
                          color_distance(corner[2], corner[0]) > 0.1;
      if (level < adaptive_ || uneven) {
        const int u_low = (u1 + u2) / 2, u_high = (u1 + u2 + 1) / 2;
        const int v_low = (v1 + v2) / 2, v_high = (v1 + v2 + 1) / 2;
        corner[0] = of(u1, v1, u_low, v_low, level + 1);
        corner[1] = of(u_high, v1, u2, v_low, level + 1);
        corner[2] = of(u1, v_high, u_low, v2, level + 1);
        corner[3] = of(u_high, v_high, u2, v2, level + 1);
      }
    }
    return 0.25f * (corner[0] + corner[1] + corner[2] + corner[3]);
  }

 private:
  int adaptive_;
  const Trace& trace_;
};

}  // namespace

// Not built into its caller: what is known of a grid takes 12 KB of stack, and the callers call
// themselves once for each bounce.
[[gnu::noinline]] RGB DirectLight::area_shadow(int index, const ShadowStart& start,
                                               const TracedRay& ray, const RGB& color,
                                               RayCounts& counts) const {
  const Light& light = scene_.lights[index];
  const LightNode& node = light.node();
  const AreaLightGrid grid(light, start.point);
  const int columns = node.size1, rows = node.size2;
  const uint32_t purpose = kPurposeAreaLight + 16 * static_cast<uint32_t>(index);
  KnownSamples known(columns * rows);

  const auto trace = [&](const int(&column)[4], const int(&row)[4], RGB(&seen)[4]) {
    AreaSamples samples;
    int cell[4];
    bool looked = false;
    for (int k = 0; k < 4; ++k) cell[k] = row[k] * columns + column[k];
    for (int k = 0; k < 4; ++k) {
      if (const RGB* kept = known.find(cell[k])) {
        seen[k] = *kept;
        continue;
      }
      if (!looked) {
        for (int i = 0; i < 4; ++i) {
          samples.put(i, column[i], row[i]);
          if (node.jitter) {
            samples.displace(i, path_random_bits(ray.path, purpose, static_cast<uint32_t>(cell[i])));
          }
        }
        look_at_samples(grid, samples);
        looked = true;
      }
      seen[k] = color;
      trace_shadow(index, start, samples.direction(k), ray, seen[k], counts);
      known.keep(cell[k], seen[k]);
    }
  };
  return AreaMean(node.adaptive, trace).of(0, 0, columns - 1, rows - 1, 0);
}

}  // namespace durer
