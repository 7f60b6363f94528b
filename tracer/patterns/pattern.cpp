#include "tracer/patterns/pattern.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "tracer/math/power.h"
#include "tracer/patterns/noise.h"
#include "tracer/patterns/wave_sources.h"

namespace durer {
namespace {

// Not 1: a value of 1 stays 1.
constexpr double kFold = 1.00001;
constexpr double kFoldHigh = static_cast<double>(static_cast<float>(kFold));
constexpr double kFoldLow = kFold - kFoldHigh;

// std::fmod(v, kFold) to the last bit, several times faster for what lies within a million periods:
// their products with either part of kFold have no more than 53 bits, and so has each difference.
double folded(double v) {
  if (v >= 0 && v < kFold) return v;
  const double size = std::abs(v);
  if (size < 1 << 20) {
    const double periods = static_cast<int>(size * (1 / kFold));
    const double rest = (size - periods * kFoldHigh) - periods * kFoldLow;
    if (rest >= 0 && rest < kFold) return std::copysign(rest, v);
  }
  return std::fmod(v, kFold);
}

// These use the slot in their own formula instead (spec/textures.md 3.1).
bool uses_turbulence_itself(PatternKind kind) {
  return kind == PatternKind::marble || kind == PatternKind::wood;
}

}  // namespace

ValueRange BasePattern::base_range(const Bounds&) const {
  const double infinity = std::numeric_limits<double>::infinity();
  return {-infinity, infinity};
}

Pattern::Pattern(const PatternNode& node, const PatternSettings& settings)
    : node_(node),
      only_warp_(node_.warps.size() == 1 ? std::get_if<Transform>(&node_.warps[0]) : nullptr),
      displaces_(node.has_turbulence && !uses_turbulence_itself(node.kind) &&
                 node.turbulence.strength != Vec3(0)) {
  const PatternFactory factory = find_pattern_factory(node.kind);
  if (!factory) {
    throw std::logic_error(std::string(pattern_name(node.kind)) + " has no value of its own");
  }
  base_ = factory(node, settings);
}

Vec3 Pattern::warp_point(const Vec3& p) const {
  Vec3 q = only_warp_            ? kept_near(only_warp_->inverse_point(p))
           : node_.warps.empty() ? p
                                 : apply_warps(node_.warps, p);
  if (displaces_) [[unlikely]] {
    const Turbulence& t = node_.turbulence;
    q += t.strength * vector_turbulence(q, t.octaves, t.omega, t.lambda);
  }
  return q;
}

double Pattern::value_at_warped(const Vec3& warped, const PatternContext& context) const {
  return finished(base_->base_value(warped, context));
}

void Pattern::values_at_warped(const Vec3 warped[4], const PatternContext& context,
                               double out[4]) const {
  base_->base_values(warped, context, out);
  for (int i = 0; i < 4; ++i) out[i] = finished(out[i]);
}

double Pattern::finished(double v) const {
  if (node_.frequency != 0) v = folded(v * node_.frequency + node_.phase);
  if (v < 0) v -= std::floor(v);
  apply_waves(v);
  return v;
}

// The box that the pattern sees. Other warps than transforms may take a point anywhere.
Bounds Pattern::warped_bounds(Bounds box) const {
  if (displaces_) return Bounds::everything();
  for (auto it = node_.warps.rbegin(); it != node_.warps.rend(); ++it) {
    const auto* transform = std::get_if<Transform>(&*it);
    if (!transform || !box.is_bounded()) return Bounds::everything();
    box = transform->inverted().bounds(box);
  }
  return box;
}

void Pattern::values(const Vec3 points[8], double out[8]) const {
  const PatternContext nowhere;
  for (int i = 0; i < 8; ++i) out[i] = value_at_warped(warp_point(points[i]), nowhere);
}

ValueRange Pattern::range(const Bounds& box) const {
  ValueRange range = base_->base_range(warped_bounds(box));
  if (node_.frequency != 0) {
    const double frequency = node_.frequency, phase = node_.phase;
    const double a = range.lower * frequency + phase, b = range.upper * frequency + phase;
    range = {std::min(a, b), std::max(a, b)};
    // fmod folds what lies beyond; it keeps the sign.
    if (!(range.lower > -kFold && range.upper < kFold))
      range = {range.lower < 0 ? -kFold : 0.0, range.upper > 0 ? kFold : 0.0};
  }
  // Negative values wrap into [0,1).
  if (range.lower < 0) range = {0, std::max(range.upper, 1.0)};
  return range_of_waves(range);
}

// Of a range that starts at 0 or above.
ValueRange Pattern::range_of_waves(ValueRange range) const {
  switch (node_.wave) {
    case WaveKind::ramp:
      return range;
    case WaveKind::sine:
    case WaveKind::triangle:
    case WaveKind::scallop:
      return {0, 1};
    case WaveKind::cubic: {
      // Grows up to 1, falls from there on.
      const auto cubic = [](double v) { return v * v * (3 - 2 * v); };
      const double a = cubic(range.lower), b = cubic(range.upper);
      const bool has_top = range.lower <= 1 && range.upper >= 1;
      return {std::min(a, b), has_top ? 1.0 : std::max(a, b)};
    }
    case WaveKind::poly: {
      const double exponent = node_.wave_exponent;
      const double a = std::pow(range.lower, exponent), b = std::pow(range.upper, exponent);
      return {std::min(a, b), std::max(a, b)};
    }
  }
  return range;
}

void Pattern::apply_waves(double& v) const {
  switch (node_.wave) {
    case WaveKind::ramp:
      break;
    case WaveKind::sine:
      v = (1 + cycle(v)) / 2;
      break;
    case WaveKind::triangle: {
      const double f = v - std::floor(v);
      v = f < 0.5 ? 2 * f : 2 * (1 - f);
      break;
    }
    case WaveKind::scallop:
      v = std::abs(cycle(v / 2));
      break;
    case WaveKind::cubic:
      v = v * v * (3 - 2 * v);
      break;
    case WaveKind::poly:
      v = power(v, static_cast<double>(node_.wave_exponent));
      break;
  }
}

}  // namespace durer
