#include "tracer/shading/whitted.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/lights/area_light_grid.h"
#include "tracer/math/power.h"
#include "tracer/shading/reflectance.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;
constexpr uint32_t kPurposeCrand = 2;
constexpr uint32_t kPurposeRainbow = 3;
constexpr uint32_t kPurposeAreaIllumination = 4;
constexpr uint64_t kEventReflection = 1;

bool is_dark(const RGB& c) {
  return std::abs(c.red) <= kEpsilon && std::abs(c.green) <= kEpsilon &&
         std::abs(c.blue) <= kEpsilon;
}

// At most this many layers of a texture reflect; deeper ones are below adc_bailout in practice.
constexpr int kMostReflections = 32;

}  // namespace

struct WhittedIntegrator::ReflectedLayer {
  const TextureLayer* layer;
  Vec3 normal;
  RGB reflectivity;
  float weight;
};

RayResult WhittedIntegrator::trace(const TracedRay& ray, RayCounts& counts) const {
  if (!observer_) [[likely]] return follow(ray, counts);
  observer_->ray_spawned(ray);
  const RayResult result = follow(ray, counts);
  observer_->ray_finished(ray, result);
  return result;
}

void WhittedIntegrator::report(const TracedRay& ray, ContributionKind kind, const RGB& color,
                               int light) const {
  observer_->contribution(ray, {kind, light, color});
}

RayResult WhittedIntegrator::follow(const TracedRay& ray, RayCounts& counts) const {
  RayResult result;
  const GlobalSettings& settings = scene_.scene.settings;
  if (ray.level >= settings.max_trace_level || ray.weight < settings.adc_bailout) return result;

  Hit hit;
  const bool met =
      scene_.world->closest_hit(ray.origin, ray.direction, ray.kind, ray.max_depth, hit, ray.beam);
  if (met) {
    SurfacePoint surface;
    scene_.world->surface_point(ray.origin, ray.direction, hit, surface);
    result.depth = hit.t;
    shade_surface(ray, surface, hit.t, counts, result);
  } else {
    result.depth = ray.max_depth;
    scene_.atmosphere.background(ray.direction, !ray.kind.reflected, result.color,
                                 result.transmit);
    if (observer_) [[unlikely]] report(ray, ContributionKind::background, result.color);
  }

  // What lies in the air, if the ray is in the air.
  const bool airy = scene_.atmosphere.has_fog() || scene_.atmosphere.has_rainbow();
  if (airy && scene_.options.quality >= 9) {
    if (scene_.is_in_air(ray.interiors)) {
      if (scene_.atmosphere.has_rainbow()) {
        scene_.atmosphere.apply_rainbow(ray.direction, result.depth,
                                        path_random(ray.path, kPurposeRainbow, 0), result.color,
                                        result.transmit);
      }
      scene_.atmosphere.apply_fog(ray.origin, ray.direction, result.depth, false, result.color,
                                  result.transmit);
    }
  }
  return result;
}

void WhittedIntegrator::shade_surface(const TracedRay& ray, const SurfacePoint& surface,
                                      double depth, RayCounts& counts, RayResult& result) const {
  if (observer_) [[unlikely]] observer_->ray_hit(ray, surface, depth);
  const Vec3 facing = dot(surface.normal, ray.direction) > 0 ? -surface.normal : surface.normal;
  SurfaceHit hit(ray, surface, scene_.world->interiors()[surface.object->interior], depth, facing);
  const Vec3 point =
      surface.object->uv_mapping ? Vec3(surface.uv.x, surface.uv.y, 0) : surface.point;

  ShadowedLights lights;
  const CompiledTexture* first =
      surface.share_count ? &scene_.textures[surface.shares[0].texture] : nullptr;
  if (surface.share_count > 1 || (first && (first->selector || first->layers.size() > 1))) {
    hit.lights = &lights;
  }
  if (surface.share_count == 1) {
    EnclosingFrames frames;
    shade_texture(ray, hit, scene_.textures[surface.shares[0].texture], point, frames, counts,
                  result.color, result.transmit);
    return;
  }
  for (int i = 0; i < surface.share_count; ++i) {
    const TextureShare& share = surface.shares[i];
    const float weight = surface.joined_weight(i, scene_.scene.settings.adc_bailout);
    if (weight == 0) continue;
    RGB color(0.0f);
    float transmit = 0;
    EnclosingFrames frames;
    shade_texture(ray, hit, scene_.textures[share.texture], point, frames, counts, color,
                  transmit);
    result.color += weight * color;
    result.transmit += weight * transmit;
  }
}

void WhittedIntegrator::shade_texture(const TracedRay& ray, const SurfaceHit& hit,
                                      const CompiledTexture& texture, const Vec3& point,
                                      EnclosingFrames& frames, RayCounts& counts, RGB& color,
                                      float& transmit) const {
  // Patterned textures shade every child completely and blend the results.
  if (texture.selector) {
    WeightedTexture children[TextureSelector::kMostTextures];
    Vec3 child_point;
    TextureContext context = hit.context;
    context.normal = hit.last_normal;
    const int count = texture.selector->select(point, context, child_point, children);
    frames.enter(texture.selector->frame);
    for (int i = 0; i < count; ++i) {
      RGB child_color(0.0f);
      float child_transmit = 0;
      shade_texture(ray, hit, *children[i].texture, child_point, frames, counts, child_color,
                    child_transmit);
      color += child_color.times(children[i].weight);
      transmit += static_cast<float>(children[i].weight) * child_transmit;
    }
    return;
  }

  const int quality = scene_.options.quality;
  const double bailout = scene_.scene.settings.adc_bailout;
  RGB filter(1.0f);
  float trans = 1;
  bool found_any = false;
  Vec3 top_normal = hit.context.normal;
  Uncleared<ReflectedLayer> reflected[kMostReflections];
  int reflected_count = 0;
  const TextureLayer* first_layer = nullptr;

  for (const TextureLayer& layer : texture.layers) {
    if (trans <= bailout) break;
    // The layer's normal and colour. Patterns that look at the normal see the one bumped last, maybe by
    // another layer.
    Vec3 normal = hit.context.normal;
    const TextureContext* context = &hit.context;
    Uncleared<TextureContext> bumped;
    if (layer.normal) {
      context = &bumped.emplace(hit.context);
      bumped.value.normal = hit.last_normal;
      normal = layer_normal(layer, frames, point, hit.context.normal, bumped.value);
      // Nothing that such a layer adds is a number either.
      if (std::isnan(normal.x)) [[unlikely]] color += RGB(std::numeric_limits<float>::quiet_NaN());
      hit.last_normal = context->normal;
      hit.is_bumped = true;
    } else if (hit.is_bumped) {
      context = &bumped.emplace(hit.context);
      bumped.value.normal = hit.last_normal;
    }
    if (!first_layer) {
      first_layer = &layer;
      top_normal = normal;
    }
    ColorRGBFT pigment;
    const bool found = layer.pigment->evaluate(point, *context, pigment);
    found_any |= found;

    // Without lighting the picture is the pigment.
    if (quality <= 1) {
      color = pigment.rgb();
    } else {
      const FinishNode& finish = *layer.finish;
      Reflectivity mirror;
      if (layer.is_mirror && recursive_) {
        float relative_ior = 1;
        if (finish.reflection_fresnel) {
          const float ior = hit.interior.ior;
          if (ray.interiors.empty()) {
            relative_ior = ior;
          } else if (hit.inside_interior) {
            relative_ior = ray.interiors.size() == 1
                               ? 1 / ior
                               : scene_.world->interiors()[ray.interiors.last()].ior / ior;
          } else {
            relative_ior = ior / scene_.world->interiors()[ray.interiors.last()].ior;
          }
        }
        mirror = reflectivity(finish, -dot(ray.direction, normal), relative_ior, pigment.rgb());
        if (!mirror.color.is_black() && reflected_count < kMostReflections) {
          reflected[reflected_count++].emplace(
              ReflectedLayer{&layer, normal, mirror.color, ray.weight * trans * mirror.weight});
        }
      }
      const float opacity =
          scene_.new_opacity_rule
              ? 1 - pigment.filter - pigment.transmit
              : 1 - (pigment.filter * pigment.rgb().max_component() + pigment.transmit);
      color += filter * shade_layer(ray, hit, layer, pigment, normal, opacity, filter, counts);
      if (found && finish.conserve_energy) {
        filter *= RGB(std::min(1.0f, 1 - mirror.color.red), std::min(1.0f, 1 - mirror.color.green),
                      std::min(1.0f, 1 - mirror.color.blue));
      }
    }
    if (found) filter *= pigment.rgb() * pigment.filter + RGB(pigment.transmit);
    trans = std::min(1.0f, std::abs(filter.grey()));
  }
  if (!first_layer || quality <= 1) return;

  // Light from behind.
  bool total_reflection = false;
  if (trans > bailout && quality >= 6 && recursive_) {
    const float weight =
        ray.weight * std::max({std::abs(filter.red), std::abs(filter.green), std::abs(filter.blue)});
    const RGB before = color;
    total_reflection = transmit_ray(ray, hit, *first_layer, top_normal, weight, filter, found_any,
                                    counts, color, transmit);
    if (observer_) [[unlikely]] report(ray, ContributionKind::transmission, color - before);
    if (found_any) transmit *= trans;
  }

  // Light that the layers mirror.
  if (quality < 8 || !recursive_) return;
  for (int i = 0; i < reflected_count; ++i) {
    const ReflectedLayer& mirror = reflected[i].value;
    const Vec3 difference = glm::abs(mirror.normal - top_normal);
    if (total_reflection && difference.x <= kEpsilon && difference.y <= kEpsilon &&
        difference.z <= kEpsilon) {
      continue;
    }
    RGB seen = reflect(ray, hit, mirror.normal, *mirror.layer, mirror.weight, counts);
    const float exponent = mirror.layer->finish->reflection_exponent;
    if (exponent != 1) {
      seen = {std::pow(seen.red, 1 / exponent), std::pow(seen.green, 1 / exponent),
              std::pow(seen.blue, 1 / exponent)};
    }
    color += mirror.reflectivity * seen;
    if (observer_) [[unlikely]] report(ray, ContributionKind::reflection, mirror.reflectivity * seen);
  }
}

RGB WhittedIntegrator::shade_layer(const TracedRay& ray, const SurfaceHit& hit,
                                   const TextureLayer& layer, const ColorRGBFT& pigment,
                                   const Vec3& normal, float opacity, const RGB& filter,
                                   RayCounts& counts) const {
  const FinishNode& finish = *layer.finish;
  const RGB base = pigment.rgb();
  RGB sum = base * finish.ambient * scene_.scene.settings.ambient_light * opacity;
  if (indirect_) [[unlikely]] {
    replace_ambient(ray, hit, layer, base, normal, opacity, filter, sum);
  }
  if (observer_) [[unlikely]] report(ray, ContributionKind::ambient, filter * sum);
  const RGB emission = base * finish.emission * opacity;
  sum += emission;
  if (observer_) [[unlikely]] report(ray, ContributionKind::emission, filter * emission);
  if (!layer.is_lit) return sum;
  // Of a clear layer only highlights are seen.
  const bool is_unlit = opacity == 0 && !layer.is_lit_when_clear && (base * 0.0f).is_black();
  if (is_unlit && !observer_) return sum;
  int place = 0;
  for (const int light : scene_.lights_of(*hit.surface.object)) {
    const RGB direct =
        light_contribution(ray, hit, layer, pigment, normal, opacity, light, place++, counts);
    sum += direct;
    if (observer_) [[unlikely]] report(ray, ContributionKind::direct, filter * direct, light);
  }
  if (indirect_) {
    const RGB photons = photon_light(ray, hit, layer, base, normal, opacity);
    sum += photons;
    if (observer_) [[unlikely]] report(ray, ContributionKind::photons, filter * photons);
  }
  return sum;
}

namespace {

// Diffuse, phong, specular of one direction of light (8.3, 8.4): `diffuse` multiplies the pigment, the
// others the metallic tint.
struct LobeShares {
  double diffuse = 0, phong = 0, specular = 0;

  // What highlights are tinted by, where there are any.
  RGB tint(const FinishNode& finish, double cosine, const RGB& pigment) const {
    if (finish.metallic <= 0 || (phong == 0 && specular == 0)) return RGB(1.0f);
    return metallic_tint(finish.metallic, cosine, pigment);
  }
  // Of this light; in the order of POV-Ray's last digits (decision 0071).
  RGB of(const RGB& light, const RGB& pigment, const RGB& tint) const {
    RGB sum = pigment.times(diffuse) * light;
    if (phong != 0) sum += (light * tint).times(phong);
    if (specular != 0) sum += (light * tint).times(specular);
    return sum;
  }
};

[[gnu::always_inline]] inline LobeShares lobe_shares(const TextureLayer& layer,
                                                     const Vec3& ray_direction, const Vec3& normal,
                                                     const Vec3& to_light, float diffuse,
                                                     float opacity, bool highlights) {
  const FinishNode& finish = *layer.finish;
  LobeShares shares;
  if (diffuse > 0) {
    double cosine = std::abs(dot(normal, to_light));
    if (finish.brilliance != 1) cosine = power(cosine, static_cast<double>(finish.brilliance));
    shares.diffuse = cosine * diffuse * opacity;
  }
  if (!highlights) return shares;
  if (finish.phong > 0) {
    const double p = dot(mirrored(ray_direction, normal), to_light);
    if (p > layer.dark_phong_cosine && (finish.phong_size < 60 || p > 0.0008)) {
      shares.phong = finish.phong * power(p, static_cast<double>(finish.phong_size));
    }
  }
  if (finish.specular > 0) {
    const Vec3 half = 0.5 * (to_light - ray_direction);
    const double along_normal = dot(half, normal), dark = layer.dark_specular_cosine;
    const double squared = dot(half, half);
    if (along_normal > 0 && along_normal * along_normal > dark * dark * squared) {
      const double q = along_normal / std::sqrt(squared);
      shares.specular =
          finish.specular * power(q, static_cast<double>(layer.highlight_exponent));
    }
  }
  return shares;
}

}  // namespace

void WhittedIntegrator::replace_ambient(const TracedRay& ray, const SurfaceHit& hit,
                                        const TextureLayer& layer, const RGB& pigment,
                                        const Vec3& normal, float opacity, const RGB& filter,
                                        RGB& ambient) const {
  // Worth asking for only where it will be seen (spec/shading.md 18).
  const float diffuse = layer.finish->diffuse;
  const float share = (filter * pigment).grey() * opacity * diffuse;
  if (!hit.ambient_asked && share > scene_.scene.settings.adc_bailout) {
    hit.ambient_asked = true;
    hit.has_ambient = indirect_->ambient(ray, hit.surface, hit.context.normal, normal,
                                         ray.weight * share, hit.ambient);
  }
  if (hit.has_ambient) ambient = pigment * hit.ambient * (opacity * diffuse);
}

// Adds up what a layer sends along the ray of each photon.
class WhittedIntegrator::PhotonLobes final : public PhotonVisitor {
 public:
  PhotonLobes(const TextureLayer& layer, const Vec3& ray_direction, const Vec3& normal,
              const RGB& pigment, float opacity)
      : layer_(layer),
        ray_direction_(ray_direction),
        normal_(normal),
        pigment_(pigment),
        opacity_(opacity) {}

  void photon(const Vec3& towards_source, const RGB& radiance) override {
    const bool from_behind = dot(normal_, towards_source) < kEpsilon;
    const FinishNode& finish = *layer_.finish;
    const LobeShares shares =
        lobe_shares(layer_, ray_direction_, normal_, towards_source,
                    from_behind ? finish.diffuse_back : finish.diffuse, opacity_, !from_behind);
    sum += shares.of(radiance, pigment_,
                     shares.tint(finish, dot(normal_, towards_source), pigment_));
  }

  RGB sum{0.0f};

 private:
  const TextureLayer& layer_;
  const Vec3 &ray_direction_, &normal_;
  const RGB& pigment_;
  float opacity_;
};

RGB WhittedIntegrator::photon_light(const TracedRay& ray, const SurfaceHit& hit,
                                    const TextureLayer& layer, const RGB& pigment,
                                    const Vec3& normal, float opacity) const {
  PhotonLobes lobes(layer, ray.direction, normal, pigment, opacity);
  indirect_->gather_photons(hit.surface, lobes);
  return lobes.sum;
}

RGB WhittedIntegrator::light_contribution(const TracedRay& ray, const SurfaceHit& hit,
                                          const TextureLayer& layer, const ColorRGBFT& pigment,
                                          const Vec3& normal, float opacity, int index, int place,
                                          RayCounts& counts) const {
  const FinishNode& finish = *layer.finish;
  const Light& light = scene_.lights[index];
  const LightNode& node = light.node();
  const Vec3& point = hit.surface.point;
  const bool remembers = hit.lights && place < ShadowedLights::kMost;
  const bool is_new = !remembers || !hit.lights->knows_unshadowed(place);
  Uncleared<ArrivingLight> own;
  ArrivingLight& arriving = remembers ? hit.lights->unshadowed(place) : own.value;
  if (is_new) direct_light_.find_unshadowed(index, point, arriving);
  if (is_dark(arriving.color)) return RGB(0.0f);

  // Which side of the surface does the light see?
  bool backside = false;
  if (!hit.surface.object->double_illuminate && !node.area_illumination) {
    if (dot(normal, arriving.direction.direction) < kEpsilon) {
      if (finish.diffuse_back == 0) return RGB(0.0f);
      backside = true;
    }
  }
  const RGB base = pigment.rgb();
  const bool may_shine = !node.shadowless && !ray.kind.radiosity;
  // What of the light from one direction goes along the ray.
  const auto shares_of = [&](const Vec3& to_light, bool from_behind, uint32_t draw) {
    const float diffuse = from_behind ? finish.diffuse_back : finish.diffuse;
    LobeShares shares = lobe_shares(layer, ray.direction, normal, to_light, diffuse, opacity,
                                    may_shine && !from_behind);
    if (finish.crand > 0 && diffuse > 0) [[unlikely]] {
      const uint32_t purpose = kPurposeCrand + 16 * static_cast<uint32_t>(index);
      shares.diffuse -= static_cast<double>(finish.crand) * path_random(ray.path, purpose, draw);
    }
    return shares;
  };
  const bool from_each_sample =
      node.area_illumination && node.area && scene_.options.quality >= 5;
  LobeShares shares;
  RGB tint;
  if (!from_each_sample) {
    shares = shares_of(arriving.direction.direction, backside, 0);
    tint = shares.tint(finish, dot(normal, arriving.direction.direction), base);
    // What could not be seen needs no shadow ray (performance.md 2.6).
    const RGB seen = shares.of(arriving.color, base, tint);
    if (!observer_ && finish.irid.amount == 0 &&
        ray.weight * std::max({std::abs(seen.red), std::abs(seen.green), std::abs(seen.blue)}) <
            least_seen_light_) {
      return RGB(0.0f);
    }
  }

  RGB color = arriving.color;
  if (remembers && hit.lights->knows(place)) {
    color = hit.lights->color(place);
  } else {
    const ShadowStart start{point, hit.context.normal, hit.depth, hit.surface.scene_object};
    direct_light_.apply_shadow(index, start, ray, arriving.direction, color, counts);
    if (remembers) hit.lights->remember(place, color);
  }
  if (observer_) [[unlikely]] observer_->light_tested(ray, index, point, color);
  if (is_dark(color)) return RGB(0.0f);

  RGB sum(0.0f);
  if (from_each_sample) {
    // Every grid point lights the surface from its own direction.
    const AreaLightGrid grid(light, point);
    const uint32_t purpose = kPurposeAreaIllumination + 16 * static_cast<uint32_t>(index);
    const int cells = node.size1 * node.size2;
    for (int first = 0; first < cells; first += AreaSamples::kCount) {
      AreaSamples samples;
      for (int k = 0; k < AreaSamples::kCount; ++k) {
        const int cell = std::min(first + k, cells - 1);
        samples.put(k, cell % node.size1, cell / node.size1);
        if (node.jitter) {
          samples.displace(k, path_random_bits(ray.path, purpose, static_cast<uint32_t>(cell)));
        }
      }
      look_at_samples(grid, samples);
      for (int k = 0; k < std::min(AreaSamples::kCount, cells - first); ++k) {
        const LightDirection to_sample = samples.direction(k);
        const RGB part = color.times(light.attenuation(point, to_sample) / cells);
        bool behind = false;
        if (!hit.surface.object->double_illuminate && dot(normal, to_sample.direction) < kEpsilon) {
          if (finish.diffuse_back == 0) continue;
          behind = true;
        }
        const LobeShares own_shares =
            shares_of(to_sample.direction, behind, static_cast<uint32_t>(first + k));
        sum += own_shares.of(
            part, base, own_shares.tint(finish, dot(normal, to_sample.direction), base));
      }
    }
  } else {
    sum = shares.of(color, base, tint);
  }

  if (finish.irid.amount > 0) {
    sum *= irid_factor(
        finish.irid, hit.surface.point,
        std::abs(dot(normal, arriving.direction.direction)) + std::abs(dot(normal, ray.direction)),
        scene_.scene.settings);
  }
  return sum;
}

RGB WhittedIntegrator::reflect(const TracedRay& ray, const SurfaceHit& hit, const Vec3& normal,
                               const TextureLayer& layer, float weight, RayCounts& counts) const {
  ++counts.reflected;
  const Vec3& geometric = hit.context.normal;
  Vec3 direction = mirrored(ray.direction, normal);
  // A bumped normal may send the ray into the surface: turn it out again.
  if (dot(direction, geometric) < 0) {
    direction = dot(direction, normal) < 0 ? mirrored(ray.direction, geometric)
                                           : mirrored(direction, geometric);
  }
  TracedRay next = ray;
  next.origin = hit.surface.point;
  next.direction = unit_or_zero(direction);
  next.max_depth = kFarAway;
  next.beam = nullptr;
  next.kind.primary = false;
  next.kind.reflected = true;
  next.spawned_as = RayKind::reflected;
  next.events.append(PathEvents::Event::specular);
  next.level = ray.level + 1;
  next.weight = weight;
  next.path = extend_path(ray.path, kEventReflection);
  RGB seen = trace(next, counts).color;
  if (layer.finish->irid.amount > 0) {
    seen *=
        irid_factor(layer.finish->irid, hit.surface.point,
                    std::abs(dot(normal, next.direction)) + std::abs(dot(normal, ray.direction)),
                    scene_.scene.settings);
  }
  return seen;
}

}  // namespace durer
