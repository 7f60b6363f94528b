#include "tracer/shapes/shape.h"

namespace durer {

Vec2 Shape::uv(const Vec3&, const Vec3& world_point, const ShapeHit&) const {
  return {world_point.x, world_point.y};
}

bool Shape::closest(const ShapeRay& ray, HitStack& scratch, ShapeHit& hit) const {
  const size_t base = scratch.size();
  hits(ray, scratch);
  bool found = false;
  double best = ray.t_max;
  // The stack is popped: of equal depths the one pushed last wins.
  for (size_t i = scratch.size(); i-- > base;) {
    const ShapeHit& candidate = scratch[i];
    if (candidate.t < best && candidate.t >= kLeastHitDepth) {
      best = candidate.t;
      hit = candidate;
      found = true;
    }
  }
  scratch.shrink(base);
  return found;
}

std::shared_ptr<const Shape> Shape::transformed(const Transform&) const { return nullptr; }
Vec3 Shape::place(const ShapeRay& ray, const ShapeHit& hit) const {
  return ray.origin + hit.t * ray.direction;
}
std::shared_ptr<const Shape> Shape::inverted() const { return nullptr; }

int Shape::texture_shares(const Vec3&, const ShapeHit&, ShapeTexture* shares, int) const {
  shares[0] = {-1, 1.0f};
  return 1;
}

}  // namespace durer
