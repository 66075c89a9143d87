#include "renderer/transport/scene/compiled_scene.h"

#include <algorithm>
#include <utility>

#include "renderer/transport/scene/hit.h"

namespace transport {

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
  add(textures, "textures");
  return names;
}

CompiledScene::CompiledScene(Geometry geometry, std::vector<CompiledSurface> surfaces,
                             ReflectorSet reflectors, std::vector<Texture> textures,
                             std::vector<Emitter> emitters)
    : geometry_(std::make_unique<const Geometry>(std::move(geometry))),
      surfaces_(std::move(surfaces)),
      reflectors_(std::move(reflectors)),
      textures_(std::move(textures)),
      lights_(std::move(emitters)),
      caster_(*geometry_) {}

std::optional<SurfacePoint> CompiledScene::intersect(const Ray& ray) const {
  const auto met = caster_.intersect(ray);
  if (!met) return std::nullopt;
  const HitTriangle hit(*geometry_, *met, ray);
  const CompiledSurface& surface = surfaces_[hit.instance().first_surface + hit.triangle().surface];
  std::optional<SurfacePoint> point = hit.point();
  point->surface = &surface;
  point->colour = surface.colour * hit.vertex_colour();
  point->irradiance = hit.irradiance();
  if (surface.texture != None) {
    const Texture& texture = textures_[surface.texture];
    point->colour *= texture.lookup(hit.uv(), hit.uv_scale() * point->cone.width);
  }
  if (surface.is_anisotropic) point->tangent = hit.tangent(surface.axis, point->shading_normal);
  if (!reflectance::is_black(surface.emission)) {
    const TriangleMesh& mesh = geometry_->meshes[hit.instance().mesh];
    point->emitter =
        geometry_->emitter_table[hit.instance().first_emitter + mesh.emitting_number(met->id.triangle)];
  }
  if (!hit.triangle().is_flat && surface.reflector != None) point->rise = hit.rise();
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
  if (!hit.triangle().is_flat) point.rise = hit.rise();
  return point;
}

std::optional<RayStart> CompiledScene::raised_start(const SurfacePoint& point,
                                                    const Vec3f& geometric_side) const {
  // Less than that is no way up from the triangle; normals that point away from it may lead down.
  const float least = 4 * absolute(point.geometric_normal).dot(point.error);
  if (!(point.rise.dot(geometric_side) > least)) return std::nullopt;
  const Vec3f foot = offset_towards(point.position, point.error, point.geometric_normal, point.rise);
  const Vec3f raised = point.position + point.rise;
  if (caster_.is_occluded({foot, raised - foot, point.id})) return std::nullopt;
  return RayStart{raised, TriangleId()};
}

bool CompiledScene::is_occluded(const Ray& ray, std::uint32_t emitter) const {
  if (emitter == None) return caster_.is_occluded(ray);
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
  for (const Texture& texture : textures_) bytes += texture.bytes();
  return bytes;
}

bool CompiledScene::is_matte() const {
  return std::all_of(reflectors_.reflectors.begin(), reflectors_.reflectors.end(),
                     [](const reflectance::Reflector& reflector) { return reflector.is_matte(); });
}

Effects CompiledScene::geometry_effects() const {
  Effects effects;
  for (const TriangleMesh& mesh : geometry_->meshes) {
    if (!mesh.colours.empty()) effects.vertex_colours = true;
    if (mesh.normals.empty() || effects.interpolated_normals) continue;
    effects.interpolated_normals = std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                                               [](const Triangle& triangle) { return !triangle.is_flat; });
  }
  return effects;
}

Effects CompiledScene::effects() const {
  Effects effects = geometry_effects();
  effects.area_lights = !lights_.empty();
  effects.textures = !textures_.empty();
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
