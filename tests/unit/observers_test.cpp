// Observers and indirect light, with test doubles (design.md 1).
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <vector>

#include "parser/parse_scene.h"
#include "tracer/shading/whitted.h"

namespace durer {
namespace {

// The scene of a text, ready to be asked for the light along rays.
class SmallWorld {
 public:
  explicit SmallWorld(const std::string& text) {
    const std::string path =
        ::testing::TempDir() + "durer_observers_test" + std::to_string(getpid()) + ".pov";
    std::ofstream(path) << "#version 3.7; global_settings { assumed_gamma 1 }\n" << text;
    ParseOptions options;
    options.input_file = path;
    scene_ = std::move(parse_scene(options).scene);
    std::remove(path.c_str());
    shading_ = std::make_unique<ShadingScene>(*scene_, scene_->objects, WorldOptions{},
                                              ShadingOptions{});
  }

  const ShadingScene& shading() const { return *shading_; }

  RayResult trace(const WhittedIntegrator& integrator, const Vec3& origin,
                  const Vec3& direction) const {
    TracedRay ray;
    ray.origin = origin;
    ray.direction = normalize_or_zero(direction);
    ray.kind.primary = true;
    RayCounts counts;
    return integrator.trace(ray, counts);
  }

 private:
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<ShadingScene> shading_;
};

// Writes down what it sees; the sum of a ray's contributions beside the ray's result.
class Recorder : public RayObserver {
 public:
  struct Ray {
    RayKind kind;
    std::string events;
    int hits = 0;
    RGB sum{0.0f}, result{0.0f};
  };

  void ray_spawned(const TracedRay& ray) override {
    open_.push_back(rays.size());
    rays.push_back({ray.spawned_as, ray.events.text()});
  }
  void ray_hit(const TracedRay&, const SurfacePoint&, double) override { ++current().hits; }
  void light_tested(const TracedRay&, int light, const Vec3&, const RGB& arriving) override {
    lights[light] = arriving;
  }
  void contribution(const TracedRay& ray, const Contribution& c) override {
    current().sum += c.color;
    if (!c.color.is_black()) paths.insert({path_text(ray, c.kind), c.color});
  }
  void ray_finished(const TracedRay&, const RayResult& result) override {
    current().result = result.color;
    open_.pop_back();
  }

  std::vector<Ray> rays;
  std::map<int, RGB> lights;
  std::multimap<std::string, RGB> paths;

 private:
  Ray& current() { return rays[open_.back()]; }
  std::vector<size_t> open_;
};

constexpr const char* kMirrorAndGlass = R"(
background { rgb <0.1, 0.2, 0.3> }
light_source { <0, 10, -10>, rgb 1 }
light_source { <50, 1, 0>, rgb 0.5 }
plane { y, -1 pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 } }
sphere { <0, 0, 5>, 1 pigment { rgb <0.5, 0.5, 0.5> } finish { reflection 0.4 emission 0.1 phong 0.5 } }
sphere { <3, 0, 5>, 1 pigment { rgbf 0.9 } interior { ior 1.5 } }
)";

TEST(RayObserver, ContributionsAddUpToTheLightOfEachRay) {
  const SmallWorld world(kMirrorAndGlass);
  Recorder recorder;
  const WhittedIntegrator watched(world.shading(), WhittedIntegrator::Depth::recursive, nullptr,
                                  &recorder);
  const WhittedIntegrator plain(world.shading(), WhittedIntegrator::Depth::recursive);
  for (const Vec3& direction : {Vec3(0.1, -0.05, 1), Vec3(0.6, 0.02, 1), Vec3(0, -1, 0.3)}) {
    const RGB seen = world.trace(watched, Vec3(0), direction).color;
    EXPECT_EQ(seen, world.trace(plain, Vec3(0), direction).color);
  }
  ASSERT_GE(recorder.rays.size(), 6u);
  for (const Recorder::Ray& ray : recorder.rays) {
    EXPECT_LE(ray.hits, 1);
    EXPECT_NEAR(ray.sum.red, ray.result.red, 1e-6f) << ray.events;
    EXPECT_NEAR(ray.sum.green, ray.result.green, 1e-6f) << ray.events;
    EXPECT_NEAR(ray.sum.blue, ray.result.blue, 1e-6f) << ray.events;
  }
}

TEST(RayObserver, SeesKindsAndPathsOfRays) {
  const SmallWorld world(kMirrorAndGlass);
  Recorder recorder;
  const WhittedIntegrator integrator(world.shading(), WhittedIntegrator::Depth::recursive, nullptr,
                                     &recorder);
  // The mirror ball turns this ray down to the floor.
  world.trace(integrator, Vec3(0), Vec3(0, -0.12, 1));
  ASSERT_GE(recorder.rays.size(), 2u);
  EXPECT_EQ(recorder.rays[0].kind, RayKind::primary);
  EXPECT_EQ(recorder.rays[0].events, "E");
  EXPECT_EQ(recorder.rays[1].kind, RayKind::reflected);
  EXPECT_EQ(recorder.rays[1].events, "ES");
  EXPECT_EQ(recorder.paths.count("EL"), 1u);    // emission of the ball
  EXPECT_GE(recorder.paths.count("EDL"), 1u);   // lights on the ball
  EXPECT_GE(recorder.paths.count("ESDL"), 1u);  // lights on the floor in the ball
  EXPECT_EQ(recorder.lights.count(0), 1u);
  // Through the glass ball: into it, and out again.
  recorder = Recorder();
  world.trace(integrator, Vec3(0), Vec3(0.6, 0.02, 1));
  ASSERT_GE(recorder.rays.size(), 3u);
  EXPECT_EQ(recorder.rays[1].kind, RayKind::refracted);
  EXPECT_EQ(recorder.rays[2].events, "ESS");
}

TEST(RayObserver, RaycastSpawnsNothing) {
  const SmallWorld world(kMirrorAndGlass);
  Recorder recorder;
  const WhittedIntegrator integrator(world.shading(), WhittedIntegrator::Depth::raycast, nullptr,
                                     &recorder);
  world.trace(integrator, Vec3(0), Vec3(0, -0.12, 1));
  world.trace(integrator, Vec3(0), Vec3(0.6, 0.02, 1));
  EXPECT_EQ(recorder.rays.size(), 2u);
  for (const auto& [path, color] : recorder.paths) EXPECT_EQ(path.find('S'), std::string::npos);
}

TEST(PathEvents, KeepsTheFirst32) {
  PathEvents events;
  for (int i = 0; i < 40; ++i) events.append(PathEvents::Event::specular);
  EXPECT_EQ(events.text(), "E" + std::string(31, 'S'));
}

// A sky that sends the same light from everywhere, and one photon from above.
class FakeLight : public IndirectLight {
 public:
  bool ambient(const TracedRay&, const SurfacePoint&, const Vec3& geometric_normal, const Vec3&,
               float, RGB& radiance) const override {
    ++asked;
    EXPECT_NEAR(length(geometric_normal), 1, 1e-12);
    radiance = RGB(0.25f, 0.5f, 1);
    return has_ambient;
  }
  void gather_photons(const SurfacePoint&, PhotonVisitor& visitor) const override {
    if (has_photon) visitor.photon(Vec3(0, 1, 0), RGB(0.5f));
  }

  bool has_ambient = false, has_photon = false;
  mutable int asked = 0;
};

constexpr const char* kFloor =
    "plane { y, 0 pigment { rgb <0.8, 0.4, 0.2> } finish { ambient 0.5 diffuse 0.5 } }";

TEST(IndirectLight, NullImplementationChangesNothing) {
  const SmallWorld world(kFloor);
  const IndirectLight nothing;
  const WhittedIntegrator with(world.shading(), WhittedIntegrator::Depth::recursive, &nothing);
  const WhittedIntegrator without(world.shading(), WhittedIntegrator::Depth::recursive);
  const Vec3 origin(0, 1, 0), direction(0.2, -1, 0.1);
  EXPECT_EQ(world.trace(with, origin, direction).color,
            world.trace(without, origin, direction).color);
  EXPECT_EQ(nothing.media_light(TracedRay{}, origin), RGB(0.0f));
}

TEST(IndirectLight, AmbientRadianceTakesThePlaceOfAmbient) {
  const SmallWorld world(kFloor);
  FakeLight sky;
  sky.has_ambient = true;
  const WhittedIntegrator integrator(world.shading(), WhittedIntegrator::Depth::recursive, &sky);
  const RGB seen = world.trace(integrator, Vec3(0, 1, 0), Vec3(0.2, -1, 0.1)).color;
  EXPECT_EQ(sky.asked, 1);
  EXPECT_FLOAT_EQ(seen.red, 0.8f * 0.5f * 0.25f);
  EXPECT_FLOAT_EQ(seen.green, 0.4f * 0.5f * 0.5f);
  EXPECT_FLOAT_EQ(seen.blue, 0.2f * 0.5f * 1);
}

TEST(IndirectLight, PhotonsShineLikeLights) {
  const SmallWorld world(kFloor);
  FakeLight map;
  map.has_photon = true;
  const WhittedIntegrator integrator(world.shading(), WhittedIntegrator::Depth::recursive, &map);
  const RGB seen = world.trace(integrator, Vec3(0, 1, 0), Vec3(0.2, -1, 0.1)).color;
  // Ambient, and half the light from above on a diffuse surface.
  EXPECT_FLOAT_EQ(seen.red, 0.8f * (0.5f + 0.5f * 0.5f));
  EXPECT_FLOAT_EQ(seen.blue, 0.2f * (0.5f + 0.5f * 0.5f));
}

}  // namespace
}  // namespace durer
