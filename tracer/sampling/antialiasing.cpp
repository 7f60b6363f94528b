#include "tracer/sampling/antialiasing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "tracer/sampling/jitter.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

PixelColor operator+(const PixelColor& a, const PixelColor& b) {
  return {a.color + b.color, a.transmit + b.transmit};
}

// As POV-Ray divides: a product with the reciprocal rounds otherwise, and codes amid two show it.
PixelColor divided(const PixelColor& c, float by) {
  return {RGB(c.color.red / by, c.color.green / by, c.color.blue / by), c.transmit / by};
}

// Values from 2^-20 to 16 by their exponent and the first six bits of their mantissa.
constexpr uint32_t kStepShift = 23 - 6;
constexpr uint32_t kFirstStep = (127u - 20) << 6;
constexpr uint32_t kLastStep = (127u + 4) << 6;
// What sums of rounded bounds may lack.
constexpr double kRounding = 1e-5;

bool inside(const PixelWindow& window, int x, int y) {
  return x >= window.left && x < window.right && y >= window.top && y < window.bottom;
}

// `count` samples from (x, y) on, one pixel apart, that border a block: the neighbour's, or traced
// again. Those are not counted, or the counts would depend on which block is finished first.
EdgeSamples::Samples bordering_samples(EdgeSamples::Samples of_neighbour, int count,
                                       const PixelSampler& sampler, double x, double y,
                                       const Vec2& step) {
  if (!of_neighbour.empty()) return of_neighbour;
  EdgeSamples::Samples samples;
  samples.reserve(static_cast<size_t>(count));
  RenderStatistics uncounted;
  for (int i = 0; i < count; ++i) {
    samples.push_back(sampler.sample(x + i * step.x, y + i * step.y, uncounted));
  }
  take_shape_tests();
  return samples;
}

// One sample for each pixel of a row from (x, y) on, neighbours together.
void sample_row(const PixelSampler& sampler, int x, int y, int width, PixelColor* colors,
                RenderStatistics& statistics) {
  constexpr int kTogether = 4;
  for (int first = 0; first < width; first += kTogether) {
    Vec2 places[kTogether];
    const int count = std::min(kTogether, width - first);
    for (int i = 0; i < count; ++i) places[i] = {x + first + i, y};
    sampler.sample_together(places, count, colors + first, statistics);
  }
}

}  // namespace

SampleContrast::SampleContrast(const Scene& scene, const RenderOptions& options)
    : gamma_kind_(scene.settings.gamma_kind),
      decode_exponent_(gamma_kind_ == AssumedGamma::power
                           ? static_cast<float>(scene.settings.assumed_gamma)
                           : 1.0f),
      encode_exponent_(static_cast<float>(1 / options.antialias_gamma)),
      threshold_(options.antialias_threshold) {
  if (options.antialias_gamma <= 0 || std::abs(options.antialias_gamma - 1) <= 0.01) {
    encode_exponent_ = 1;
  }
  for (uint32_t i = kFirstStep; i <= kLastStep; ++i) {
    steps_.push_back(encode(std::bit_cast<float>(i << kStepShift)));
  }
}

float SampleContrast::encode(float value) const {
  if (gamma_kind_ == AssumedGamma::srgb) {
    value = value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
  } else if (decode_exponent_ != 1) {
    value = std::pow(std::max(value, 0.0f), decode_exponent_);
  }
  return encode_exponent_ == 1 ? value : std::pow(std::max(value, 0.0f), encode_exponent_);
}

SampleContrast::Range SampleContrast::encoded_range(float value) const {
  const uint32_t step = std::bit_cast<uint32_t>(value) >> kStepShift;
  // Also negative values and those that are not numbers end here.
  if (step - kFirstStep >= kLastStep - kFirstStep) [[unlikely]] {
    const float exact = encode(value);
    return {exact, exact};
  }
  return {steps_[step - kFirstStep], steps_[step - kFirstStep + 1]};
}

bool SampleContrast::differ(const PixelColor& a, const PixelColor& b) const {
  const double transmit = std::abs(a.transmit - b.transmit);
  if (a.color == b.color) return transmit >= threshold_;
  double least = transmit, most = transmit;
  for (const auto channel : {&RGB::red, &RGB::green, &RGB::blue}) {
    const Range first = encoded_range(a.color.*channel), second = encoded_range(b.color.*channel);
    const float up = second.high - first.low, down = first.high - second.low;
    most += up > down ? up : down;
    const float gap_up = second.low - first.high, gap_down = first.low - second.high;
    const float gap = gap_up > gap_down ? gap_up : gap_down;
    least += gap > 0 ? gap : 0;
  }
  if (least >= threshold_ + kRounding) return true;
  if (most < threshold_ - kRounding) return false;
  return differ_exactly(a, b);
}

bool SampleContrast::differ_exactly(const PixelColor& a, const PixelColor& b) const {
  double difference = std::abs(a.transmit - b.transmit);
  difference += std::abs(encode(a.color.red) - encode(b.color.red));
  difference += std::abs(encode(a.color.green) - encode(b.color.green));
  difference += std::abs(encode(a.color.blue) - encode(b.color.blue));
  return difference >= threshold_;
}

void render_block_without_antialiasing(const PixelSampler& sampler, const PixelWindow& block,
                                       const PixelWindow& window, Framebuffer& framebuffer,
                                       RenderStatistics& statistics) {
  const PixelWindow wanted = intersection(block, window);
  if (wanted.is_empty()) return;
  for (int y = wanted.top; y < wanted.bottom; ++y) {
    sample_row(sampler, wanted.left, y, wanted.width(), &framebuffer.at(wanted.left, y),
               statistics);
  }
}

void render_block_method1(const PixelSampler& sampler, const SampleContrast& contrast,
                          const RenderOptions& options, const PixelWindow& block,
                          const PixelWindow& window, EdgeSamples& edges, Framebuffer& framebuffer,
                          RenderStatistics& statistics) {
  const int width = block.right - block.left + 1;  // with the column to the left
  struct Cell {
    PixelColor color;
    bool supersampled = false;
  };
  std::vector<Cell> above(width), current(width);
  std::vector<PixelColor> row(width - 1);

  const int k = options.antialias_depth;
  const double amplitude = options.jitter_amount / k;
  const double reach = 0.5 - 1.0 / (2 * k);
  auto supersample = [&](int x, int y, Cell& cell) {
    PixelColor sum = cell.color;
    Vec2 places[PixelSampler::kMostTogether];
    PixelColor colors[PixelSampler::kMostTogether];
    int waiting = 0;
    const auto sample = [&] {
      sampler.sample_together(places, waiting, colors, statistics);
      for (int i = 0; i < waiting; ++i) sum = sum + colors[i];
      waiting = 0;
    };
    for (double oy = -reach; oy <= reach + kEpsilon; oy += 1.0 / k) {
      for (double ox = -reach; ox <= reach + kEpsilon; ox += 1.0 / k) {
        double sx = x + ox, sy = y + oy;
        if (amplitude > 0) {
          const Vec2 jitter = sample_jitter(sx, sy);
          sx += amplitude * jitter.x;
          sy += amplitude * jitter.y;
        }
        places[waiting++] = {sx, sy};
        if (waiting == PixelSampler::kMostTogether) sample();
      }
    }
    sample();
    cell.color = divided(sum, static_cast<float>(k * k + 1));
    cell.supersampled = true;
    if (inside(window, x, y)) framebuffer.at(x, y) = cell.color;
  };

  // The column to the left and the row above only serve comparison.
  const EdgeSamples::Samples left =
      bordering_samples(edges.take_left_of(block), block.bottom - block.top, sampler,
                        block.left - 1, block.top, Vec2(0, 1));
  const EdgeSamples::Samples top = bordering_samples(edges.take_above(block), width - 1, sampler,
                                                     block.left, block.top - 1, Vec2(1, 0));
  for (int i = 1; i < width; ++i) above[i] = {top[i - 1], true};
  EdgeSamples::Samples right_edge, lower_edge;
  right_edge.reserve(left.size());
  lower_edge.reserve(top.size());
  for (int y = block.top; y < block.bottom; ++y) {
    current[0] = {left[y - block.top], true};
    sample_row(sampler, block.left, y, width - 1, row.data(), statistics);
    for (int i = 1; i < width; ++i) {
      const int x = block.left + i - 1;
      Cell& cell = current[i];
      cell = {row[i - 1], false};
      if (x == block.right - 1) right_edge.push_back(cell.color);
      if (y == block.bottom - 1) lower_edge.push_back(cell.color);
      if (inside(window, x, y)) framebuffer.at(x, y) = cell.color;
      const bool left_differs = contrast.differ(current[i - 1].color, cell.color);
      const bool top_differs = contrast.differ(above[i].color, cell.color);
      if (left_differs && !current[i - 1].supersampled) supersample(x - 1, y, current[i - 1]);
      if (top_differs && !above[i].supersampled) supersample(x, y - 1, above[i]);
      if (left_differs || top_differs) supersample(x, y, cell);
    }
    std::swap(above, current);
  }
  edges.give(block, std::move(right_edge), std::move(lower_edge));
}

namespace {

// The samples of one pixel for method 2: a grid of (2^depth + 1)^2 places, filled on demand. The
// edges of pixels that were subdivided are kept for the next pixel and for the row below.
class PixelSubdivision {
 public:
  // For pixels from x = `left` to `right` - 1, to be asked for row by row.
  PixelSubdivision(const PixelSampler& sampler, const SampleContrast& contrast,
                   const RenderOptions& options, int left, int right, RenderStatistics& statistics)
      : sampler_(sampler),
        contrast_(contrast),
        statistics_(statistics),
        depth_(options.antialias_depth),
        side_((1 << depth_) + 1),
        left_(left),
        amplitude_(options.jitter_amount / side_),
        color_(static_cast<size_t>(side_) * side_),
        known_(color_.size()),
        edges_(static_cast<size_t>(right - left) + 1, Edge(static_cast<size_t>(side_))) {}

  void start_row() { edges_[0].count = 0; }

  PixelColor pixel(int x, int y, const PixelColor corners[4]) {
    std::fill(known_.begin(), known_.end(), char{0});
    const int last = side_ - 1;
    store(0, 0, corners[0]);
    store(last, 0, corners[1]);
    store(0, last, corners[2]);
    store(last, last, corners[3]);
    Edge &vertical = edges_[0], &horizontal = edges_[static_cast<size_t>(x - left_) + 1];
    for (int i = 0; i < vertical.count; ++i)
      store(0, vertical.samples[i].at, vertical.samples[i].color);
    for (int i = 0; i < horizontal.count; ++i) {
      store(horizontal.samples[i].at, 0, horizontal.samples[i].color);
    }
    const PixelColor color = square(0, 0, last, last, x, y, 0.5, depth_ - 1);
    vertical.count = horizontal.count = 0;
    // Only a subdivided pixel has samples between its corners.
    if (known(last / 2, last / 2)) {
      for (int i = 1; i < last; ++i) {
        if (known(last, i)) vertical.samples[vertical.count++] = {i, get(last, i)};
        if (known(i, last)) horizontal.samples[horizontal.count++] = {i, get(i, last)};
      }
    }
    return color;
  }

 private:
  struct Sample {
    int at;  // along the edge
    PixelColor color;
  };
  struct Edge {
    explicit Edge(size_t most) : samples(most) {}
    std::vector<Sample> samples;
    int count = 0;
  };

  void store(int i, int j, const PixelColor& c) {
    color_[j * side_ + i] = c;
    known_[j * side_ + i] = 1;
  }
  bool known(int i, int j) const { return known_[j * side_ + i]; }
  const PixelColor& get(int i, int j) const { return color_[j * side_ + i]; }
  void ensure(int i, int j, double x, double y) {
    if (known(i, j)) return;
    if (amplitude_ > 0) {
      const Vec2 jitter = sample_jitter(x, y);
      x += amplitude_ * jitter.x;
      y += amplitude_ * jitter.y;
    }
    store(i, j, sampler_.sample(x, y, statistics_));
  }

  PixelColor square(int i0, int j0, int i1, int j1, double x, double y, double d, int level) {
    const PixelColor &a = get(i0, j0), &b = get(i1, j0), &c = get(i0, j1), &e = get(i1, j1);
    if (level > 0 && (contrast_.differ(a, b) || contrast_.differ(a, c) || contrast_.differ(a, e) ||
                      contrast_.differ(b, c) || contrast_.differ(b, e) || contrast_.differ(c, e))) {
      const int im = (i0 + i1) / 2, jm = (j0 + j1) / 2;
      ensure(i0, jm, x - d, y);
      ensure(im, j0, x, y - d);
      ensure(i1, jm, x + d, y);
      ensure(im, j1, x, y + d);
      ensure(im, jm, x, y);
      const double h = d / 2;
      const PixelColor upper_left = square(i0, j0, im, jm, x - h, y - h, h, level - 1);
      const PixelColor lower_left = square(i0, jm, im, j1, x - h, y + h, h, level - 1);
      const PixelColor upper_right = square(im, j0, i1, jm, x + h, y - h, h, level - 1);
      const PixelColor lower_right = square(im, jm, i1, j1, x + h, y + h, h, level - 1);
      return divided(upper_left + lower_left + upper_right + lower_right, 4);
    }
    return divided(a + c + b + e, 4);
  }

  const PixelSampler& sampler_;
  const SampleContrast& contrast_;
  RenderStatistics& statistics_;
  int depth_, side_, left_;
  double amplitude_;
  std::vector<PixelColor> color_;
  std::vector<char> known_;
  std::vector<Edge> edges_;  // the right one of the pixel before, the lower ones of the row above
};

}  // namespace

void render_block_method2(const PixelSampler& sampler, const SampleContrast& contrast,
                          const RenderOptions& options, const PixelWindow& block,
                          const PixelWindow& window, EdgeSamples& edges, Framebuffer& framebuffer,
                          RenderStatistics& statistics) {
  // All corners of the block's pixels first, without jitter.
  const int columns = block.right - block.left + 1, rows = block.bottom - block.top + 1;
  std::vector<PixelColor> corners = bordering_samples(
      edges.take_above(block), columns, sampler, block.left - 0.5, block.top - 0.5, Vec2(1, 0));
  corners.resize(static_cast<size_t>(columns) * rows);
  const EdgeSamples::Samples left = bordering_samples(
      edges.take_left_of(block), rows, sampler, block.left - 0.5, block.top - 0.5, Vec2(0, 1));
  for (int j = 1; j < rows; ++j) {
    corners[j * columns] = left[j];
    for (int i = 1; i < columns; ++i) {
      corners[j * columns + i] =
          sampler.sample(block.left + i - 0.5, block.top + j - 0.5, statistics);
    }
  }
  EdgeSamples::Samples right_edge;
  right_edge.reserve(left.size());
  for (int j = 0; j < rows; ++j) right_edge.push_back(corners[(j + 1) * columns - 1]);
  edges.give(block, std::move(right_edge), {corners.end() - columns, corners.end()});
  PixelSubdivision subdivision(sampler, contrast, options, block.left, block.right, statistics);
  for (int y = block.top; y < block.bottom; ++y) {
    subdivision.start_row();
    for (int x = block.left; x < block.right; ++x) {
      if (!inside(window, x, y)) continue;
      const size_t at = static_cast<size_t>(y - block.top) * columns + (x - block.left);
      const PixelColor pixel_corners[4] = {corners[at], corners[at + 1], corners[at + columns],
                                           corners[at + columns + 1]};
      framebuffer.at(x, y) = subdivision.pixel(x, y, pixel_corners);
    }
  }
}

void render_block_grid(const PixelSampler& sampler, const RenderOptions& options, bool jittered,
                       const PixelWindow& block, const PixelWindow& window,
                       Framebuffer& framebuffer, RenderStatistics& statistics) {
  const int n = options.grid_samples;
  for (int y = std::max(block.top, window.top); y < std::min(block.bottom, window.bottom); ++y) {
    for (int x = std::max(block.left, window.left); x < std::min(block.right, window.right);
         ++x) {
      PixelColor sum;
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          double sx = x - 0.5 + (i + 0.5) / n, sy = y - 0.5 + (j + 0.5) / n;
          if (jittered) {
            const Vec2 jitter = sample_jitter(sx, sy);
            sx += jitter.x / n;
            sy += jitter.y / n;
          }
          sum = sum + sampler.sample(sx, sy, statistics);
        }
      }
      framebuffer.at(x, y) = divided(sum, static_cast<float>(n * n));
    }
  }
}

}  // namespace durer
