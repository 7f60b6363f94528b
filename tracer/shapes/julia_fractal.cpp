// julia_fractal { <c> [quaternion|hypercomplex] [function] [max_iteration n] [precision p] [slice
// <s>, d] }
//                                                                    (spec/geometry.md 12.15)
//
// The points of a three-dimensional slice of the fourfold space whose orbits z -> f(z) + c stay
// near the origin. A ray goes in steps of an estimated distance, at least 1 / precision, until it
// finds itself on the other side, and then halves its way back.
#include <algorithm>
#include <bit>
#include <vector>

#include "tracer/shapes/quaternion_walk.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kLeastDistance = 1e-8;
constexpr double kLongestStride = 30;  // in units of the precision

// The orbit that this thread followed last. Where it has left before `count` points, the rest is of
// orbits before it: POV-Ray makes the normals of the complex functions of such mixtures.
Vec4* remembered_orbit(size_t count) {
  thread_local std::vector<Vec4> orbit;
  if (orbit.size() < count) orbit.resize(count);
  return orbit.data();
}

template <typename Map>
class JuliaFractal final : public Shape {
 public:
  JuliaFractal(const JuliaFractalNode& node, const Map& map)
      : map_(map),
        slice_{node.slice / std::sqrt(glm::dot(node.slice, node.slice)), node.slice_distance,
               node.max_iteration, 16},
        iterations_(node.max_iteration),
        precision_(1 / node.precision) {
    const double size = std::sqrt(glm::dot(node.parameter, node.parameter));
    radius_ = Map::kQuaternion ? std::min(2.0, 1 + size + 1e-7) : 4;
    if (Map::kQuaternion) slice_.escape2 = radius_ * radius_ + 1e-7;
  }

  Bounds bounds() const override { return placed_.bounds({Vec3(-radius_), Vec3(radius_)}); }
  bool is_solid_within_bounds() const override { return !inverted_; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const LocalRay local = local_ray(ray);
    double t, end;
    if (!cross_sphere(local, t, end)) return;
    t = std::max(t, kLeastJuliaStep);
    // The point is moved on step by step, as in POV-Ray: orbits blow up its last digits.
    Vec3 point = local.at(t);
    double distance;
    bool was_inside = march(point, local.direction, distance);
    if (was_inside) {
      t += 2 * kLeastJuliaStep;
      point += 2 * kLeastJuliaStep * local.direction;
      was_inside = march(point, local.direction, distance);
    }
    for (;;) {
      if constexpr (Map::kQuaternion) {
        const QuaternionWalk walk{local.direction, end, precision_, point, t, distance};
        const bool comes_to_border =
            was_inside ? cross_set(map_, slice_, walk) : approach_set(map_, slice_, walk);
        if (!comes_to_border) return;
      }
      const double step = std::max(distance, precision_);
      t += step;
      if (!(t < end)) return;
      const Vec3 before = point;
      point += step * local.direction;
      const bool is_inside = march(point, local.direction, distance);
      if (is_inside == was_inside) continue;
      push(border({before, t - step}, step, local.direction, was_inside), local, out);
      if (!ray.csg_child) return;
      was_inside = is_inside;
    }
  }

  bool places_hits() const override { return !Map::kMixesUpStart; }
  Vec3 place(const ShapeRay& ray, const ShapeHit& hit) const override {
    const LocalRay local = local_ray(ray);
    const Vec3 offset(hit.u, hit.v, std::bit_cast<float>(hit.part));
    return placed_.point(local.at(hit.t / local.scale) + offset);
  }

  bool inside(const Vec3& world_point) const override {
    return is_in_set(placed_.inverse_point(world_point)) != inverted_;
  }

  Vec3 normal(const Vec3& world_point, const ShapeHit& hit) const override {
    if constexpr (Map::kMixesUpStart) {
      const double third = 1 - std::abs(hit.u) - std::abs(hit.v);
      return placed_.normal({hit.u, hit.v, hit.part ? -third : third});
    }
    if constexpr (Map::kQuaternion) {
      Vec4 z = slice_.start(placed_.inverse_point(world_point));
      Vec4 v[3] = {Vec4(1, 0, 0, 0), Vec4(0, 1, 0, 0), Vec4(0, 0, 1, 0)};
      for (int k = 0; k < iterations_; ++k) {
        for (Vec4& tangent : v) tangent = Map::carry(z, tangent);
        z = map_(z);
      }
      return placed_.normal({dot_in_order(v[0], z), dot_in_order(v[1], z), dot_in_order(v[2], z)});
    } else {
      typename Map::Number z(slice_.start(placed_.inverse_point(world_point)));
      typename Map::Number q(Vec4(1, 0, 0, 0));
      for (int k = 0; k < iterations_; ++k) {
        const auto factor = map_.factor_of_step(z, k);
        q = k == 0 ? factor : product(q, factor);
      }
      return placed_.normal(gradient(as_vector(q), as_vector(z)));
    }
  }

  // Takes all transforms: each of them undoes `inverse`, as in POV-Ray.
  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    auto moved = std::make_shared<JuliaFractal>(*this);
    moved->placed_ = placed_.then(transform);
    moved->is_moved_ = is_moved_ || !transform.is_identity();
    moved->inverted_ = false;
    return moved;
  }
  std::shared_ptr<const Shape> inverted() const override {
    auto turned = std::make_shared<JuliaFractal>(*this);
    turned->inverted_ = !inverted_;
    return turned;
  }
  bool takes_inverse_mark() const override { return false; }

 private:
  // In the fractal's own space, with the direction brought to length 1 where it is not.
  struct LocalRay : Ray {
    double scale;  // from depths along it to those of the ray
  };

  LocalRay local_ray(const ShapeRay& ray) const {
    const Vec3 direction = placed_.inverse_direction(ray.direction);
    const double scale = is_moved_ ? 1 / length(direction) : 1;
    return {{placed_.inverse_point(ray.origin), direction * scale}, scale};
  }

  bool cross_sphere(const Ray& ray, double& enter, double& leave) const {
    const double squared = dot(ray.origin, ray.origin), along = -dot(ray.origin, ray.direction);
    if (squared >= radius_ * radius_ && along < kGeometryEpsilon) return false;
    const double half2 = radius_ * radius_ - squared + along * along;
    if (!(half2 > kGeometryEpsilon)) return false;
    const double half = std::sqrt(half2);
    enter = along - half;
    leave = along + half;
    return true;
  }

  bool is_in_set(const Vec3& p) const {
    Vec4* orbit = nullptr;
    if constexpr (Map::kMixesUpStart) orbit = remembered_orbit(iterations_ + 1);
    typename Map::Number z(slice_.start(Map::kMixesUpStart ? Vec3(p.x, p.y, p.y) : p));
    remember(orbit, 0, z);
    for (int i = 0; i < iterations_; ++i) {
      if (Map::squared_size(z) > slice_.escape2) return false;
      z = map_(z);
      remember(orbit, i + 1, z);
    }
    return true;
  }

  static void remember([[maybe_unused]] Vec4* orbit, [[maybe_unused]] int i,
                       [[maybe_unused]] const typename Map::Number& z) {
    if constexpr (Map::kMixesUpStart) orbit[i] = z;
  }

  // With how far the walk has come off the straight line by rounding. Of complex functions, with the
  // normal, which depends on the points that the ray has tried: the first two of its components, their
  // absolute values adding up to 1, and the third one's sign.
  void push(const JuliaPlace& place, const LocalRay& ray, HitStack& out) const {
    const double t = place.t * ray.scale;
    if constexpr (Map::kMixesUpStart) {
      is_in_set(place.point);
      const Vec4* orbit = remembered_orbit(iterations_ + 1);
      Vec4 q = map_.factor(orbit[0], 0);
      for (int k = 1; k < iterations_; ++k) {
        q = hypercomplex_product(q, map_.factor(orbit[k], k));
      }
      const Vec3 n = gradient(q, orbit[iterations_]);
      const double size = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
      out.push(t, n.z < 0, static_cast<float>(n.x / size), static_cast<float>(n.y / size));
    } else {
      const glm::vec3 offset(place.point - ray.at(t / ray.scale));
      out.push(t, std::bit_cast<uint32_t>(offset.z), offset.x, offset.y);
    }
  }

  static Vec3 gradient(const Vec4& q, const Vec4& z) {
    return {q.x * z.x + q.y * z.y + q.z * z.z + q.w * z.w,
            -q.y * z.x + q.x * z.y - q.w * z.z + q.z * z.w,
            -q.z * z.x - q.w * z.y + q.x * z.z + q.y * z.w};
  }

  // Whether a point is in the set, and how far the set is along the ray.
  bool march(const Vec3& point, const Vec3& direction, double& distance) const {
    distance = precision_;
    if constexpr (Map::kQuaternion) {
      return look_for_set(map_, slice_, point, distance);
    } else {
      typename Map::Number z(slice_.start(point));
      Vec4* orbit = nullptr;
      if constexpr (Map::kMixesUpStart) orbit = remembered_orbit(iterations_ + 1);
      remember(orbit, 0, z);
      typename Map::Number q = z;  // the first factor, which counts even where no step is taken
      for (int i = 0; i < iterations_; ++i) {
        const double size2 = Map::squared_size(z);
        if (size2 > slice_.escape2) {
          const double slope =
              Map::scale(i) * dot(gradient(as_vector(q), as_vector(z)), direction);
          if (slope >= -kLeastDistance) return false;
          const double steepness = -2 * slope, shortest = precision_ * steepness;
          if (size2 > shortest && size2 < kLongestStride * shortest) distance = size2 / steepness;
          return false;
        }
        const auto factor = map_.factor_of_step(z, i);
        if (i > 0) q = product(q, factor);
        remember(orbit, i + 1, z);
      }
      return true;
    }
  }

  // Where the ray crosses the border within a step from a place on.
  JuliaPlace border(JuliaPlace place, double step, const Vec3& direction, bool was_inside) const {
    if constexpr (Map::kQuaternion)
      return find_border(map_, slice_, place, step, direction, was_inside);
    do {
      step *= 0.5;
      const Vec3 middle = place.point + step * direction;
      if (is_in_set(middle) == was_inside) place = {middle, place.t + step};
    } while (step > kLeastJuliaStep);
    // On the inner side.
    return was_inside ? place : JuliaPlace{place.point + step * direction, place.t + step};
  }

  Map map_;
  JuliaSlice slice_;
  int iterations_;
  double precision_;  // the shortest step
  double radius_;
  bool inverted_ = false;
  bool is_moved_ = false;  // else directions are of unit length, to the last bit
  Transform placed_;
};

template <typename Map>
PlacedShape place(const JuliaFractalNode& node, const Map& map) {
  return {std::make_shared<JuliaFractal<Map>>(node, map), false, {}};
}

}  // namespace

PlacedShape compile(const JuliaFractalNode& node, const ShapeContext&) {
  using F = JuliaFractalNode::Function;
  const Vec4& c = node.parameter;
  if (node.algebra == JuliaFractalNode::Algebra::quaternion)
    return node.function == F::cube ? place(node, QuaternionCube{c})
                                    : place(node, QuaternionSquare{c});
  switch (node.function) {
    case F::sqr:
      return place(node, HypercomplexSquare{c});
    case F::cube:
      return place(node, HypercomplexCube{{c}});
    case F::reciprocal:
      return place(node, HypercomplexReciprocal{c});
    default:
      return place(node, HypercomplexFunction{c, complex_function(node.function), node.power});
  }
}

}  // namespace durer
