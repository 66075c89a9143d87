#include "converters/renderers/render_scene.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "converters/renderers/shape_geometry.h"
#include "grf/keywords.h"

namespace convert {
namespace {

/// Collects the shapes of a scene as it is visited.
class RenderSceneBuilder {
 public:
  explicit RenderSceneBuilder(grf::Diagnostics& diagnostics) : maker_(diagnostics) {}

  void add(const grf::Mesh& mesh, const grf::Placement& placement);
  void add_light(const grf::Mesh& mesh, const grf::Placement& placement);
  void add_light(const grf::AreaLight& light, const grf::Placement& placement);
  void add_observers(const grf::Params& params) { scene_.losses.add(Loss::Observer, params.views.size()); }

  std::optional<RenderScene> finish() {
    if (has_failed_) return std::nullopt;
    return std::move(scene_);
  }

 private:
  std::vector<RenderShape> shapes_of(const grf::Mesh& mesh, const grf::Placement& placement);
  std::size_t material_of(grf::ResolvedSurface surface, const RenderShape& shape, std::size_t faces);
  void count_losses(const grf::Mesh& mesh, const std::string& name);
  void grow(const grf::Mesh& mesh, const grf::Matrix44d& to_world);

  reflectance::BrdfMaker maker_;
  RenderScene scene_;
  std::map<std::string, std::size_t> material_of_key_;
  std::map<const grf::Definition*, std::size_t> object_of_definition_;
  bool has_failed_ = false;
};

// Mitsuba's `mask` keeps the light of an emitter, and pbrt takes an area light with `alpha` 0 for one that
// lights without being seen.
bool is_absent(const grf::Opacity& opacity) {
  return opacity.value == 0 && opacity.kind != grf::Opacity::Kind::Mask;
}

void RenderSceneBuilder::grow(const grf::Mesh& mesh, const grf::Matrix44d& to_world) {
  for (const grf::Vec3f& position : mesh.geometry->positions) {
    scene_.bounds.extendBy(grf::Vec3d(position) * to_world);
  }
}

// Only a diffuse BRDF without texture can have colours of vertices in renderers: others get their mean.
std::size_t RenderSceneBuilder::material_of(grf::ResolvedSurface surface, const RenderShape& shape,
                                            std::size_t faces) {
  const grf::BrdfModel fallback = reflectance::default_model();
  const grf::BrdfModel& model = surface.brdf != nullptr ? *surface.brdf : fallback;
  const bool is_unlit = surface.brdf == nullptr && surface.emission.has_value();
  if (is_unlit) surface.colour = grf::Colour(0);
  if (is_unlit) surface.texture = nullptr;
  const std::string texture = surface.texture != nullptr ? surface.texture->file : "";
  const bool reads_alpha = !texture.empty() && surface.opacity.reads_alpha();
  const bool is_coloured = !is_unlit && !shape.mesh->geometry->colours.empty();
  const bool varies = is_coloured && texture.empty() && grf::same_keyword(model.keyword, "diffuse");
  if (is_coloured && !varies) {
    surface.colour *= mean_vertex_colour(shape);
    scene_.losses.add(Loss::BrdfVertexColour, faces);
  }
  const grf::Colour& colour = surface.colour;
  const std::string key = fmt::format("{} {} {} {} {} {} {}", maker_.identity(model, surface.brdf_scope),
                                      colour.x, colour.y, colour.z, varies, reads_alpha, texture);
  const auto [known, is_new] = material_of_key_.emplace(key, scene_.materials.size());
  if (is_new) {
    auto brdf = maker_.make(model, surface.brdf_scope);
    has_failed_ = has_failed_ || !brdf;
    scene_.materials.push_back({is_unlit ? "black" : grf::lower_case(model.keyword),
                                brdf.value_or(reflectance::default_brdf()), colour, texture, reads_alpha,
                                varies});
  }
  scene_.materials[known->second].faces += faces;
  return known->second;
}

void RenderSceneBuilder::count_losses(const grf::Mesh& mesh, const std::string& name) {
  if (!name.empty()) scene_.losses.add(Loss::MeshName);
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    if (mesh.face(i).size() > 3) scene_.losses.add(Loss::Polygon);
  }
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    if (mesh.irradiance->has(i)) scene_.losses.add(Loss::Irradiance);
  }
}

std::vector<RenderShape> RenderSceneBuilder::shapes_of(const grf::Mesh& mesh,
                                                       const grf::Placement& placement) {
  std::vector<std::size_t> faces(mesh.surfaces.size());
  for (const std::uint32_t surface : *mesh.surface_of_face) ++faces[surface];
  std::string name = mesh.name;
  if (name.empty() && placement.instance_of != nullptr)
    name = grf::from_identifier(placement.instance_of->name);
  count_losses(mesh, name);
  std::vector<RenderShape> shapes;
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    if (faces[i] == 0) continue;
    const grf::ResolvedSurface surface = grf::resolve(mesh.surfaces[i], placement.scope);
    if (is_absent(surface.opacity)) continue;
    RenderShape shape;
    shape.name = name;
    shape.mesh = &mesh;
    shape.surface = static_cast<std::uint32_t>(i);
    shape.to_world = placement.to_world;
    shape.material = material_of(surface, shape, faces[i]);
    if (surface.emission && !reflectance::is_black(*surface.emission)) shape.emission = surface.emission;
    if (shape.emission && !mesh.geometry->normals.empty()) scene_.losses.add(Loss::EmitterNormal, faces[i]);
    if (surface.pdf != nullptr) scene_.losses.add(Loss::SamplingScheme, faces[i]);
    if (surface.brdf != nullptr && has_maps(*surface.brdf)) scene_.losses.add(Loss::ParameterMap, faces[i]);
    shape.opacity = surface.opacity;
    if (surface.opacity.reads_alpha()) shape.alpha = surface.texture->file;
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

void RenderSceneBuilder::add(const grf::Mesh& mesh, const grf::Placement& placement) {
  grow(mesh, placement.to_world);
  const auto known = object_of_definition_.find(placement.instance_of);
  if (placement.instance_of != nullptr && known != object_of_definition_.end()) {
    scene_.instances.push_back({known->second, placement.to_world});
    return;
  }
  std::vector<RenderShape> shapes = shapes_of(mesh, placement);
  if (shapes.empty()) return;
  const bool emits = std::any_of(shapes.begin(), shapes.end(),
                                 [](const RenderShape& shape) { return shape.emission.has_value(); });
  if (placement.instance_of == nullptr || emits || !mesh.geometry->colours.empty()) {
    scene_.shapes.insert(scene_.shapes.end(), shapes.begin(), shapes.end());
    return;
  }
  for (RenderShape& shape : shapes) shape.to_world = grf::Matrix44d();
  object_of_definition_[placement.instance_of] = scene_.objects.size();
  scene_.instances.push_back({scene_.objects.size(), placement.to_world});
  scene_.objects.push_back(std::move(shapes));
}

// The colour of a mesh light is its radiance.
void RenderSceneBuilder::add_light(const grf::Mesh& mesh, const grf::Placement& placement) {
  grow(mesh, placement.to_world);
  const std::vector<bool> used = grf::used_surfaces(mesh);
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    if (!used[i]) continue;
    grf::ResolvedSurface surface;
    surface.emission = grf::resolve(mesh.surfaces[i], placement.scope).colour;
    RenderShape shape;
    shape.name = "light";
    shape.mesh = &mesh;
    shape.surface = static_cast<std::uint32_t>(i);
    shape.to_world = placement.to_world;
    shape.material = material_of(surface, shape, 1);
    if (!reflectance::is_black(*surface.emission)) shape.emission = surface.emission;
    scene_.shapes.push_back(std::move(shape));
  }
}

void RenderSceneBuilder::add_light(const grf::AreaLight& light, const grf::Placement& placement) {
  grf::MeshDraft mesh;
  mesh.positions = {light.corner, light.corner + light.edge1, light.corner + light.edge1 + light.edge2,
                    light.corner + light.edge2};
  if (light.radiance) mesh.surfaces.front().colour = *light.radiance;
  mesh.add_face(std::array<std::uint32_t, 4>{0, 1, 2, 3}, 0);
  add_light(scene_.parallelograms.emplace_back(std::move(mesh)), placement);
}

}  // namespace

std::optional<RenderScene> render_scene_of(const grf::Scene& scene, grf::Diagnostics& diagnostics) {
  RenderSceneBuilder builder(diagnostics);
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    builder.add(mesh, placement);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement& placement, const grf::Block&) {
    builder.add_light(*light.mesh, placement);
  };
  visitor.light = [&](const grf::AreaLight& light, const grf::Placement& placement, const grf::Block&) {
    builder.add_light(light, placement);
  };
  visitor.params = [&](const grf::Params& params, const grf::Placement&, const grf::Block&) {
    builder.add_observers(params);
  };
  grf::visit(scene, visitor);
  return builder.finish();
}

}  // namespace convert
