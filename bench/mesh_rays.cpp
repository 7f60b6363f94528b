// What a ray at a big mesh costs beyond Embree: the whole of World::closest_hit beside a bare loop
// of rtcIntersect1 (ROBUST) whose hit is computed again in double precision.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <cmath>
#include <random>

#include "tracer/world/world.h"

namespace durer {
namespace {

constexpr int kSide = 708;  // squares along an edge: 1,002,528 triangles

const std::shared_ptr<const ShapeNode>& waves() {
  static const std::shared_ptr<const ShapeNode> shape = [] {
    MeshNode mesh;
    for (int j = 0; j <= kSide; ++j) {
      for (int i = 0; i <= kSide; ++i) {
        const float x = static_cast<float>(i) / kSide * 20 - 10;
        const float z = static_cast<float>(j) / kSide * 20 - 10;
        mesh.vertices.push_back({x, std::sin(1.7f * x) * std::cos(2.3f * z), z});
      }
    }
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const int32_t a = j * (kSide + 1) + i, b = a + kSide + 1;
        mesh.face_vertices.push_back({a, a + 1, b});
        mesh.face_vertices.push_back({a + 1, b + 1, b});
      }
    }
    return std::make_shared<ShapeNode>(Rare<MeshNode>(std::move(mesh)));
  }();
  return shape;
}

const MeshNode& mesh() {
  return *std::get<Rare<MeshNode>>(*waves());
}

// As a camera above the waves sends them, row by row, or from and to anywhere near them.
std::vector<Ray> rays(bool scattered) {
  std::vector<Ray> result;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-9, 9);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      Ray ray{{0, 8, -14}, {0, 0, 0}};
      Vec3 target((x - 160) / 18.0, 0, (y - 120) / 14.0);
      if (scattered) {
        ray.origin = {anywhere(random), 3, anywhere(random)};
        target = {anywhere(random), 0, anywhere(random)};
      }
      ray.direction = glm::normalize(target - ray.origin);
      result.push_back(ray);
    }
  }
  return result;
}

void through_world(benchmark::State& state) {
  static const Scene settings;
  static const std::unique_ptr<World> world = [] {
    auto object = std::make_shared<ObjectNode>();
    object->shape = waves();
    return World::build(settings, std::vector<ObjectPtr>{object}, WorldOptions(),
                        TextureSettings());
  }();
  const std::vector<Ray> all = rays(state.range(0));
  RayClass kind;
  kind.primary = true;
  size_t met = 0;
  for (auto _ : state) {
    for (const Ray& ray : all) {
      Hit hit;
      met += world->closest_hit(ray.origin, ray.direction, kind, 1e7, hit);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(all.size()));
  state.counters["met"] = static_cast<double>(met) / static_cast<double>(state.iterations());
}

RTCScene bare_scene() {
  const RTCDevice device = rtcNewDevice("threads=1");
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh().vertices.data(), 0, sizeof(glm::vec3), mesh().vertices.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh().face_vertices.data(), 0, 3 * sizeof(int32_t),
                             mesh().face_vertices.size());
  rtcCommitGeometry(geometry);
  const RTCScene scene = rtcNewScene(device);
  rtcAttachGeometry(scene, geometry);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene);
  return scene;
}

// The depth at which a line meets the plane of a face.
double refined_depth(const Ray& ray, uint32_t face) {
  const std::array<int32_t, 3>& corners = mesh().face_vertices[face];
  const Vec3 a(mesh().vertices[corners[0]]), b(mesh().vertices[corners[1]]),
      c(mesh().vertices[corners[2]]);
  const Vec3 normal = cross(b - a, c - a);
  return dot(normal, a - ray.origin) / dot(normal, ray.direction);
}

void bare_embree(benchmark::State& state) {
  static const RTCScene scene = bare_scene();
  const std::vector<Ray> all = rays(state.range(0));
  size_t met = 0;
  for (auto _ : state) {
    for (const Ray& ray : all) {
      RTCRayHit query{};
      query.ray.org_x = static_cast<float>(ray.origin.x);
      query.ray.org_y = static_cast<float>(ray.origin.y);
      query.ray.org_z = static_cast<float>(ray.origin.z);
      query.ray.dir_x = static_cast<float>(ray.direction.x);
      query.ray.dir_y = static_cast<float>(ray.direction.y);
      query.ray.dir_z = static_cast<float>(ray.direction.z);
      query.ray.tfar = 1e7f;
      query.ray.mask = ~0u;
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcIntersect1(scene, &context, &query);
      if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
      ++met;
      benchmark::DoNotOptimize(refined_depth(ray, query.hit.primID));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(all.size()));
  state.counters["met"] = static_cast<double>(met) / static_cast<double>(state.iterations());
}

// 0: a camera's rays, 1: scattered ones.
BENCHMARK(through_world)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(bare_embree)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace durer
