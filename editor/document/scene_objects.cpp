#include "editor/document/scene_objects.h"

#include <algorithm>
#include <map>
#include <optional>

#include "editor/document/references.h"
#include "grf/keywords.h"
#include "grf/text_file.h"
#include "grf/vertex_tree.h"
#include "grf/visit.h"

namespace editor {
namespace {

/// Returns the image of the colour of a BRDF, which is shown as a texture; null if there is none.
const grf::ParameterMap* colour_map_of(const grf::BrdfModel& brdf) {
  for (const grf::Argument& argument : brdf.arguments) {
    const bool is_colour =
        grf::same_keyword(argument.name, "kd") || grf::same_keyword(argument.name, "baseColor");
    if (is_colour && argument.map && argument.map->channel == grf::ImageChannel::Rgb) return &*argument.map;
  }
  return nullptr;
}

class Collector {
 public:
  explicit Collector(const std::string& path) : path_(path) {}

  SceneObjects collect(const grf::Scene& scene) {
    grf::SceneVisitor visitor = mesh_visitor(
        [this](MeshObject object, const grf::Placement& placement) {
          object.path = path_of(placement);
          object.flat_surfaces = flat_surfaces_of(*object.mesh, placement);
          objects_.faces += object.mesh->face_count();
          objects_.meshes.push_back(std::move(object));
        },
        [this](std::uint32_t mesh, const grf::Placement& placement) {
          place(objects_.meshes[mesh], mesh, placement);
          objects_.triangles += objects_.meshes[mesh].mesh->geometry->triangle_count();
        });
    visit_lights(visitor);
    grf::visit(scene, visitor, path_);
    objects_.bounds.extendBy(objects_.mesh_bounds);
    objects_.instances = std::move(instances_);
    return std::move(objects_);
  }

  void update(SceneObjects& objects, const grf::Scene& scene, const Change& change) {
    std::vector<bool> are_changed(objects.meshes.size(), change.definitions);
    for (const std::uint32_t mesh : change.meshes) are_changed[mesh] = true;
    grf::SceneVisitor visitor = mesh_visitor(
        [&](MeshObject object, const grf::Placement& placement) {
          if (!are_changed[next_mesh_]) return;
          object.path = std::move(objects.meshes[next_mesh_].path);
          object.flat_surfaces = flat_surfaces_of(*object.mesh, placement);
          objects.meshes[next_mesh_] = std::move(object);
        },
        [&](std::uint32_t mesh, const grf::Placement& placement) {
          if (change.transforms) place(objects.meshes[mesh], mesh, placement);
        });
    const bool are_lights_changed = change.lights || change.transforms;
    if (are_lights_changed) visit_lights(visitor);
    grf::visit(scene, visitor, path_);
    if (change.transforms) {
      objects.instances = std::move(instances_);
      objects.mesh_bounds = objects_.mesh_bounds;
    }
    if (!are_lights_changed) return;
    objects.lights = std::move(objects_.lights);
    objects.observers = std::move(objects_.observers);
    objects.bounds = objects_.bounds;
    objects.bounds.extendBy(objects.mesh_bounds);
  }

 private:
  static grf::ScenePath path_of(const grf::Placement& placement) {
    return {placement.path.begin(), placement.path.end()};
  }

  /// Visits meshes in the order of their numbers, without paths and surfaces, and the instances of each.
  template <class Meet, class Place>
  grf::SceneVisitor mesh_visitor(const Meet& meet, const Place& place) {
    grf::SceneVisitor visitor;
    const auto meet_next = [this, meet](MeshObject object, const grf::Placement& placement) {
      meet(std::move(object), placement);
      return next_mesh_++;
    };
    visitor.mesh = [=, this](const grf::Mesh& mesh, const grf::Placement& placement,
                             const grf::Block& block) {
      const bool is_instance = placement.instance_of != nullptr;
      place(
          is_instance
              ? defined_.at(placement.instance_of)
              : meet_next({{}, mesh.name, std::get<grf::Shared<grf::Mesh>>(block.content), false, false, {}},
                          placement),
          placement);
    };
    visitor.mesh_light = [=](const grf::MeshLight& light, const grf::Placement& placement,
                             const grf::Block&) {
      place(meet_next({{}, {}, light.mesh, false, true, {}}, placement), placement);
    };
    visitor.definition = [=, this](const grf::Definition& definition, const grf::Placement& placement) {
      const bool names_images = std::holds_alternative<grf::Texture>(definition.body) ||
                                std::holds_alternative<grf::BrdfModel>(definition.body);
      if (names_images) file_of_[&definition] = placement.file;
      const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body);
      if (mesh != nullptr)
        defined_[&definition] = meet_next({{}, definition.name, *mesh, true, false, {}}, placement);
    };
    return visitor;
  }

  void visit_lights(grf::SceneVisitor& visitor) {
    visitor.light = [this](const grf::AreaLight& light, const grf::Placement& placement, const grf::Block&) {
      add_light(light, placement);
    };
    visitor.params = [this](const grf::Params& params, const grf::Placement& placement, const grf::Block&) {
      for (std::size_t i = 0; i < params.views.size(); ++i) {
        objects_.observers.push_back(
            {path_of(placement), i, grf::Vec3d(params.views[i]) * placement.to_world});
      }
    };
  }

  void place(const MeshObject& object, std::uint32_t index, const grf::Placement& placement) {
    instances_.push_back({index, path_of(placement), placement.to_world});
    objects_.mesh_bounds.extendBy(object.mesh->geometry.vertices().bounds_under(placement.to_world));
  }

  void add_light(const grf::AreaLight& light, const grf::Placement& placement) {
    objects_.lights.push_back({path_of(placement), light, placement.to_world});
    for (const grf::Vec3d& corner : corners_of(objects_.lights.back())) objects_.bounds.extendBy(corner);
  }

  /// Returns the file that names the image of an attribute: that of its definition, or of the mesh.
  template <class Attribute>
  std::string naming_file(const Attribute& attribute, const grf::Placement& placement) const {
    const auto* name = std::get_if<grf::Reference>(&attribute);
    return std::string(name == nullptr ? placement.file : file_of_.at(placement.scope.find(name->name)));
  }

  std::vector<FlatSurface> flat_surfaces_of(const grf::Mesh& mesh, const grf::Placement& placement) const {
    std::vector<FlatSurface> flat_surfaces;
    for (const grf::Surface& surface : mesh.surfaces)
      flat_surfaces.push_back(flat_surface_of(surface, placement));
    return flat_surfaces;
  }

  FlatSurface flat_surface_of(const grf::Surface& surface, const grf::Placement& placement) const {
    const grf::ResolvedSurface resolved = grf::resolve(surface, placement.scope);
    FlatSurface flat_surface;
    flat_surface.colour = resolved.colour;
    flat_surface.emission = resolved.emission;
    flat_surface.opacity = resolved.opacity;
    if (resolved.texture != nullptr) {
      flat_surface.texture =
          grf::path_beside(naming_file(*surface.texture, placement), resolved.texture->file);
    }
    if (resolved.brdf == nullptr) return flat_surface;
    const grf::ParameterMap* map = colour_map_of(*resolved.brdf);
    if (map != nullptr && flat_surface.texture.empty()) {
      const std::string file = naming_file(*surface.brdf, placement);
      const std::string& instance = resolved.brdf->instance_file;
      flat_surface.texture =
          grf::path_beside(instance.empty() ? file : grf::path_beside(file, instance), map->file);
    }
    flat_surface.brdf = *resolved.brdf;
    if (resolved.brdf->terms.empty()) return flat_surface;
    for (const grf::WeightedBrdf& summand : grf::summands_of(*resolved.brdf, resolved.brdf_scope)) {
      FlatTerm term{summand.weight, *summand.model, {}};
      if (is_layered(term.brdf)) {
        std::vector<std::string> names;
        for_each_term(term.brdf, [&names](const grf::Reference& layer) { names.push_back(layer.name); });
        term.definitions = grf::definitions_needed(names, summand.scope);
      }
      flat_surface.terms.push_back(std::move(term));
    }
    return flat_surface;
  }

  const std::string& path_;
  SceneObjects objects_;
  std::vector<MeshInstance> instances_;
  std::uint32_t next_mesh_ = 0;
  // The latest visit of these definitions: they precede their uses, and a file that is included at several
  // places is visited once per place, since names may resolve differently there.
  std::map<const grf::Definition*, std::uint32_t> defined_;  // indices of meshes
  std::map<const grf::Definition*, std::string> file_of_;    // file in which a texture or a BRDF is
};

}  // namespace

std::array<grf::Vec3d, 4> corners_of(const LightObject& light) {
  const grf::Vec3d corner(light.light.corner);
  const grf::Vec3d edge1(light.light.edge1);
  const grf::Vec3d edge2(light.light.edge2);
  return {corner * light.to_world, (corner + edge1) * light.to_world,
          (corner + edge1 + edge2) * light.to_world, (corner + edge2) * light.to_world};
}

std::optional<std::uint32_t> SceneObjects::mesh_at(grf::ScenePathView path) const {
  const auto found = std::ranges::find_if(meshes, [path](const MeshObject& mesh) {
    return std::equal(path.begin(), path.end(), mesh.path.begin(), mesh.path.end());
  });
  if (found == meshes.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - meshes.begin());
}

SceneObjects objects_of(const grf::Scene& scene, const std::string& path) {
  return Collector(path).collect(scene);
}

void update(SceneObjects& objects, const grf::Scene& scene, const std::string& path, const Change& change) {
  Collector(path).update(objects, scene, change);
}

}  // namespace editor
