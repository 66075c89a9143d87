#include "renderer/transport/scene/ray_caster.h"

#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/format.h>

namespace transport {
namespace {

constexpr float Infinity = std::numeric_limits<float>::infinity();

/// The context of a ray, which Embree passes to the filter.
struct RayContext {
  RTCIntersectContext embree;
  HitFilter* filter;
};

/// The context of a shadow ray, with the triangles that the ray ignores.
struct ShadowContext {
  RTCIntersectContext embree;
  HitFilter* filter;
  TriangleId from;
  TriangleId target;
  std::uint32_t target_count = 0;

  bool passes(const TriangleId& id) const {
    if (id == from) return true;
    return id.instance == target.instance && id.triangle - target.triangle < target_count;
  }
};

// The first mesh is no instance for Embree, but instance 0 here.
std::uint32_t instance_of(unsigned embree_instance) {
  return embree_instance == RTC_INVALID_GEOMETRY_ID ? 0 : embree_instance;
}

TriangleId triangle_of(const RTCFilterFunctionNArguments& arguments, unsigned i) {
  return {instance_of(RTCHitN_instID(arguments.hit, arguments.N, i, 0)),
          RTCHitN_primID(arguments.hit, arguments.N, i)};
}

TriangleHit hit_of(const RTCFilterFunctionNArguments& arguments, unsigned i) {
  return {triangle_of(arguments, i), RTCHitN_u(arguments.hit, arguments.N, i),
          RTCHitN_v(arguments.hit, arguments.N, i), RTCRayN_tfar(arguments.ray, arguments.N, i)};
}

void filter_hits(const RTCFilterFunctionNArguments* arguments) {
  const auto* context = reinterpret_cast<const RayContext*>(arguments->context);
  if (context->filter == nullptr) return;
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    if (!context->filter->stops(hit_of(*arguments, i))) arguments->valid[i] = 0;
  }
}

void filter_shadow_hits(const RTCFilterFunctionNArguments* arguments) {
  const auto* context = reinterpret_cast<const ShadowContext*>(arguments->context);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    if (context->passes(triangle_of(*arguments, i))) arguments->valid[i] = 0;
  }
}

void filter_shadow_hits_of_cutouts(const RTCFilterFunctionNArguments* arguments) {
  filter_shadow_hits(arguments);
  filter_hits(arguments);
}

RTCRay to_embree(const Ray& ray, float nearest, float farthest) {
  RTCRay embree_ray;
  embree_ray.org_x = ray.origin.x;
  embree_ray.org_y = ray.origin.y;
  embree_ray.org_z = ray.origin.z;
  embree_ray.tnear = nearest;
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

// Not 0, or a ray that starts in the plane of an axis-aligned triangle would hit it: there the error bound
// that offsets origins from a surface is 0.
constexpr float Nearest = std::numeric_limits<float>::min();

bool collect_triangle(RTCPointQueryFunctionArguments* arguments) {
  const RTCPointQueryContext& context = *arguments->context;
  const unsigned instance = context.instStackSize == 0 ? RTC_INVALID_GEOMETRY_ID : context.instID[0];
  static_cast<std::vector<TriangleId>*>(arguments->userPtr)
      ->push_back({instance_of(instance), arguments->primID});
  return false;  // the distance has not shrunk
}

RTCGeometry triangles_of(RTCDevice device, const TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data(), 0,
                             sizeof(Vec3f), mesh.positions.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                             sizeof(Triangle), mesh.triangles.size());
  if (mesh.has_cutouts) {
    rtcSetGeometryIntersectFilterFunction(geometry, filter_hits);
    rtcSetGeometryOccludedFilterFunction(geometry, filter_shadow_hits_of_cutouts);
  } else {
    rtcSetGeometryOccludedFilterFunction(geometry, filter_shadow_hits);
  }
  rtcCommitGeometry(geometry);
  return geometry;
}

/// Attaches a geometry and releases it.
void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

RTCGeometry instance_of(RTCDevice device, RTCScene scene, const AffineMap& map) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, scene);
  const auto& m = map.linear;
  const std::array<float, 12> columns = {m[0][0], m[0][1],           m[0][2],           m[1][0],
                                         m[1][1], m[1][2],           m[2][0],           m[2][1],
                                         m[2][2], map.translation.x, map.translation.y, map.translation.z};
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  rtcCommitGeometry(geometry);
  return geometry;
}

/// The first error reported by Embree.
struct EmbreeError {
  RTCError code = RTC_ERROR_NONE;
  std::string text;
};

void keep_first_error(void* to, RTCError code, const char* text) {
  auto& error = *static_cast<EmbreeError*>(to);
  if (error.code == RTC_ERROR_NONE) error = {code, text != nullptr ? text : ""};
}

[[noreturn]] void throw_error(const EmbreeError& error) {
  if (error.code == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(
      fmt::format("Embree reports error {}: {}", static_cast<int>(error.code), error.text));
}

}  // namespace

struct RayCaster::Scenes {
  std::shared_ptr<const Geometry> geometry;  ///< whose arrays Embree reads
  RTCDevice device = nullptr;
  EmbreeError error;  ///< of the device; only building reports any
  RTCScene top = nullptr;
  std::vector<RTCScene> meshes;  ///< of instances; null for the first mesh

  explicit Scenes(std::shared_ptr<const Geometry> of);
  Scenes(const Scenes&) = delete;
  Scenes& operator=(const Scenes&) = delete;
  ~Scenes() {
    if (top != nullptr) rtcReleaseScene(top);
    for (RTCScene mesh : meshes) {
      if (mesh != nullptr) rtcReleaseScene(mesh);
    }
    if (device != nullptr) rtcReleaseDevice(device);
  }

  RTCScene new_scene() const {
    RTCScene scene = rtcNewScene(device);
    check();
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    return scene;
  }
  /// Builds on the threads of the enclosing TBB arena.
  void commit(RTCScene scene) const {
    check();  // Embree would build from rejected data, and crash
    rtcCommitScene(scene);
    check();
  }
  void check() const {
    if (error.code != RTC_ERROR_NONE) throw_error(error);
  }
  void build_meshes();
  void build_top();

  bool intersects_any(const Ray& ray, float farthest, const TriangleId& target, std::uint32_t count,
                      HitFilter* filter) const {
    ShadowContext context{{}, filter, ray.from, target, count};
    rtcInitIntersectContext(&context.embree);
    RTCRay query = to_embree(ray, Nearest, farthest);
    rtcOccluded1(top, &context.embree, &query);
    return query.tfar < 0;
  }
};

// Embree would choose the instruction set of the processor, and with another one hits differ in their last
// bits: an image must not depend on the machine. AVX2 is what all of the program is compiled for.
RayCaster::Scenes::Scenes(std::shared_ptr<const Geometry> of)
    : geometry(std::move(of)), device(rtcNewDevice("isa=avx2")) {
  if (device == nullptr) throw_error({rtcGetDeviceError(nullptr), "it cannot start on this processor"});
  rtcSetDeviceErrorFunction(device, keep_first_error, &error);
}

void RayCaster::Scenes::build_meshes() {
  meshes.resize(geometry->meshes.size(), nullptr);
  for (std::size_t i = 1; i < meshes.size(); ++i) {
    meshes[i] = new_scene();
    attach(meshes[i], triangles_of(device, geometry->meshes[i]), 0);
    commit(meshes[i]);
  }
}

void RayCaster::Scenes::build_top() {
  top = new_scene();
  const TriangleMesh& first = geometry->meshes[0];
  if (!first.triangles.empty()) attach(top, triangles_of(device, first), 0);
  for (std::size_t i = 1; i < geometry->instances.size(); ++i) {
    const Instance& instance = geometry->instances[i];
    attach(top, instance_of(device, meshes[instance.mesh], instance.to_scene), static_cast<unsigned>(i));
  }
  commit(top);
}

RayCaster::RayCaster(std::shared_ptr<const Geometry> geometry) {
  const auto scenes = std::make_shared<Scenes>(std::move(geometry));
  scenes->build_meshes();
  scenes->build_top();
  scenes_ = scenes;
}

bool RayCaster::serves(const Geometry& geometry) const {
  return have_same_shape(*scenes_->geometry, geometry);
}

// A ray that hits the triangle that it leaves is continued behind it: rare enough for a second query, which
// costs other rays nothing, unlike a filter.
std::optional<TriangleHit> RayCaster::intersect(const Ray& ray, HitFilter* filter) const {
  RayContext context{{}, filter};
  rtcInitIntersectContext(&context.embree);
  float nearest = Nearest;
  while (true) {
    RTCRayHit query;
    query.ray = to_embree(ray, nearest, Infinity);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scenes_->top, &context.embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const TriangleId id = {instance_of(query.hit.instID[0]), query.hit.primID};
    if (id != ray.from) return TriangleHit{id, query.hit.u, query.hit.v, query.ray.tfar};
    nearest = std::nextafter(query.ray.tfar, Infinity);
  }
}

bool RayCaster::is_occluded(const Ray& ray, const TriangleId& target, std::uint32_t count,
                            HitFilter* filter) const {
  return scenes_->intersects_any(ray, 1, target, count, filter);
}

bool RayCaster::is_unoccluded(const Ray& ray, HitFilter* filter) const {
  return !scenes_->intersects_any(ray, Infinity, {}, 0, filter);
}

std::vector<TriangleId> RayCaster::triangles_near(const Vec3f& point, float distance) const {
  std::vector<TriangleId> found;
  RTCPointQuery query;
  query.x = point.x;
  query.y = point.y;
  query.z = point.z;
  query.time = 0;
  query.radius = distance;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scenes_->top, &query, &context, collect_triangle, &found);
  return found;
}

}  // namespace transport
