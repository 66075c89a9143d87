#include "editor/document/face_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <variant>
#include <vector>

#include <fnmatch.h>

namespace editor {
namespace {

using grf::Vec3d;

/// The compared attributes of a face: its surface as written, and the resolved values, since a name can
/// resolve differently in another scope.
struct SimilarityKey {
  std::optional<std::uint32_t> mesh;
  grf::Surface written;
  grf::Surface meant;
  std::vector<FlatTerm> terms;

  bool operator==(const SimilarityKey&) const = default;
};

std::size_t hash_of(const SimilarityKey& key) {
  std::size_t hash =
      key.mesh.value_or(0) + 7 * grf::hash_value(key.written) + 31 * grf::hash_value(key.meant);
  for (const FlatTerm& term : key.terms) {
    grf::Surface of_term;
    of_term.brdf = term.brdf;
    hash = 31 * hash + grf::hash_value(of_term);
  }
  return hash;
}

SimilarityKey key_of(const MeshObject& object, std::uint32_t mesh, std::size_t surface_index,
                     const Similarity& similarity) {
  const grf::Surface& surface = object.mesh->surfaces[surface_index];
  const FlatSurface& flat_surface = object.flat_surfaces[surface_index];
  SimilarityKey key;
  if (similarity.object) key.mesh = mesh;
  if (similarity.brdf) {
    key.written.brdf = surface.brdf;
    key.meant.brdf = flat_surface.brdf;
    key.terms = flat_surface.terms;
  }
  if (similarity.pdf) key.written.pdf = surface.pdf;
  if (similarity.colour) {
    key.written.colour = surface.colour;
    key.meant.colour = flat_surface.colour;
  }
  if (similarity.texture) {
    key.written.texture = surface.texture;
    key.meant.texture = grf::Reference{flat_surface.texture, {}};
  }
  if (similarity.emission) key.written.emission = surface.emission;
  return key;
}

using SimilarityKeys = std::unordered_set<SimilarityKey, decltype(&hash_of)>;

SimilarityKeys keys_of(const FaceSelection& selected, const SceneObjects& objects,
                       const Similarity& similarity) {
  SimilarityKeys keys(0, &hash_of);
  for (const std::uint32_t mesh : selected.meshes()) {
    const std::vector<bool> is_used = selected_surfaces(objects, selected, mesh);
    for (std::size_t k = 0; k < is_used.size(); ++k) {
      if (is_used[k]) keys.insert(key_of(objects.meshes[mesh], mesh, k, similarity));
    }
  }
  return keys;
}

/// Tells whether a pattern matches a name of a surface's BRDF.
bool has_name(const grf::Surface& surface, const FlatSurface& flat_surface, const std::string& pattern) {
  const auto matches = [&pattern](const std::string& name) {
    return fnmatch(pattern.c_str(), name.c_str(), FNM_CASEFOLD) == 0;
  };
  if (!surface.brdf) return matches("diffuse");  // GRF's default
  const auto* reference = std::get_if<grf::Reference>(&*surface.brdf);
  if (reference != nullptr && matches(reference->name)) return true;
  if (flat_surface.brdf) {
    if (matches(flat_surface.brdf->keyword)) return true;
    const auto is_match = [&](const grf::CombineTerm& term) { return matches(term.brdf.name); };
    if (std::ranges::any_of(flat_surface.brdf->terms, is_match)) return true;
  }
  return std::ranges::any_of(flat_surface.terms,
                             [&](const FlatTerm& term) { return matches(term.brdf.keyword); });
}

/// Transforms area vectors: the cofactors of the linear part, since (a x b) depends on its rows' products.
class AreaTransform {
 public:
  explicit AreaTransform(const grf::Matrix44d& to_world) {
    const auto row = [&to_world](int i) { return Vec3d(to_world[i][0], to_world[i][1], to_world[i][2]); };
    for (int i = 0; i < 3; ++i) rows_[i] = row((i + 1) % 3).cross(row((i + 2) % 3));
  }
  Vec3d operator()(const grf::Vec3f& area) const {
    return rows_[0] * area.x + rows_[1] * area.y + rows_[2] * area.z;
  }

 private:
  std::array<Vec3d, 3> rows_;
};

/// The geometric conditions of a query, with those of similarity as ranges.
struct GeometricQuery {
  std::vector<DirectionRange> normals;
  std::vector<ValueRange> areas;
  ValueRange height;
};

GeometricQuery geometric_query(const FaceQuery& query, const FaceSelection& selected,
                               const SceneObjects& objects) {
  GeometricQuery result;
  result.height = query.height;
  if (query.normal) result.normals.push_back(*query.normal);
  if (query.area.is_bounded()) result.areas.push_back(query.area);
  const Similarity& similarity = query.similarity;
  if (!similarity.normal_radians && !similarity.area_fraction) return result;
  Vec3d sum(0);
  double area = 0;
  std::size_t count = 0;
  for (const MeshInstance& instance : *objects.instances) {
    const AreaTransform to_world(instance.to_world);
    const std::vector<grf::Vec3f>& areas = objects.meshes[instance.mesh].mesh->geometry.area_vectors();
    selected.for_each_face(instance.mesh, [&](std::size_t face) {
      const Vec3d doubled = to_world(areas[face]);
      sum += doubled;
      area += doubled.length() / 2;
      ++count;
    });
  }
  if (similarity.normal_radians) result.normals.push_back({sum.normalized(), *similarity.normal_radians});
  if (similarity.area_fraction && count > 0) {
    const double mean = area / static_cast<double>(count);
    const double deviation = mean * (*similarity.area_fraction + 1e-6);  // rounding of equal areas
    result.areas.push_back({mean - deviation, mean + deviation});
  }
  return result;
}

/// Tells where the faces of an instance fulfil geometric conditions.
class InstanceTest {
 public:
  InstanceTest(const GeometricQuery& query, const MeshInstance& instance, const grf::SharedGeometry& geometry)
      : query_(query),
        geometry_(*geometry),
        areas_(geometry.area_vectors()),
        area_to_world_(instance.to_world),
        to_height_(instance.to_world[0][1], instance.to_world[1][1], instance.to_world[2][1]),
        height_of_origin_(instance.to_world[3][1]) {
    for (const DirectionRange& range : query.normals) cosines_.push_back(std::cos(range.radians));
  }

  bool operator()(std::size_t face) const {
    const Vec3d doubled = area_to_world_(areas_[face]);
    const double length = doubled.length();
    for (std::size_t i = 0; i < cosines_.size(); ++i) {
      // Rounding of the normal and the cosine must not lose an angle of 0.
      const double cosine = doubled.dot(query_.normals[i].axis) / length;
      if (!(cosine >= cosines_[i] - CosineTolerance)) return false;
    }
    for (const ValueRange& range : query_.areas) {
      if (!range.has(length / 2)) return false;
    }
    if (!query_.height.is_bounded()) return true;
    return std::ranges::all_of(geometry_.face(face), [this](std::uint32_t corner) {
      return query_.height.has(Vec3d(geometry_.positions[corner]).dot(to_height_) + height_of_origin_);
    });
  }

 private:
  static constexpr double CosineTolerance = 1e-6;  // that of a normal in float

  const GeometricQuery& query_;
  const grf::Geometry& geometry_;
  const std::vector<grf::Vec3f>& areas_;
  AreaTransform area_to_world_;
  Vec3d to_height_;
  double height_of_origin_;
  std::vector<double> cosines_;
};

/// The faces whose surface fulfils a query.
FaceSelection with_surface(const FaceQuery& query, const FaceSelection& selected,
                           const SceneObjects& objects) {
  const SimilarityKeys keys = keys_of(selected, objects, query.similarity);
  const bool compares = query.similarity.compares_surfaces();
  FaceSelection result(objects);
  for (std::uint32_t i = 0; i < objects.meshes.size(); ++i) {
    const MeshObject& object = objects.meshes[i];
    const grf::Mesh& mesh = *object.mesh;
    std::vector<bool> takes;
    for (std::size_t k = 0; k < mesh.surfaces.size(); ++k) {
      takes.push_back(
          (!compares || keys.contains(key_of(object, i, k, query.similarity))) &&
          (query.material.empty() || has_name(mesh.surfaces[k], object.flat_surfaces[k], query.material)));
    }
    FaceSelection::Faces faces(mesh.face_count());
    for (std::size_t face = 0; face < faces.size(); ++face)
      faces[face] = takes[(*mesh.surface_of_face)[face]];
    result.set_faces(i, faces);
  }
  return result;
}

}  // namespace

FaceSelection find_faces(const FaceQuery& query, const FaceSelection& selected, const SceneObjects& objects) {
  if (!query.similarity.empty() && selected.empty()) return FaceSelection(objects);
  FaceSelection candidates = with_surface(query, selected, objects);
  if (!query.is_geometric()) return candidates;
  const GeometricQuery conditions = geometric_query(query, selected, objects);
  FaceSelection result(objects);
  for (const MeshInstance& instance : *objects.instances) {
    const InstanceTest holds(conditions, instance, objects.meshes[instance.mesh].mesh->geometry);
    FaceSelection::Faces faces = result.of_mesh(instance.mesh);
    candidates.for_each_face(instance.mesh, [&](std::size_t face) {
      if (!faces[face] && holds(face)) faces.set(face);
    });
    result.set_faces(instance.mesh, faces);
  }
  return result;
}

}  // namespace editor
