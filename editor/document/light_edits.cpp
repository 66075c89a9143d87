#include "editor/document/light_edits.h"

#include <numbers>
#include <string>
#include <string_view>
#include <variant>

#include "editor/document/scene_places.h"
#include "grf/summary.h"

namespace editor {
namespace {

double mean(const grf::Colour& colour) {
  return (static_cast<double>(colour.x) + static_cast<double>(colour.y) + static_cast<double>(colour.z)) / 3;
}

/// The radiance of a mesh's surface, or nothing if it does not emit.
std::optional<grf::Colour> emission_of(const MeshObject& mesh, std::size_t surface) {
  const FlatSurface& flat_surface = mesh.flat_surfaces[surface];
  return mesh.is_light ? flat_surface.colour : flat_surface.emission;
}

Emitter emitter_of(const MeshObject& mesh) {
  Emitter emitter;
  emitter.kind = mesh.is_light ? Emitter::Kind::MeshLight : Emitter::Kind::Faces;
  emitter.path = mesh.path;
  emitter.name = mesh.name;
  emitter.count = 0;
  for (const std::uint32_t surface : *mesh.mesh->surface_of_face) {
    if (emission_of(mesh, surface)) ++emitter.count;
  }
  return emitter;
}

void add_place(const MeshObject& mesh, const grf::Matrix44d& to_world, Emitter& emitter) {
  for (std::size_t face = 0; face < mesh.mesh->face_count(); ++face) {
    const auto radiance = emission_of(mesh, (*mesh.mesh->surface_of_face)[face]);
    if (!radiance) continue;
    const double area = grf::doubled_area_vector(*mesh.mesh->geometry, face, to_world).length() / 2;
    emitter.area += area;
    emitter.power += power_of(*radiance, area);
  }
}

std::optional<grf::Scene> report_missing(std::string_view what, grf::Diagnostics& diagnostics) {
  diagnostics.error({}, "there is no " + std::string(what) + " at that place");
  return std::nullopt;
}

/// The first `params` among blocks, or null.
grf::Params* params_of(grf::BlockList& list) {
  for (grf::Block& block : list.blocks) {
    if (auto* params = std::get_if<grf::Params>(&block.content)) return params;
  }
  return nullptr;
}

grf::Params* params_at(grf::Scene& scene, const ObserverObject& observer) {
  auto* params = content_at<grf::Params>(scene, observer.path);
  return params != nullptr && observer.number < params->views.size() ? params : nullptr;
}

}  // namespace

double power_of(const grf::Colour& radiance, double area) { return std::numbers::pi * area * mean(radiance); }

grf::Colour radiance_of(double power, double area, const grf::Colour& colour) {
  if (!(area > 0)) return colour;
  const double wanted = power / (std::numbers::pi * area);
  const double now = mean(colour);
  if (!(now > 0)) return grf::Colour(static_cast<float>(wanted));
  return grf::Colour(grf::Vec3d(colour) * (wanted / now));
}

bool emits(const MeshObject& mesh) {
  for (std::size_t i = 0; i < mesh.flat_surfaces.size(); ++i) {
    if (emission_of(mesh, i)) return true;
  }
  return false;
}

double world_area(const LightObject& light) {
  grf::Vec3d edge1;
  grf::Vec3d edge2;
  light.to_world.multDirMatrix(grf::Vec3d(light.light.edge1), edge1);
  light.to_world.multDirMatrix(grf::Vec3d(light.light.edge2), edge2);
  return edge1.cross(edge2).length();
}

std::vector<Emitter> emitters_of(const SceneObjects& objects) {
  std::vector<Emitter> emitters;
  for (const LightObject& light : objects.lights) {
    const double area = world_area(light);
    const double power = power_of(light.light.radiance.value_or(grf::Colour(1)), area);
    emitters.push_back({Emitter::Kind::AreaLight, light.path, {}, 1, area, power});
  }
  std::vector<std::size_t> places(objects.meshes.size());
  std::vector<bool> are_emitting(objects.meshes.size());
  for (std::size_t i = 0; i < objects.meshes.size(); ++i) {
    are_emitting[i] = emits(objects.meshes[i]);
    if (!are_emitting[i]) continue;
    places[i] = emitters.size();
    emitters.push_back(emitter_of(objects.meshes[i]));
  }
  for (const MeshInstance& instance : *objects.instances) {
    if (!are_emitting[instance.mesh]) continue;
    add_place(objects.meshes[instance.mesh], instance.to_world, emitters[places[instance.mesh]]);
  }
  std::erase_if(emitters, [](const Emitter& emitter) { return emitter.count == 0; });
  return emitters;
}

SurfaceEdit emission_of_power(const SceneObjects& objects, const FaceSelection& selection, double power,
                              const grf::Colour& colour) {
  SurfaceEdit edit;
  const double area = selected_area(objects, selection);
  edit.emission = AttributeEdit<grf::Colour>::set(radiance_of(power, area, colour));
  return edit;
}

grf::Scene add_light(const grf::Scene& scene, const grf::AreaLight& light) {
  grf::Scene changed = scene;
  outermost_blocks(changed).blocks.emplace_back().content = light;
  return changed;
}

std::optional<grf::Scene> change_light(const grf::Scene& scene, grf::ScenePathView path,
                                       const grf::AreaLight& light, grf::Diagnostics& diagnostics) {
  grf::Scene changed = scene;
  auto* there = content_at<grf::AreaLight>(changed, path);
  if (there == nullptr) return report_missing("light", diagnostics);
  *there = light;
  return changed;
}

grf::Scene add_observer(const grf::Scene& scene, const grf::Vec3d& position) {
  grf::Scene changed = scene;
  grf::BlockList& blocks = outermost_blocks(changed);
  grf::Params* params = params_of(blocks);
  if (params == nullptr) {
    blocks.blocks.emplace_back().content = grf::Params();
    params = &std::get<grf::Params>(blocks.blocks.back().content);
  }
  params->views.emplace_back(position);
  return changed;
}

std::optional<grf::Scene> move_observer(const grf::Scene& scene, const ObserverObject& observer,
                                        const grf::Vec3d& position, grf::Diagnostics& diagnostics) {
  grf::Scene changed = scene;
  grf::Params* params = params_at(changed, observer);
  if (params == nullptr) return report_missing("observer", diagnostics);
  const grf::Matrix44d to_local = to_world_at(scene, observer.path).inverse();
  params->views[observer.number] = grf::Vec3f(position * to_local);
  return changed;
}

}  // namespace editor
