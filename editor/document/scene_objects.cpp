#include "editor/document/scene_objects.h"

#include <algorithm>
#include <map>

#include "grf/text_file.h"
#include "grf/visit.h"

namespace editor {
namespace {

class Collector {
 public:
  explicit Collector(const std::string& path) : path_(path) {}

  SceneObjects collect(const grf::Scene& scene) {
    grf::SceneVisitor visitor;
    visitor.mesh = [this](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block& block) {
      if (placement.instance_of == nullptr) {
        const auto& shared = std::get<grf::Shared<grf::Mesh>>(block.content);
        place(add_mesh(shared, mesh.name, placement), placement);
      } else {
        place(mesh_of(*placement.instance_of, placement), placement);
      }
    };
    visitor.mesh_light = [this](const grf::MeshLight& light, const grf::Placement& placement,
                                const grf::Block&) {
      const std::uint32_t mesh = add_mesh(light.mesh, {}, placement);
      objects_.meshes[mesh].is_light = true;
      place(mesh, placement);
    };
    visitor.light = [this](const grf::AreaLight& light, const grf::Placement& placement, const grf::Block&) {
      add_light(light, placement);
    };
    visitor.params = [this](const grf::Params& params, const grf::Placement& placement, const grf::Block&) {
      for (std::size_t i = 0; i < params.views.size(); ++i) {
        objects_.observers.push_back(
            {path_of(placement), i, grf::Vec3d(params.views[i]) * placement.to_world});
      }
    };
    visitor.definition = [this](const grf::Definition& definition, const grf::Placement& placement) {
      if (std::holds_alternative<grf::Shared<grf::Mesh>>(definition.body)) mesh_of(definition, placement);
    };
    grf::visit(scene, visitor);
    return std::move(objects_);
  }

 private:
  static grf::ScenePath path_of(const grf::Placement& placement) {
    return {placement.path.begin(), placement.path.end()};
  }

  /// The mesh that is defined; its definition is met before what uses it.
  std::uint32_t mesh_of(const grf::Definition& definition, const grf::Placement& placement) {
    const auto known = defined_.find(&definition);
    if (known != defined_.end()) return known->second;
    const auto& mesh = std::get<grf::Shared<grf::Mesh>>(definition.body);
    const std::uint32_t index = add_mesh(mesh, definition.name, placement);
    objects_.meshes[index].is_definition = true;
    defined_.emplace(&definition, index);
    return index;
  }

  std::uint32_t add_mesh(const grf::Shared<grf::Mesh>& mesh, const std::string& name,
                         const grf::Placement& placement) {
    MeshObject object;
    object.path = path_of(placement);
    object.name = name;
    object.mesh = mesh;
    for (const grf::Surface& surface : mesh->surfaces) {
      object.looks.push_back(look_of(surface, placement.scope));
    }
    objects_.faces += mesh->face_count();
    objects_.meshes.push_back(std::move(object));
    return static_cast<std::uint32_t>(objects_.meshes.size() - 1);
  }

  void place(std::uint32_t index, const grf::Placement& placement) {
    const grf::Mesh& mesh = *objects_.meshes[index].mesh;
    objects_.instances.push_back({index, path_of(placement), placement.to_world});
    objects_.triangles += mesh.corners.size() - 2 * mesh.face_count();
    for (const grf::Vec3f& position : mesh.positions) {
      objects_.bounds.extendBy(grf::Vec3d(position) * placement.to_world);
    }
  }

  void add_light(const grf::AreaLight& light, const grf::Placement& placement) {
    objects_.lights.push_back({path_of(placement), light, placement.to_world});
    const grf::Vec3d corner(light.corner);
    const grf::Vec3d edge1(light.edge1);
    const grf::Vec3d edge2(light.edge2);
    for (const grf::Vec3d& point : {corner, corner + edge1, corner + edge2, corner + edge1 + edge2}) {
      objects_.bounds.extendBy(point * placement.to_world);
    }
  }

  Look look_of(const grf::Surface& surface, const grf::Scope& scope) const {
    const grf::ResolvedSurface resolved = grf::resolve(surface, scope);
    Look look;
    look.colour = resolved.colour;
    look.emission = resolved.emission;
    if (resolved.texture != nullptr) look.texture = grf::path_beside(path_, resolved.texture->file);
    if (resolved.brdf == nullptr) return look;
    look.brdf = *resolved.brdf;
    for (const grf::CombineTerm& term : resolved.brdf->terms) {
      const auto* brdf = resolved.brdf_scope.find<grf::BrdfModel>(term.brdf.name);
      if (brdf != nullptr) look.terms.push_back(*brdf);
    }
    return look;
  }

  const std::string& path_;
  SceneObjects objects_;
  std::map<const grf::Definition*, std::uint32_t> defined_;
};

}  // namespace

std::optional<std::uint32_t> SceneObjects::mesh_at(grf::ScenePathView path) const {
  const auto found = std::find_if(meshes.begin(), meshes.end(), [path](const MeshObject& mesh) {
    return std::equal(path.begin(), path.end(), mesh.path.begin(), mesh.path.end());
  });
  if (found == meshes.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - meshes.begin());
}

SceneObjects objects_of(const grf::Scene& scene, const std::string& path) {
  return Collector(path).collect(scene);
}

}  // namespace editor
