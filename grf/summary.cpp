#include "grf/summary.h"

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grf/keywords.h"
#include "grf/text_file.h"
#include "grf/vertex_tree.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace grf {
namespace {

/// Returns the factor of a uniform scale, or nothing if the scale depends on the direction.
std::optional<double> uniform_scale(const Matrix44d& to_world) {
  constexpr double Tolerance = 1e-9;
  const Vec3d x(to_world[0][0], to_world[0][1], to_world[0][2]);
  const Vec3d y(to_world[1][0], to_world[1][1], to_world[1][2]);
  const Vec3d z(to_world[2][0], to_world[2][1], to_world[2][2]);
  const double scale2 = x.length2();
  for (const double error : {y.length2() - scale2, z.length2() - scale2, x.dot(y), y.dot(z), z.dot(x)}) {
    if (!(std::abs(error) <= Tolerance * scale2)) return std::nullopt;
  }
  return std::sqrt(scale2);
}

/// Returns the name of a mesh, or that of its definition if it has none.
std::string name_of(const Mesh& mesh, const Placement& placement) {
  return mesh.name.empty() && placement.instance_of != nullptr ? placement.instance_of->name : mesh.name;
}

class Counter {
 public:
  Summary run(const Scene& scene) {
    SceneVisitor visitor;
    visitor.mesh = [this](const Mesh& mesh, const Placement& placement, const Block&) {
      if (placement.instance_of != nullptr) ++summary_.instances;
      add(mesh, placement, false);
    };
    visitor.mesh_light = [this](const MeshLight& light, const Placement& placement, const Block&) {
      add(*light.mesh, placement, true);
    };
    visitor.light = [this](const AreaLight& light, const Placement& placement, const Block&) {
      add(light, placement.to_world);
    };
    visitor.definition = [this](const Definition& definition, const Placement&) {
      if (const auto* brdf = std::get_if<BrdfModel>(&definition.body)) {
        ++summary_.brdfs;
        add_maps(*brdf);
      }
      if (std::holds_alternative<PdfModel>(definition.body)) ++summary_.pdfs;
      if (const auto* texture = std::get_if<Texture>(&definition.body)) add_image(*texture);
    };
    visit(scene, visitor);
    summary_.brdfs += brdfs_.size();
    summary_.pdfs += pdfs_.size();
    summary_.textures = images_.size();
    return summary_;
  }

 private:
  void add(const AreaLight& light, const Matrix44d& to_world) {
    ++summary_.lights;
    const Vec3f opposite = light.corner + light.edge1 + light.edge2;
    for (const Vec3f& p : {light.corner, light.corner + light.edge1, light.corner + light.edge2, opposite}) {
      summary_.bounds.extendBy(Vec3f(Vec3d(p) * to_world));
    }
  }

  void add(const Mesh& mesh, const Placement& placement, bool is_light) {
    const auto [known, is_new] = emits_.try_emplace(&mesh);
    const Topology& topology = mesh.geometry.topology();
    if (is_new) {
      known->second = add_surfaces(mesh);
      summary_.different_meshes.push_back(
          {name_of(mesh, placement), mesh.geometry->positions.size(), mesh.face_count(), topology});
    }
    ++(is_light ? summary_.lights : summary_.meshes);
    summary_.vertices += mesh.geometry->positions.size();
    summary_.faces += mesh.face_count();
    summary_.triangles += mesh.geometry->triangle_count();
    summary_.boundary_edges += topology.boundary_edges;
    summary_.boundary_loops += topology.boundary_loops;
    summary_.nonmanifold_edges += topology.nonmanifold_edges;
    summary_.nonmanifold_vertices += topology.nonmanifold_vertices;
    if (known->second && !is_light) ++summary_.lights;
    const auto scale = uniform_scale(placement.to_world);
    summary_.area +=
        scale ? *scale * *scale * mesh.geometry.area() : area_of(*mesh.geometry, placement.to_world);
    const Box3d bounds = mesh.geometry.vertices().bounds_under(placement.to_world);
    if (bounds.isEmpty()) return;
    for (const Vec3d& corner : {bounds.min, bounds.max}) summary_.bounds.extendBy(Vec3f(corner));
  }

  /// Returns whether any face emits.
  bool add_surfaces(const Mesh& mesh) {
    bool emits = false;
    const std::vector<bool> is_used = used_surfaces(mesh);
    for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
      if (!is_used[i]) continue;
      const Surface& surface = mesh.surfaces[i];
      if (surface.brdf) add_model<BrdfModel>(*surface.brdf, brdfs_);
      const auto* brdf = surface.brdf ? std::get_if<BrdfModel>(&*surface.brdf) : nullptr;
      if (brdf != nullptr) add_maps(*brdf);
      if (surface.pdf) add_model<PdfModel>(*surface.pdf, pdfs_);
      const auto* texture = surface.texture ? std::get_if<Texture>(&*surface.texture) : nullptr;
      if (texture != nullptr) add_image(*texture);
      emits = emits || surface.emission.has_value();
    }
    return emits;
  }

  void add_image(const Texture& texture) {
    const auto& file = texture.location.file;
    images_.insert(file ? path_beside(file->path, texture.file) : texture.file);
  }

  void add_maps(const BrdfModel& brdf) {
    for (const Argument& argument : brdf.arguments) {
      if (argument.map) images_.insert(map_path(argument));
    }
  }

  template <class Model>
  static void add_model(const std::variant<Model, Reference>& attribute, std::set<std::string>& models) {
    if (const auto* model = std::get_if<Model>(&attribute)) models.insert(lower_case(to_text(*model)));
  }

  Summary summary_;
  std::unordered_map<const Mesh*, bool> emits_;  ///< by mesh, shared by its instances
  std::set<std::string> brdfs_;
  std::set<std::string> pdfs_;
  std::set<std::string> images_;
};

}  // namespace

Summary summarize(const Scene& scene) { return Counter().run(scene); }

}  // namespace grf
