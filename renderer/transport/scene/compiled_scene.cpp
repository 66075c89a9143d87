#include "renderer/transport/scene/compiled_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/transport/scene/hit.h"

namespace transport {
namespace {

using grf::Vec3d;

/// The rounding of a triangle's corners, relative to the bound of the error of points that are interpolated
/// between them.
constexpr double CornerRounding = 0x1p-24 / InterpolationError;

/// The plane of a triangle of the scene.
struct FacePlane {
  Vec3d corner;
  Vec3d normal;      ///< unit, or 0
  double error = 0;  ///< bounds the error of a point of the triangle along the normal
};

FacePlane plane_of(const Geometry& geometry, const TriangleId& id) {
  const Instance& instance = geometry.instances[id.instance];
  const TriangleMesh& mesh = geometry.meshes[instance.mesh];
  const auto corner = [&](std::size_t i) {
    const Vec3d position(mesh.positions[mesh.triangles[id.triangle].corners[i]]);
    if (id.instance == 0) return position;
    return position * Imath::M33d(instance.to_scene.linear) + Vec3d(instance.to_scene.translation);
  };
  const Vec3d a = corner(0);
  const Vec3d normal = (corner(1) - a).cross(corner(2) - a).normalized();
  constexpr float Middle = 1 / 3.0F;
  const SurfacePoint middle = HitTriangle(geometry, {id, Middle, Middle, 0}, Ray()).point();
  return {a, normal, Vec3d(absolute(Vec3f(normal))).dot(Vec3d(middle.error))};
}

}  // namespace

CompiledScene::CompiledScene(std::shared_ptr<const Geometry> geometry, RayCaster caster,
                             std::vector<CompiledSurface> surfaces, ReflectorSet reflectors,
                             std::vector<TextureFile> textures, std::vector<Emitter> emitters)
    : geometry_(std::move(geometry)),
      surfaces_(std::move(surfaces)),
      reflectors_(std::move(reflectors)),
      textures_(std::move(textures)),
      lights_(std::move(emitters)),
      caster_(std::move(caster)) {}

std::optional<SurfacePoint> CompiledScene::intersect(const Ray& ray) const {
  const auto met = caster_.intersect(ray);
  if (!met) return std::nullopt;
  const HitTriangle hit(*geometry_, *met, ray);
  const CompiledSurface& surface = surfaces_[hit.instance().first_surface + hit.triangle().surface];
  std::optional<SurfacePoint> point = hit.point();
  point->surface = &surface;
  point->colour = surface.colour * hit.vertex_colour();
  point->irradiance = hit.irradiance();
  if (surface.texture != InvalidIndex) {
    const Texture& texture = *textures_[surface.texture].texture;
    point->colour *= texture.lookup(hit.uv(), hit.uv_scale() * point->cone.width);
  }
  if (surface.is_anisotropic) point->tangent = hit.tangent(surface.axis, point->shading_normal);
  if (!reflectance::is_black(surface.emission)) {
    const TriangleMesh& mesh = geometry_->meshes[hit.instance().mesh];
    point->emitter =
        geometry_->emitter_table[hit.instance().first_emitter + mesh.emitting_number(met->id.triangle)];
  }
  if (!hit.triangle().is_flat && surface.reflector != InvalidIndex)
    point->terminator_offset = hit.terminator_offset();
  return point;
}

SurfacePoint CompiledScene::front_point(const TriangleId& id, const Vec2f& weights) const {
  const TriangleHit met{id, weights.x, weights.y, 0};
  const Vec3f normal = HitTriangle(*geometry_, met, Ray()).point().geometric_normal;
  const Ray ray{Vec3f(0), -normal};
  const HitTriangle hit(*geometry_, met, ray);
  SurfacePoint point = hit.point();
  point.surface = &surfaces_[hit.instance().first_surface + hit.triangle().surface];
  point.colour = Rgb(1);
  if (!hit.triangle().is_flat) point.terminator_offset = hit.terminator_offset();
  return point;
}

std::optional<RayStart> CompiledScene::offset_start(const SurfacePoint& point, const Vec3f& geometric_side,
                                                    std::uint64_t& rays) const {
  // A smaller offset does not leave the triangle; normals that point away from it may even lead below it.
  const float least = 4 * absolute(point.geometric_normal).dot(point.error);
  if (!(point.terminator_offset.dot(geometric_side) > least)) return std::nullopt;
  const Vec3f foot =
      offset_towards(point.position, point.error, point.geometric_normal, point.terminator_offset);
  const Vec3f raised = point.position + point.terminator_offset;
  ++rays;
  if (caster_.is_occluded({foot, raised - foot, point.id})) return std::nullopt;
  return RayStart{raised, TriangleId()};
}

Vec3d CompiledScene::off_faces(const Vec3d& point, const Vec3d& direction) const {
  if (bounds().isEmpty()) return point;
  const Vec3d farthest(
      std::max(std::abs(bounds().min.x - origin().x), std::abs(bounds().max.x - origin().x)),
      std::max(std::abs(bounds().min.y - origin().y), std::abs(bounds().max.y - origin().y)),
      std::max(std::abs(bounds().min.z - origin().z), std::abs(bounds().max.z - origin().z)));
  // Twice the largest error of three corners, since the point is rounded too.
  const double reach = 2 * 3 * InterpolationError * farthest.length();
  std::vector<FacePlane> planes;
  for (const TriangleId& id : caster_.triangles_near(Vec3f(point), static_cast<float>(reach))) {
    planes.push_back(plane_of(*geometry_, id));
  }
  // In an edge or corner, moving off one face may lead back to another.
  constexpr int Passes = 4;
  Vec3d moved = point;
  for (int pass = 0; pass < Passes; ++pass) {
    for (const FacePlane& plane : planes) {
      const double height = (moved - plane.corner).dot(plane.normal);
      if (std::abs(height) >= plane.error) continue;
      const double side =
          std::abs(height) > CornerRounding * plane.error ? height : direction.dot(plane.normal);
      moved += plane.normal * (std::copysign(plane.error, side) - height);
    }
  }
  return moved;
}

bool CompiledScene::is_occluded(const Ray& ray, std::uint32_t emitter) const {
  if (emitter == InvalidIndex) return caster_.is_occluded(ray);
  return caster_.is_occluded(ray, geometry_->emitter_triangles[emitter],
                             lights_[emitter].is_triangle ? 1 : 2);
}

std::size_t CompiledScene::triangle_count() const {
  std::size_t count = 0;
  for (const Instance& instance : geometry_->instances) {
    count += geometry_->meshes[instance.mesh].triangles.size();
  }
  return count;
}

std::size_t CompiledScene::bytes() const {
  std::size_t bytes = geometry_->bytes() + surfaces_.capacity() * sizeof(CompiledSurface);
  for (const TextureFile& file : textures_) bytes += file.texture->bytes();
  return bytes;
}

bool CompiledScene::is_diffuse() const {
  return std::all_of(reflectors_.reflectors.begin(), reflectors_.reflectors.end(),
                     [](const reflectance::Reflector& reflector) { return reflector.is_diffuse(); });
}

}  // namespace transport
