#include "tracer/shading/direct_light.h"

#include <cmath>

#include "tracer/math/power.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

bool is_dark(const RGB& c, double limit = kEpsilon) {
  // What is not a number is dark, too.
  return !(std::abs(c.red) >= limit || std::abs(c.green) >= limit || std::abs(c.blue) >= limit);
}

// Filters of all layers multiply; `caustics` brightens where the light crosses head-on.
RGB texture_transmittance(const ShadingScene& scene, const CompiledTexture& texture,
                          const Vec3& point, const TextureContext& context, double caustics,
                          EnclosingFrames& frames) {
  if (texture.selector) {
    WeightedTexture children[TextureSelector::kMostTextures];
    Vec3 child_point;
    const int count = texture.selector->select(point, context, child_point, children);
    frames.enter(texture.selector->frame);
    RGB sum(0.0f);
    for (int i = 0; i < count; ++i) {
      sum += texture_transmittance(scene, *children[i].texture, child_point, context, caustics,
                                   frames)
                 .times(children[i].weight);
    }
    return sum;
  }
  RGB product(1.0f);
  for (const TextureLayer& layer : texture.layers) {
    ColorRGBFT c;
    if (!layer.pigment->evaluate(point, context, c)) continue;
    product *= c.rgb() * c.filter + RGB(c.transmit);
    if (caustics != 0) {
      TextureContext bent = context;
      const Vec3 normal =
          normalize_or_zero(layer_normal(layer, frames, point, context.normal, bent));
      const double cosine = std::abs(dot(normal, context.ray_direction));
      product *= static_cast<float>(1 + power(cosine, caustics));
    }
  }
  return product;
}

}  // namespace

RGB interior_fade(const InteriorNode& interior, double segment_length) {
  const RGB& q = interior.fade_color;
  const double relative = segment_length / interior.fade_distance;
  if (interior.fade_power >= 1000) {
    return {static_cast<float>(std::exp(-(1 - q.red) * relative)),
            static_cast<float>(std::exp(-(1 - q.green) * relative)),
            static_cast<float>(std::exp(-(1 - q.blue) * relative))};
  }
  const float share =
      static_cast<float>(1 / (1 + power(relative, static_cast<double>(interior.fade_power))));
  return q + (RGB(1.0f) - q) * share;
}

RGB surface_transmittance(const ShadingScene& scene, const SurfacePoint& surface,
                          const Vec3& direction, const InteriorList& interiors,
                          double segment_length) {
  TextureContext context;
  context.has_surface = true;
  context.ray_direction = direction;
  context.normal = dot(surface.normal, direction) > 0 ? -surface.normal : surface.normal;
  context.world_point = surface.point;
  context.uv = surface.uv;
  const Vec3 point =
      surface.object->uv_mapping ? Vec3(surface.uv.x, surface.uv.y, 0) : surface.point;

  const WorldInterior& interior = scene.world->interiors()[surface.object->interior];
  RGB sum(0.0f);
  for (int i = 0; i < surface.share_count; ++i) {
    const TextureShare& share = surface.shares[i];
    const float weight = surface.joined_weight(i, scene.scene.settings.adc_bailout);
    if (weight == 0) continue;
    EnclosingFrames frames;
    sum += weight * texture_transmittance(scene, scene.textures[share.texture], point, context,
                                          interior.caustics, frames);
  }
  if (interior.node && interior.node->fade_power > 0 &&
      std::abs(interior.node->fade_distance) > kEpsilon &&
      interiors.find(surface.object->interior) >= 0) {
    sum *= interior_fade(*interior.node, segment_length);
  }
  return sum;
}

bool stops_light(const ShadingScene& scene, const SurfacePoint& surface, const Vec3& direction) {
  return is_dark(surface_transmittance(scene, surface, direction, {}, 0));
}

void DirectLight::apply_shadow(int index, const ShadowStart& start, const TracedRay& ray,
                               const LightDirection& to_light, RGB& color,
                               RayCounts& counts) const {
  const LightNode& node = scene_.lights[index].node();
  if (scene_.options.quality < 4 || (node.shadowless && !node.projected_through)) return;
  if (ray.level > scene_.scene.settings.max_trace_level) {
    color = RGB(0.0f);
    return;
  }
  if (node.area && scene_.options.quality >= 5) {
    color = area_shadow(index, start, ray, color, counts);
  } else {
    trace_shadow(index, start, to_light, ray, color, counts);
  }
}

// A light with projected_through shines only through that object. What lies beyond the object, the
// last `margin` of the way, casts no shadow.
bool DirectLight::passes_projection(int index, const Vec3& point, const LightDirection& to_light,
                                    double& margin) const {
  double depth;
  if (!scene_.world->closest_hit_of_projected(index, point, to_light.direction, depth) ||
      depth >= to_light.distance) {
    return false;
  }
  margin = to_light.distance - depth + kShadowTolerance;
  return true;
}

void DirectLight::trace_shadow(int index, const ShadowStart& start, const LightDirection& to_light,
                               const TracedRay& ray, RGB& color, RayCounts& counts) const {
  ++counts.shadow;
  const Vec3& point = start.point;
  const LightNode& light = scene_.lights[index].node();
  double margin = 0;
  if (light.projected_through && !passes_projection(index, point, to_light, margin)) {
    color = RGB(0.0f);
    return;
  }
  if (to_light.distance <= kShadowTolerance || light.shadowless) return;
  // Most shadow rays are stopped by something opaque or by nothing.
  if (scene_.world->occluded_by_opaque(start, to_light.direction,
                                       to_light.distance - std::max(margin, kShadowTolerance),
                                       index)) {
    color = RGB(0.0f);
    return;
  }
  if (ray.level == 0 && scene_.world->has_remembered_casters() &&
      scene_.world->lights()[index].light_group < 0) {
    filter_remembered(point, to_light, margin, ray, color);
    if (is_dark(color)) return;
  }
  if (scene_.world->has_clear_casters() || scene_.atmosphere.has_fog()) {
    filter_shadow(index, point, to_light, margin, ray, color);
  }
}

// What POV-Ray remembers to have stopped a light is asked first: where the ray meets a clear part
// of it, the light is filtered there, and once more when its turn comes.
void DirectLight::filter_remembered(const Vec3& point, const LightDirection& to_light,
                                    double margin, const TracedRay& ray, RGB& color) const {
  Hit hit;
  if (!scene_.world->closest_hit_of_remembered(point, to_light.direction,
                                               to_light.distance - margin, hit)) {
    return;
  }
  SurfacePoint surface;
  scene_.world->surface_point(point, to_light.direction, hit, surface);
  color *= surface_transmittance(scene_, surface, to_light.direction, ray.interiors, hit.t);
  if (is_dark(color)) color = RGB(0.0f);
}

void DirectLight::filter_shadow(int index, const Vec3& point, const LightDirection& to_light,
                                double margin, const TracedRay& ray, RGB& color) const {
  const LightNode& light = scene_.lights[index].node();
  const World& world = *scene_.world;
  double remaining = to_light.distance;
  InteriorList interiors = ray.interiors;
  Vec3 origin = point;
  const bool through_air = light.media_interaction && light.media_attenuation &&
                           scene_.options.quality >= 9 && scene_.atmosphere.has_fog();
  for (;;) {
    Hit hit;
    if (!world.closest_clear_hit(origin, to_light.direction, remaining - margin, hit)) break;
    const double depth = hit.t;
    if (depth >= remaining - kShadowTolerance || remaining - depth <= margin) break;
    SurfacePoint surface;
    world.surface_point(origin, to_light.direction, hit, surface);
    color *= surface_transmittance(scene_, surface, to_light.direction, interiors, depth);
    if (is_dark(color)) {
      color = RGB(0.0f);
      return;
    }
    if (through_air && scene_.is_in_air(interiors)) {
      float ignored = 0;
      scene_.atmosphere.apply_fog(origin, to_light.direction, depth, true, color, ignored);
    }
    interiors.toggle(surface.object->interior);
    origin = surface.point;
    remaining -= depth;
  }
  if (through_air && remaining > kShadowTolerance && scene_.is_in_air(interiors)) {
    float ignored = 0;
    scene_.atmosphere.apply_fog(origin, to_light.direction, remaining, true, color, ignored);
  }
}

}  // namespace durer
