// slope, aoi: how steep a surface is, how frontally it is seen.
//
//   slope V
//   slope { [point_at] V [, lo, hi] [altitude A [, alo, ahi]] }
//   aoi
//
//   pigment { slope y color_map { [0.5 rgb <.4,.3,.2>] [0.9 rgb 1] } }
//
// They see the normal as perturbed so far; without a surface they are 0 (functions, media, sky).
// Source: spec/textures.md 6.5, 6.6.
#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

double stretched(double v, double low, double high) {
  return high - low != 0 ? (v - low) / (high - low) : v;
}

// Folds into [0,1); 1 itself, within rounding when `slack` is not 0, stays just below.
double folded(double v, double slack) {
  if (v >= 1 && v <= 1 + slack) return v - kEpsilon;
  v = std::fmod(v, 1.0);
  return v < 0 ? v + 1 : v;
}

class Slope : public BasePattern {
 public:
  explicit Slope(const SlopeParameters& s)
      : s_(s), direction_(unit_or_zero(s.direction)), up_(unit_or_zero(s.altitude)) {
    const double slope_length = length(s.direction), altitude_length = length(s.altitude);
    // povray keeps the sum in single precision; so a slope alone does not weigh 1, and where it is
    // steepest it may reach 1 or not.
    const auto sum = static_cast<float>(slope_length + altitude_length);
    if (s.has_altitude || !s.is_point) weight_ = slope_length / static_cast<double>(sum);
  }
  double base_value(const Vec3& p, const PatternContext& context) const override {
    if (!context.has_surface) return 0;
    const Vec3 direction = s_.is_point ? unit_or_zero(s_.direction - context.world_point)
                                       : direction_;
    const double t = std::clamp(dot(context.normal, direction), -1.0, 1.0);
    double v = (std::asin(t) * 2 / M_PI + 1) / 2;
    v = stretched(v, s_.low_slope, s_.high_slope);
    if (!s_.has_altitude) return folded(weight_ * v, 0);
    const double height = stretched(dot(p, up_), s_.low_altitude, s_.high_altitude);
    v = weight_ * v + (1 - weight_) * height;
    return folded(v, kEpsilon);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  SlopeParameters s_;
  Vec3 direction_, up_;
  double weight_ = 1;  // of the slope against the altitude
};

class AngleOfIncidence : public BasePattern {
 public:
  double base_value(const Vec3&, const PatternContext& context) const override {
    if (!context.has_surface) return 0;
    const double cosine =
        dot(unit_or_zero(context.normal), unit_or_zero(context.ray_direction));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) / M_PI;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

}  // namespace

std::unique_ptr<const BasePattern> make_slope(const PatternNode& node, const PatternSettings&) {
  return std::make_unique<Slope>(node.slope);
}
std::unique_ptr<const BasePattern> make_aoi(const PatternNode&, const PatternSettings&) {
  return std::make_unique<AngleOfIncidence>();
}

}  // namespace durer
