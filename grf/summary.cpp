#include "grf/summary.h"

#include <algorithm>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grf/keywords.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace grf {
namespace {

/// For each vertex, the first one at the same place: seams of normals are no holes.
std::vector<std::uint32_t> first_at_place(const Mesh& mesh) {
  struct Hash {
    std::size_t operator()(const Vec3f& v) const {
      const std::hash<float> hash;
      return hash(v.x + 0.0F) ^ (hash(v.y + 0.0F) * 31) ^ (hash(v.z + 0.0F) * 1009);
    }
  };
  std::unordered_map<Vec3f, std::uint32_t, Hash> places;
  places.reserve(mesh.positions.size());
  std::vector<std::uint32_t> first;
  first.reserve(mesh.positions.size());
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    first.push_back(places.emplace(mesh.positions[i], i).first->second);
  }
  return first;
}

void count_edges(const Mesh& mesh, Summary& summary) {
  const std::vector<std::uint32_t> place = first_at_place(mesh);
  std::vector<std::uint64_t> edges;
  edges.reserve(mesh.corners.size());
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const auto face = mesh.face(i);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint64_t a = place[face[k]];
      const std::uint64_t b = place[face[(k + 1) % face.size()]];
      if (a != b) edges.push_back(std::min(a, b) << 32U | std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::upper_bound(first, edges.end(), *first);
    if (last - first == 1) ++summary.boundary_edges;
    if (last - first > 2) ++summary.nonmanifold_edges;
    first = last;
  }
}

void add_place(const Vec3f& position, const Matrix44d& to_world, Box3f& bounds) {
  bounds.extendBy(Vec3f(Vec3d(position) * to_world));
}

class Counter {
 public:
  Summary run(const Scene& scene) {
    SceneVisitor visitor;
    visitor.mesh = [this](const Mesh& mesh, const Placement& placement, const Block&) {
      add(mesh, placement);
    };
    visitor.light = [this](const AreaLight& light, const Placement& placement, const Block&) {
      ++summary_.lights;
      const Vec3f opposite = light.corner + light.edge1 + light.edge2;
      for (const Vec3f& p :
           {light.corner, light.corner + light.edge1, light.corner + light.edge2, opposite}) {
        add_place(p, placement.to_world, summary_.bounds);
      }
    };
    visitor.definition = [this](const Definition& definition, const Placement&) {
      if (std::holds_alternative<BrdfModel>(definition.body)) ++summary_.brdfs;
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
  void add(const Mesh& mesh, const Placement& placement) {
    ++summary_.meshes;
    summary_.vertices += mesh.positions.size();
    summary_.faces += mesh.face_count();
    summary_.triangles += mesh.corners.size() - 2 * mesh.face_count();
    for (const Vec3f& position : mesh.positions) add_place(position, placement.to_world, summary_.bounds);
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      summary_.area += doubled_area_vector(mesh, i, placement.to_world).length() / 2;
    }
    std::vector<bool> is_used(mesh.surfaces.size());
    for (const std::uint32_t surface : mesh.surface_of_face) is_used[surface] = true;
    bool emits = false;
    for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
      if (!is_used[i]) continue;
      const Surface& surface = mesh.surfaces[i];
      if (surface.brdf) add_model<BrdfModel>(*surface.brdf, brdfs_);
      if (surface.pdf) add_model<PdfModel>(*surface.pdf, pdfs_);
      if (const auto* texture = surface.texture ? std::get_if<Texture>(&*surface.texture) : nullptr)
        add_image(*texture);
      emits = emits || surface.emission.has_value();
    }
    if (emits) ++summary_.lights;
    count_edges(mesh, summary_);
  }

  void add_image(const Texture& texture) {
    const auto& file = texture.location.file;
    images_.insert(file ? path_beside(file->path, texture.file) : texture.file);
  }

  template <class Model>
  static void add_model(const std::variant<Model, Reference>& attribute, std::set<std::string>& models) {
    if (const auto* model = std::get_if<Model>(&attribute)) models.insert(lower_case(to_text(*model)));
  }

  Summary summary_;
  std::set<std::string> brdfs_;
  std::set<std::string> pdfs_;
  std::set<std::string> images_;
};

}  // namespace

Vec3d doubled_area_vector(const Mesh& mesh, std::size_t face, const Matrix44d& to_world) {
  const auto corners = mesh.face(face);
  const Vec3d origin = Vec3d(mesh.positions[corners[0]]) * to_world;
  Vec3d sum(0);
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Vec3d a = Vec3d(mesh.positions[corners[k]]) * to_world - origin;
    const Vec3d b = Vec3d(mesh.positions[corners[k + 1]]) * to_world - origin;
    sum += a.cross(b);
  }
  return sum;
}

Summary summarize(const Scene& scene) { return Counter().run(scene); }

}  // namespace grf
