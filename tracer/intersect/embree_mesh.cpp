#include "tracer/intersect/embree_mesh.h"

#include <embree3/rtcore.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include "tracer/system/shared_library.h"
#include "tracer/system/thread_limit.h"

namespace durer {
namespace {

struct Embree {
  SharedLibrary library{DURER_EMBREE_LIBRARY};
  DURER_IMPORT(rtcNewDevice);
  DURER_IMPORT(rtcReleaseDevice);
  DURER_IMPORT(rtcNewScene);
  DURER_IMPORT(rtcReleaseScene);
  DURER_IMPORT(rtcSetSceneFlags);
  DURER_IMPORT(rtcCommitScene);
  DURER_IMPORT(rtcNewGeometry);
  DURER_IMPORT(rtcReleaseGeometry);
  DURER_IMPORT(rtcSetNewGeometryBuffer);
  DURER_IMPORT(rtcSetSharedGeometryBuffer);
  DURER_IMPORT(rtcCommitGeometry);
  DURER_IMPORT(rtcAttachGeometry);
  DURER_IMPORT(rtcIntersect1);
};

const Embree& embree() { return loaded<Embree>(); }

// Without a number of threads: Embree would limit oneTBB for the whole program to it, rendering
// included, as long as the device lives.
struct Device {
  Device() {
    enforce_thread_limit();
    device = embree().rtcNewDevice("set_affinity=0");
  }
  RTCDevice device;
  ~Device() { embree().rtcReleaseDevice(device); }
};

// One for all meshes: each takes one of the few thread-specific keys that a process has.
std::shared_ptr<Device> shared_device() {
  static std::mutex guard;
  static std::weak_ptr<Device> last;
  const std::lock_guard lock(guard);
  std::shared_ptr<Device> device = last.lock();
  if (!device) last = device = std::make_shared<Device>();
  return device;
}

struct VisitContext {
  RTCIntersectContext context;  // first: Embree hands back a pointer to it
  TriangleVisitor visitor;
  void* data;
};

// Hands every candidate over and declines it, so that the walk goes on.
void decline(const RTCFilterFunctionNArguments* args) {
  auto* context = reinterpret_cast<VisitContext*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    context->visitor(context->data, RTCHitN_primID(args->hit, args->N, i));
    args->valid[i] = 0;
  }
}

RTCRayHit ray_from(const Vec3& origin, const Vec3& direction, float near, float far) {
  RTCRayHit ray;
  ray.ray.org_x = static_cast<float>(origin.x);
  ray.ray.org_y = static_cast<float>(origin.y);
  ray.ray.org_z = static_cast<float>(origin.z);
  ray.ray.dir_x = static_cast<float>(direction.x);
  ray.ray.dir_y = static_cast<float>(direction.y);
  ray.ray.dir_z = static_cast<float>(direction.z);
  ray.ray.tnear = near;
  ray.ray.tfar = far;
  ray.ray.time = 0;
  ray.ray.mask = ~0u;
  ray.ray.id = 0;
  ray.ray.flags = 0;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

}  // namespace

struct EmbreeMesh::Scene {
  std::shared_ptr<Device> device = shared_device();
  RTCScene scene = embree().rtcNewScene(device->device);
  ~Scene() { embree().rtcReleaseScene(scene); }
};

EmbreeMesh::EmbreeMesh(const std::vector<glm::vec3>& vertices,
                       const std::vector<std::array<int32_t, 3>>& faces, const Bounds& bounds)
    : scene_(std::make_unique<Scene>()), bounds_(bounds), center_(bounds.center()) {
  const RTCGeometry geometry =
      embree().rtcNewGeometry(scene_->device->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(
      embree().rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), vertices.size()));
  for (size_t i = 0; i < vertices.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      points[3 * i + axis] = static_cast<float>(static_cast<double>(vertices[i][axis]) -
                                                center_[axis]);
    }
  }
  embree().rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, faces.data(), 0,
                             3 * sizeof(int32_t), faces.size());
  embree().rtcCommitGeometry(geometry);
  embree().rtcAttachGeometry(scene_->scene, geometry);
  embree().rtcReleaseGeometry(geometry);
  embree().rtcSetSceneFlags(scene_->scene, static_cast<RTCSceneFlags>(
                                      RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT |
                                      RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  // By one thread: the order within leaves must not depend on how many there are.
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  embree().rtcCommitScene(scene_->scene);
}

EmbreeMesh::~EmbreeMesh() = default;

bool EmbreeMesh::approach(const Vec3& origin, const Vec3& direction, double& advance) const {
  const Vec3 size = bounds_.size();
  const double margin = 1e-5 * std::max({size.x, size.y, size.z});
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = bounds_.min[axis] - margin, high = bounds_.max[axis] + margin;
    const double d = direction[axis], o = origin[axis];
    if (d == 0) {
      if (o < low || o > high) return false;
      continue;
    }
    const double a = (low - o) / d, b = (high - o) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  advance = enter;
  return enter <= leave;
}

bool EmbreeMesh::nearest(const Vec3& origin, const Vec3& direction, double min_depth,
                         double max_depth, uint32_t& face) const {
  double advance;
  if (!approach(origin, direction, advance) || advance > max_depth) return false;
  const float near = static_cast<float>(std::max(0.0, min_depth - advance) * (1 - 1e-6));
  const float far = static_cast<float>((max_depth - advance) * (1 + 1e-6));
  RTCRayHit ray = ray_from(origin + advance * direction - center_, direction, near, far);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  embree().rtcIntersect1(scene_->scene, &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  face = ray.hit.primID;
  return true;
}

void EmbreeMesh::visit_all(const Vec3& origin, const Vec3& direction, double max_depth,
                           TriangleVisitor visitor, void* data) const {
  double advance;
  if (!approach(origin, direction, advance) || advance > max_depth) return;
  RTCRayHit ray = ray_from(origin + advance * direction - center_, direction, 0,
                           static_cast<float>((max_depth - advance) * (1 + 1e-6)));
  VisitContext context;
  rtcInitIntersectContext(&context.context);
  context.context.filter = decline;
  context.visitor = visitor;
  context.data = data;
  embree().rtcIntersect1(scene_->scene, &context.context, &ray);
}

}  // namespace durer
