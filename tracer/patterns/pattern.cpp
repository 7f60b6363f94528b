#include "tracer/patterns/pattern.h"

#include <cmath>
#include <limits>

#include "tracer/patterns/noise.h"
#include "tracer/patterns/wave_sources.h"
#include "tracer/scene/not_supported.h"

namespace durer {
namespace {

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
      displaces_(node.has_turbulence && !uses_turbulence_itself(node.kind) &&
                 node.turbulence.strength != Vec3(0)) {
  const PatternFactory factory = find_pattern_factory(node.kind);
  if (!factory) {
    throw NotSupported(std::string("the pattern '") + pattern_name(node.kind) + "'",
                       node.position);
  }
  base_ = factory(node, settings);
}

Vec3 Pattern::warp_point(const Vec3& p) const {
  Vec3 q = node_.warps.empty() ? p : apply_warps(node_.warps, p);
  if (displaces_) {
    const Turbulence& t = node_.turbulence;
    q += t.strength * vector_turbulence(q, t.octaves, t.omega, t.lambda);
  }
  return q;
}

double Pattern::value_at_warped(const Vec3& warped, const PatternContext& context) const {
  double v = base_->base_value(warped, context);
  if (node_.frequency != 0) v = std::fmod(v * node_.frequency + node_.phase, 1.00001);
  if (v < 0) v -= std::floor(v);
  apply_waves(v);
  return v;
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
      v = std::pow(v, static_cast<double>(node_.wave_exponent));
      break;
  }
}

}  // namespace durer
