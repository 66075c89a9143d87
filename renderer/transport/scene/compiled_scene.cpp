#include "renderer/transport/scene/compiled_scene.h"

#include <algorithm>
#include <utility>

namespace transport {
namespace {

template <class Value>
Value interpolate(const std::vector<Value>& values, const std::uint32_t* corners, const TriangleHit& hit) {
  return values[corners[0]] * (1 - hit.u - hit.v) + values[corners[1]] * hit.u + values[corners[2]] * hit.v;
}

}  // namespace

std::vector<std::string> Effects::names() const {
  std::vector<std::string> names;
  const auto add = [&](bool present, const char* name) {
    if (present) names.emplace_back(name);
  };
  add(area_lights, "area_lights");
  add(diffuse_reflection, "diffuse_reflection");
  add(glossy_reflection, "glossy_reflection");
  add(mirror_reflection, "mirror_reflection");
  add(anisotropy, "anisotropy");
  add(interpolated_normals, "interpolated_normals");
  add(vertex_colours, "vertex_colours");
  return names;
}

CompiledScene::CompiledScene(Geometry geometry, std::vector<CompiledSurface> surfaces,
                             ReflectorSet reflectors, Lights lights)
    : geometry_(std::move(geometry)),
      surfaces_(std::move(surfaces)),
      reflectors_(std::move(reflectors)),
      lights_(std::move(lights)),
      caster_(geometry_.positions, geometry_.triangles) {}

std::optional<SurfacePoint> CompiledScene::intersect(const Ray& ray) const {
  const auto hit = caster_.intersect(ray);
  if (!hit) return std::nullopt;
  return point_at(*hit);
}

SurfacePoint CompiledScene::point_at(const TriangleHit& hit) const {
  const std::uint32_t* corners = &geometry_.triangles[3 * static_cast<std::size_t>(hit.triangle)];
  const Vec3f& a = geometry_.positions[corners[0]];
  const Vec3f& b = geometry_.positions[corners[1]];
  const Vec3f& c = geometry_.positions[corners[2]];
  const TriangleSurface& triangle = geometry_.triangle_surfaces[hit.triangle];
  SurfacePoint point;
  point.surface = &surfaces_[triangle.surface];
  // From the corners and not along the ray: the error is then that of one interpolation. That of Embree's
  // test of the next ray against this triangle grows with the whole triangle, so all of its corners count in
  // full.
  point.position = interpolate(geometry_.positions, corners, hit);
  point.error = (absolute(a) + absolute(b) + absolute(c)) * InterpolationError;
  point.geometric_normal = (b - a).cross(c - a).normalized();
  point.shading_normal = point.geometric_normal;
  if (!triangle.is_flat) {
    const Vec3f normal = interpolate(geometry_.normals, corners, hit);
    if (normal.length2() > 0) point.shading_normal = normal.normalized();
  }
  point.colour = point.surface->colour;
  if (!geometry_.colours.empty()) point.colour *= interpolate(geometry_.colours, corners, hit);
  if (!geometry_.emitter_of_triangle.empty()) point.emitter = geometry_.emitter_of_triangle[hit.triangle];
  return point;
}

bool CompiledScene::is_matte() const {
  return std::all_of(reflectors_.reflectors.begin(), reflectors_.reflectors.end(),
                     [](const reflectance::Reflector& reflector) { return reflector.is_matte(); });
}

Effects CompiledScene::effects() const {
  Effects effects;
  effects.area_lights = !lights_.empty();
  effects.interpolated_normals =
      std::any_of(geometry_.triangle_surfaces.begin(), geometry_.triangle_surfaces.end(),
                  [](const TriangleSurface& triangle) { return !triangle.is_flat; });
  effects.vertex_colours = !geometry_.colours.empty();
  for (const reflectance::Reflector& reflector : reflectors_.reflectors) {
    const reflectance::Brdf& brdf = reflector.brdf();
    if (reflectance::has_mirror(brdf)) effects.mirror_reflection = true;
    if (reflectance::has_diffuse_part(brdf)) effects.diffuse_reflection = true;
    if (reflectance::has_glossy_part(brdf)) effects.glossy_reflection = true;
    if (reflectance::is_anisotropic(brdf)) effects.anisotropy = true;
  }
  return effects;
}

}  // namespace transport
