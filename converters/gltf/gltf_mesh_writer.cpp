#include "converters/gltf/gltf_mesh_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "converters/gltf/gltf_grf.h"

namespace convert {
namespace {

using nlohmann::json;
using Use = GltfDocument::Use;

template <class T>
bool are_alike(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) {
    for (unsigned i = 0; i < T::dimensions(); ++i) {
      if (std::bit_cast<std::uint32_t>(x[static_cast<int>(i)]) !=
          std::bit_cast<std::uint32_t>(y[static_cast<int>(i)]))
        return false;
    }
    return true;
  });
}

/// Normalizes a vector; returns nothing if it is zero.
std::optional<grf::Vec3f> unit(const grf::Vec3f& v) {
  const grf::Vec3d wide(v);
  const double length = std::sqrt(wide.dot(wide));
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  // Vectors of unit length up to rounding stay unchanged.
  constexpr double Rounding = 1e-6;
  return std::abs(length - 1) <= Rounding ? v : grf::Vec3f(wide / length);
}

/// The key of a primitive.
struct Part {
  int material = -1;
  bool smooth = false;  ///< all corners have normals
  auto operator<=>(const Part&) const = default;
};

class MeshWriter {
 public:
  MeshWriter(const grf::Mesh& mesh, const std::function<int(const grf::Surface&)>& material_of,
             GltfDocument& document)
      : mesh_(mesh), material_of_(material_of), document_(document) {}

  WrittenMesh run(const std::string& name) {
    lists_.vertices = mesh_.geometry->positions.size();
    lists_.faces = mesh_.face_count();
    WrittenMesh written;
    if (!mesh_.geometry->positions.empty()) write_vertices();
    if (mesh_.face_count() > 0) {
      json primitives = write_primitives();
      written.mesh = document_.append("meshes", {{"primitives", std::move(primitives)}});
      if (!name.empty()) document_.json()["meshes"].back()["name"] = name;
      write_faces();
    }
    written.lists = {{"vertices", lists_.vertices}, {"faces", lists_.faces}};
    for_each_list(lists_, [&](const char* member, const std::optional<int>& accessor) {
      if (accessor) written.lists[member] = *accessor;
    });
    return written;
  }

 private:
  std::size_t size() const { return mesh_.geometry->positions.size(); }
  bool has_faces() const { return mesh_.face_count() > 0; }

  template <class T>
  std::vector<T> filled(const grf::OptionalVertexValues<T>& values, const T& otherwise) const {
    std::vector<T> all(size(), otherwise);
    for (std::size_t i = 0; i < size(); ++i) {
      if (values.has(i)) all[i] = values[i];
    }
    return all;
  }

  void write_vertices() {
    lists_.positions =
        document_.add(mesh_.geometry->positions, has_faces() ? Use::Vertices : Use::Data, has_faces());
    attributes_["POSITION"] = *lists_.positions;
    if (!mesh_.geometry->normals.empty()) write_normals();
    if (!mesh_.geometry->colours.empty()) write_colours();
    if (!mesh_.geometry->uvs.empty()) write_uvs();
    if (!mesh_.irradiance->empty()) write_irradiance();
    write_present();
  }

  void write_normals() {
    const auto exact = filled(mesh_.geometry->normals, grf::Vec3f(0, 0, 1));
    std::vector<grf::Vec3f> units = exact;
    has_normal_.resize(size());
    for (std::size_t i = 0; i < size(); ++i) {
      const auto normal = unit(exact[i]);
      has_normal_[i] = mesh_.geometry->normals.has(i) && normal;
      units[i] = normal.value_or(grf::Vec3f(0, 0, 1));
    }
    lists_.normals = write(exact, units, normal_accessor_);
  }

  void write_colours() {
    const auto exact = filled(mesh_.geometry->colours, grf::Colour(1));
    std::vector<grf::Colour> inside = exact;
    for (grf::Colour& colour : inside) {
      for (int i = 0; i < 3; ++i) colour[i] = std::clamp(colour[i], 0.0F, 1.0F);
    }
    std::optional<int> accessor;
    lists_.colours = write(exact, inside, accessor);
    if (accessor) attributes_["COLOR_0"] = *accessor;
  }

  /// Writes values that glTF allows as a vertex attribute, if there are faces, and returns the accessor of
  /// the exact values.
  int write(const std::vector<grf::Vec3f>& exact, const std::vector<grf::Vec3f>& allowed,
            std::optional<int>& attribute) {
    if (has_faces()) attribute = document_.add(allowed, Use::Vertices);
    return attribute && are_alike(exact, allowed) ? *attribute : document_.add(exact, Use::Data);
  }

  // The v axis points up in GRF and down in glTF, and flipping it rounds.
  void write_uvs() {
    const auto exact = filled(mesh_.geometry->uvs, grf::Vec2f(0));
    lists_.uvs = document_.add(exact, Use::Data);
    if (!has_faces()) return;
    std::vector<grf::Vec2f> turned = exact;
    for (grf::Vec2f& uv : turned) uv.y = 1 - uv.y;
    attributes_["TEXCOORD_0"] = document_.add(turned, Use::Vertices);
  }

  void write_irradiance() {
    std::vector<grf::Colour> values(size(), grf::Colour(0));
    std::vector<std::uint32_t> counts(size());
    std::vector<grf::Vec3f> directions;
    std::vector<grf::Colour> rays;
    for (std::size_t i = 0; i < size(); ++i) {
      if (!mesh_.irradiance->has(i)) continue;
      if (const auto* value = std::get_if<grf::Colour>(&(*mesh_.irradiance)[i])) {
        values[i] = *value;
        continue;
      }
      const auto& list = std::get<std::vector<grf::DirectionalIrradiance>>((*mesh_.irradiance)[i]);
      has_rays_ = true;
      counts[i] = static_cast<std::uint32_t>(list.size());
      for (const grf::DirectionalIrradiance& ray : list) {
        directions.push_back(ray.direction);
        rays.push_back(ray.irradiance);
      }
    }
    lists_.irradiance = document_.add(values, Use::Data);
    if (!has_rays_) return;
    lists_.ray_counts = document_.add(counts, Use::Data);
    if (rays.empty()) return;
    lists_.ray_directions = document_.add(directions, Use::Data);
    lists_.ray_values = document_.add(rays, Use::Data);
  }

  unsigned present(std::size_t i) const {
    unsigned bits = (mesh_.geometry->normals.has(i) ? HasNormal : 0U) |
                    (mesh_.geometry->colours.has(i) ? HasColour : 0U) |
                    (mesh_.geometry->uvs.has(i) ? HasUv : 0U);
    if (!mesh_.irradiance->has(i)) return bits;
    const bool is_value = std::holds_alternative<grf::Colour>((*mesh_.irradiance)[i]);
    return bits | (is_value ? HasIrradiance : HasRays);
  }

  void write_present() {
    const unsigned all = (mesh_.geometry->normals.empty() ? 0U : HasNormal) |
                         (mesh_.geometry->colours.empty() ? 0U : HasColour) |
                         (mesh_.geometry->uvs.empty() ? 0U : HasUv) |
                         (mesh_.irradiance->empty() ? 0U : HasIrradiance);
    std::vector<std::uint8_t> bits(size());
    for (std::size_t i = 0; i < size(); ++i) bits[i] = static_cast<std::uint8_t>(present(i));
    const bool same = std::all_of(bits.begin(), bits.end(), [all](std::uint8_t bit) { return bit == all; });
    if (!same || has_rays_) lists_.present = document_.add_bytes(bits);
  }

  json write_primitives() {
    std::vector<std::optional<int>> materials(mesh_.surfaces.size());
    std::map<Part, std::size_t> places;
    std::vector<Part> parts;
    std::vector<std::vector<std::uint32_t>> corners;  // corners of triangles
    for (std::size_t i = 0; i < mesh_.face_count(); ++i) {
      auto& material = materials[(*mesh_.surface_of_face)[i]];
      if (!material) material = material_of_(mesh_.surface(i));
      const Part part{*material, is_smooth(i)};
      const auto [known, is_new] = places.emplace(part, parts.size());
      if (is_new) {
        parts.push_back(part);
        corners.emplace_back();
      }
      append_triangles(i, corners[known->second]);
    }
    json primitives = json::array();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      json attributes = attributes_;
      if (parts[i].smooth) attributes["NORMAL"] = *normal_accessor_;
      last_indices_ = document_.add(corners[i], Use::Indices);
      primitives.push_back({{"attributes", std::move(attributes)},
                            {"indices", *last_indices_},
                            {"material", parts[i].material}});
    }
    if (parts.size() > 1) last_indices_.reset();
    return primitives;
  }

  bool is_smooth(std::size_t face) const {
    if (has_normal_.empty()) return false;
    const auto corners = mesh_.face(face);
    return std::all_of(corners.begin(), corners.end(),
                       [this](std::uint32_t corner) { return has_normal_[corner]; });
  }

  void append_triangles(std::size_t face, std::vector<std::uint32_t>& corners) {
    const grf::Triangulation& triangles = mesh_.geometry.triangulation();
    for (std::size_t i = triangles.first_of(face); i < triangles.first_of(face + 1); ++i) {
      for (const std::uint32_t corner : triangles[i]) corners.push_back(corner);
    }
  }

  void write_faces() {
    const bool all_triangles = mesh_.geometry->corners.size() == 3 * mesh_.face_count() && sizes_are_three();
    if (!all_triangles) {
      std::vector<std::uint32_t> sizes(mesh_.face_count());
      for (std::size_t i = 0; i < sizes.size(); ++i)
        sizes[i] = static_cast<std::uint32_t>(mesh_.face(i).size());
      lists_.sizes = document_.add(sizes, Use::Data);
    }
    lists_.corners =
        all_triangles && last_indices_ ? *last_indices_ : document_.add(mesh_.geometry->corners, Use::Data);
    const std::vector<bool> used = grf::used_surfaces(mesh_);
    if (std::count(used.begin(), used.end(), true) == 1) return;
    std::vector<std::uint32_t> place(used.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < used.size(); ++i) place[i] = used[i] ? next++ : 0;
    std::vector<std::uint32_t> surfaces(mesh_.face_count());
    std::transform(mesh_.surface_of_face->begin(), mesh_.surface_of_face->end(), surfaces.begin(),
                   [&](std::uint32_t surface) { return place[surface]; });
    lists_.surfaces = document_.add(surfaces, Use::Data);
  }

  bool sizes_are_three() const {
    for (std::size_t i = 0; i < mesh_.face_count(); ++i) {
      if (mesh_.face(i).size() != 3) return false;
    }
    return true;
  }

  const grf::Mesh& mesh_;
  const std::function<int(const grf::Surface&)>& material_of_;
  GltfDocument& document_;
  GltfMeshLists lists_;
  json attributes_ = json::object();
  std::optional<int> normal_accessor_;
  std::vector<bool> has_normal_;
  std::optional<int> last_indices_;  ///< indices of the primitive, if there is only one
  bool has_rays_ = false;
};

}  // namespace

WrittenMesh write_mesh(const grf::Mesh& mesh, const std::string& name,
                       const std::function<int(const grf::Surface&)>& material_of, GltfDocument& document) {
  return MeshWriter(mesh, material_of, document).run(name);
}

}  // namespace convert
