// Perturbed normals (spec/textures.md 14).
#include <cmath>
#include <optional>

#include "tracer/image/image.h"
#include "tracer/patterns/facets.h"
#include "tracer/patterns/noise.h"
#include "tracer/patterns/quilt.h"
#include "tracer/patterns/wave_sources.h"
#include "tracer/texture/blend_map.h"
#include "tracer/texture/normal_frame.h"
#include "tracer/texture/surface_texture.h"
#include "tracer/texture/warp_chain.h"

namespace durer {
namespace {

// How a pattern bends a normal at a point of its own space.
class Bump {
 public:
  virtual ~Bump() = default;
  virtual Vec3 bend(const Vec3& q, const Vec3& n, const TextureContext& context) const = 0;
};

class VectorNoiseBump : public Bump {
 public:
  explicit VectorNoiseBump(double amount) : amount_(amount) {}
  Vec3 bend(const Vec3& q, const Vec3& n, const TextureContext&) const override {
    return n + amount_ * vector_noise(q);
  }

 private:
  double amount_;
};

class DentsBump : public Bump {
 public:
  DentsBump(double amount, int generator) : amount_(amount), generator_(generator) {}
  Vec3 bend(const Vec3& q, const Vec3& n, const TextureContext&) const override {
    const double v = noise(q, generator_);
    return n + (amount_ * v * v * v) * vector_noise(q);
  }

 private:
  double amount_;
  int generator_;
};

class WrinklesBump : public Bump {
 public:
  explicit WrinklesBump(double amount) : amount_(amount) {}
  Vec3 bend(const Vec3& q, const Vec3& n, const TextureContext&) const override {
    return n + amount_ * vector_wrinkles(q);
  }

 private:
  double amount_;
};

class WaterBump : public Bump {
 public:
  WaterBump(const NormalNode& node, int sources, bool waves)
      : sources_(wave_sources(sources)),
        amount_(node.bump_size),
        frequency_(node.pattern->frequency),
        phase_(node.pattern->phase),
        waves_(waves) {}
  Vec3 bend(const Vec3& q, const Vec3& n, const TextureContext&) const override {
    Vec3 result = n;
    const double count = static_cast<double>(sources_.size());
    for (const WaveSource& source : sources_) {
      const Vec3 away = q - source.center;
      double distance = length(away);
      if (distance == 0) distance = 1;
      const double rate = waves_ ? source.frequency : 1;
      const double height = (amount_ / rate) * cycle(distance * frequency_ * rate + phase_);
      result += height / (distance * count) * away;
    }
    return result;
  }

 private:
  std::vector<WaveSource> sources_;
  double amount_, frequency_, phase_;
  bool waves_;
};

class QuiltedBump : public Bump {
 public:
  explicit QuiltedBump(const NormalNode& node)
      : amount_(node.bump_size),
        control0_(node.pattern->quilt_control0),
        control1_(node.pattern->quilt_control1) {}
  Vec3 bend(const Vec3& q, const Vec3& n, const TextureContext&) const override {
    return n + amount_ * quilt(q, control0_, control1_);
  }

 private:
  double amount_, control0_, control1_;
};

// Any pattern as a height field, by four samples on a tetrahedron (14.4).
class HeightBump : public Bump {
 public:
  HeightBump(const NormalNode& node, const Pattern& pattern)
      : pattern_(pattern),
        amount_(node.bump_size),
        accuracy_(node.accuracy),
        slope_map_(node.slope_map) {
    if (slope_map_) slope_positions_.emplace(slope_map_->entries);
  }

  Vec3 bend(const Vec3& q, const Vec3& n, const TextureContext& context) const override {
    static constexpr double kDirections[4][3] = {{0.942809041, -0.333333333, 0},
                                                 {-0.471404521, -0.333333333, 0.816496581},
                                                 {-0.471404521, -0.333333333, -0.816496581},
                                                 {0, 1, 0}};
    Vec3 result = n;
    const double scale = amount_ * -5.0 * (0.02 / accuracy_);
    const auto direction = [](int i) {
      return Vec3(kDirections[i][0], kDirections[i][1], kDirections[i][2]);
    };
    Vec3 points[4];
    double values[4];
    for (int i = 0; i < 4; ++i) points[i] = q + accuracy_ * direction(i);
    pattern_.values_at_warped(points, context, values);
    for (int i = 0; i < 4; ++i) result += (height(values[i]) * scale) * direction(i);
    return result;
  }

 private:
  // Hermite cubics between the entries of a slope_map.
  double height(double value) const {
    if (!slope_map_) return value;
    const auto& entries = slope_map_->entries;
    const MapPlace place = slope_positions_->find(value);
    const SlopeAt& low = entries[place.lower].item;
    if (place.lower == place.upper) return low.height;
    const SlopeAt& high = entries[place.upper].item;
    const double t = place.share;
    const double h1 = low.height, h2 = high.height, s1 = low.slope, s2 = high.slope;
    return ((s1 + s2 + 2 * (h1 - h2)) * t - (2 * s1 + s2 + 3 * (h1 - h2))) * t * t + s1 * t + h1;
  }

  const Pattern& pattern_;
  double amount_, accuracy_;
  std::shared_ptr<const SlopeMap> slope_map_;
  std::optional<MapPositions> slope_positions_;
};

class FacetsBump : public Bump {
 public:
  explicit FacetsBump(const FacetsParameters& facets) : facets_(facets) {}
  Vec3 bend(const Vec3& q, const Vec3& n, const TextureContext&) const override {
    return facets_normal(facets_, q, n);
  }

 private:
  FacetsParameters facets_;
};

std::unique_ptr<const Bump> make_bump(const NormalNode& node, const Pattern& pattern,
                                      const PatternSettings& settings) {
  const int generator =
      node.pattern->noise_generator ? node.pattern->noise_generator : settings.noise_generator;
  switch (node.pattern->kind) {
    case PatternKind::bumps:
      return std::make_unique<VectorNoiseBump>(node.bump_size);
    case PatternKind::dents:
      return std::make_unique<DentsBump>(node.bump_size, generator);
    case PatternKind::ripples:
    case PatternKind::waves:
      return std::make_unique<WaterBump>(node, settings.number_of_waves,
                                         node.pattern->kind == PatternKind::waves);
    case PatternKind::wrinkles:
      return std::make_unique<WrinklesBump>(node.bump_size);
    case PatternKind::quilted:
      return std::make_unique<QuiltedBump>(node);
    case PatternKind::facets:
      return std::make_unique<FacetsBump>(node.pattern->facets);
    default:
      return std::make_unique<HeightBump>(node, pattern);
  }
}

class PatternNormal : public CompiledNormal {
 public:
  PatternNormal(const NormalNode& node, const TextureSettings& settings)
      : pattern_(node.pattern, settings.patterns),
        frame_(node.pattern->warps, settings.no_bump_scale),
        bump_(make_bump(node, pattern_, settings.patterns)) {}

  Vec3 perturb(const Vec3& point, const TextureContext& context,
               const Vec3& normal) const override {
    const Vec3 bent =
        bump_->bend(pattern_.warp_point(point), frame_.inwards(normal), context);
    return frame_.outwards(bent);
  }

 private:
  Pattern pattern_;
  NormalFrame frame_;
  std::unique_ptr<const Bump> bump_;
};

using NormalEntry = MapEntry<std::shared_ptr<const CompiledNormal>>;

std::vector<NormalEntry> compile_entries(const NormalMap& map, const TextureSettings& settings) {
  std::vector<NormalEntry> entries;
  for (const auto& entry : map.entries) {
    entries.push_back({entry.position, compile_normal(*entry.item, settings)});
  }
  return entries;
}

class MappedNormal : public CompiledNormal {
 public:
  MappedNormal(const NormalNode& node, const TextureSettings& settings)
      : pattern_(node.pattern, settings.patterns),
        frame_(node.pattern->warps, settings.no_bump_scale),
        entries_(compile_entries(*node.normal_map, settings)),
        positions_(entries_) {}

  Vec3 perturb(const Vec3& point, const TextureContext& context,
               const Vec3& normal) const override {
    const Vec3 q = pattern_.warp_point(point);
    const Vec3 n = frame_.inwards(normal);
    const MapPlace place = positions_.find(pattern_.value_at_warped(q, context));
    Vec3 bent = entries_[place.lower].item->perturb(q, context, n);
    if (place.lower != place.upper) {
      const Vec3 upper = entries_[place.upper].item->perturb(q, context, n);
      bent = (1 - place.share) * bent + place.share * upper;
    }
    return unit_or_zero(frame_.outwards(bent));
  }

 private:
  Pattern pattern_;
  NormalFrame frame_;
  std::vector<NormalEntry> entries_;
  MapPositions positions_;
};

class AverageNormal : public CompiledNormal {
 public:
  AverageNormal(const NormalNode& node, const TextureSettings& settings)
      : warps_(chain_with_slot(node.pattern)),
        frame_(node.pattern->warps, settings.no_bump_scale),
        entries_(compile_entries(*node.normal_map, settings)) {}

  Vec3 perturb(const Vec3& point, const TextureContext& context,
               const Vec3& normal) const override {
    const Vec3 q = apply_warps(warps_, point);
    const Vec3 n = frame_.inwards(normal);
    Vec3 sum(0);
    double weights = 0;
    for (const NormalEntry& entry : entries_) {
      const double weight = entry.position;
      sum += weight * entry.item->perturb(q, context, n);
      weights += weight;
    }
    return frame_.outwards(sum * (1 / weights));
  }

 private:
  std::vector<Warp> warps_;
  NormalFrame frame_;
  std::vector<NormalEntry> entries_;
};

// Slopes of a picture's brightness (14.3).
class BumpMapNormal : public CompiledNormal {
 public:
  BumpMapNormal(const NormalNode& node, const TextureSettings& settings)
      : warps_(chain_with_slot(node.pattern)),
        frame_(node.pattern->warps, settings.no_bump_scale),
        sampler_(settings.patterns.images->get(*node.pattern->image, ImageUse::raw),
                 *node.pattern->image),
        amount_(static_cast<double>(node.bump_size)),
        use_index_(node.pattern->image->use_index) {}

  Vec3 perturb(const Vec3& point, const TextureContext&, const Vec3& normal) const override {
    double x, y;
    if (!sampler_.locate(apply_warps(warps_, point), x, y)) return normal;
    const double width = sampler_.image().width(), height = sampler_.image().height();
    const double left = x - 1 < 0 ? x - 1 + width : x - 1;
    const double right = x + 1 >= width ? x + 1 - width : x + 1;
    const double below = y + 1 >= height ? y + 1 - height : y + 1;
    Vec3 heights = use_index_ ? indices(x, y, left, right, below) : Vec3(-1);
    // -1: an image without a palette. Then none of the three counts.
    if (heights.x == -1 || heights.y == -1 || heights.z == -1)
      heights = {grey(x, y), grey(left, below), grey(right, below)};
    const Vec3 b =
        unit_or_zero(cross(Vec3(2, amount_ * (heights.z - heights.y), 0),
                           Vec3(1, amount_ * (heights.x - heights.y), -1)));
    const Vec3 n = frame_.inwards(normal);
    Vec3 up = n, side = cross(n, Vec3(0, 1, 0));
    if (length(side) < 1e-10) {
      // POV-Ray takes a normal of another length, after no_bump_scale, for one that points down.
      side = {1, 0, 0};
      up = {0, std::abs(n.y - 1) < 1e-10 ? 1.0 : -1.0, 0};
    } else {
      side = unit_or_zero(side);
    }
    const Vec3 depth = unit_or_zero(cross(side, up));
    return frame_.outwards(b.x * side + b.y * up - b.z * depth);
  }

 private:
  Vec3 indices(double x, double y, double left, double right, double below) const {
    return {sampler_.index(x, y), sampler_.index(left, below), sampler_.index(right, below)};
  }
  double grey(double x, double y) const {
    return static_cast<double>(sampler_.color(x, y).rgb().grey());
  }

  std::vector<Warp> warps_;
  NormalFrame frame_;
  ImageSampler sampler_;
  double amount_;
  bool use_index_;
};

class UvNormal : public CompiledNormal {
 public:
  explicit UvNormal(std::shared_ptr<const CompiledNormal> inner) : inner_(std::move(inner)) {}
  Vec3 perturb(const Vec3&, const TextureContext& context, const Vec3& normal) const override {
    return unit_or_zero(inner_->perturb({context.uv.x, context.uv.y, 0}, context, normal));
  }

 private:
  std::shared_ptr<const CompiledNormal> inner_;
};

}  // namespace

std::unique_ptr<const CompiledNormal> compile_normal(const NormalNode& node,
                                                     const TextureSettings& outer) {
  TextureSettings settings = outer;
  settings.no_bump_scale = outer.no_bump_scale || node.no_bump_scale;
  switch (node.pattern->kind) {
    case PatternKind::uv_mapping:
      return std::make_unique<UvNormal>(compile_normal(*node.normal_map->entries.front().item, settings));
    case PatternKind::average:
      return std::make_unique<AverageNormal>(node, settings);
    case PatternKind::bump_map:
      return std::make_unique<BumpMapNormal>(node, settings);
    default:
      if (node.normal_map) return std::make_unique<MappedNormal>(node, settings);
      return std::make_unique<PatternNormal>(node, settings);
  }
}

}  // namespace durer
