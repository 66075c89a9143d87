#include "renderer/transport/scene/ray_caster.h"

#include <limits>
#include <new>
#include <stdexcept>

#include <embree3/rtcore.h>

namespace transport {
namespace {

void share_geometry(RTCGeometry geometry, std::span<const Vec3f> positions,
                    std::span<const std::uint32_t> triangles) {
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0,
                             sizeof(Vec3f), positions.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(), 0,
                             3 * sizeof(std::uint32_t), triangles.size() / 3);
}

RTCRay to_embree(const Ray& ray, float farthest) {
  RTCRay embree_ray;
  embree_ray.org_x = ray.origin.x;
  embree_ray.org_y = ray.origin.y;
  embree_ray.org_z = ray.origin.z;
  // Not 0, at which a ray that starts in the plane of an axis-aligned triangle would meet it: there the error
  // bound by which origins are moved off a surface is 0.
  embree_ray.tnear = std::numeric_limits<float>::min();
  embree_ray.dir_x = ray.direction.x;
  embree_ray.dir_y = ray.direction.y;
  embree_ray.dir_z = ray.direction.z;
  embree_ray.time = 0;
  embree_ray.tfar = farthest;
  embree_ray.mask = std::numeric_limits<unsigned>::max();
  embree_ray.id = 0;
  embree_ray.flags = 0;
  return embree_ray;
}

}  // namespace

struct RayCaster::Scene {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  bool meets_anything(const Ray& ray, float farthest) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = to_embree(ray, farthest);
    rtcOccluded1(scene, &context, &query);
    return query.tfar < 0;
  }
};

RayCaster::RayCaster(std::span<const Vec3f> positions, std::span<const std::uint32_t> triangles)
    : scene_(std::make_unique<Scene>()) {
  scene_->device = rtcNewDevice(nullptr);
  if (scene_->device == nullptr) throw std::runtime_error("Embree cannot start on this machine");
  scene_->scene = rtcNewScene(scene_->device);
  rtcSetSceneFlags(scene_->scene, RTC_SCENE_FLAG_ROBUST);
  if (!triangles.empty()) {
    RTCGeometry geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    share_geometry(geometry, positions, triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_->scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene_->scene);
  if (rtcGetDeviceError(scene_->device) != RTC_ERROR_NONE) throw std::bad_alloc();
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

std::optional<TriangleHit> RayCaster::intersect(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query;
  query.ray = to_embree(ray, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return TriangleHit{query.hit.primID, query.hit.u, query.hit.v};
}

bool RayCaster::is_occluded(const Ray& ray) const { return scene_->meets_anything(ray, 1 - 1e-4F); }

bool RayCaster::escapes(const Ray& ray) const {
  return !scene_->meets_anything(ray, std::numeric_limits<float>::infinity());
}

}  // namespace transport
