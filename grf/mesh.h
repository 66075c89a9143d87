#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "grf/comments.h"
#include "grf/geometry.h"
#include "grf/math.h"
#include "grf/shared.h"
#include "grf/surface.h"

namespace grf {

/// Irradiance at a vertex from one direction.
struct DirectionalIrradiance {
  Vec3f direction = Vec3f(0);  ///< toward the source, as written, not necessarily of unit length
  Colour irradiance = Colour(0);

  bool operator==(const DirectionalIrradiance&) const = default;
};

/// Irradiance in W/m2: one value for all directions together, or a list with one value per direction.
using Irradiance = std::variant<Colour, std::vector<DirectionalIrradiance>>;

/// Comments inside a mesh. Those inside the lists of vertices and faces are not kept.
struct MeshComments {
  Comments colour, brdf, pdf, texture, emission, opacity;  ///< of the mesh's own attributes
  Comments vertices, faces;                                ///< of the two lists as a whole
  std::vector<std::string> end;                            ///< before `end mesh`

  bool operator==(const MeshComments&) const = default;
};

/// Irradiance baked at vertices.
using VertexIrradiance = OptionalVertexValues<Irradiance>;

struct Mesh;

/// A mesh under construction, from which the final `Mesh` is made. Each face has a surface.
struct MeshDraft : Geometry {
  std::string name;
  MeshComments comments;
  VertexIrradiance irradiance;
  std::vector<Surface> surfaces = {Surface()};
  std::vector<std::uint32_t> surface_of_face;

  MeshDraft() = default;
  /// Copies a mesh to modify it.
  explicit MeshDraft(const Mesh& mesh);

  /// Appends a face of three corners or more, vertex indices in counter-clockwise order seen from the front.
  void add_face(std::span<const std::uint32_t> face_corners, std::uint32_t surface_index);
  /// Appends a copy of a mesh's vertex with all its attributes, and returns its index.
  std::uint32_t copy_vertex(const Mesh& from, std::uint32_t vertex);
  /// Frees the spare capacity of the arrays.
  void free_spare_memory();
};

/// A mesh: a shared geometry, the surfaces of its faces, and an index of a surface per face. Assigning a BRDF
/// copies no vertex, and editing a surface's BRDF copies no face. Copies share all large arrays.
struct Mesh {
  std::string name;  ///< may be empty; not with both plain and typographic (“ ”) quotes
  MeshComments comments;
  SharedGeometry geometry;
  Shared<VertexIrradiance> irradiance;

  /// The surfaces; the first has the attributes of the mesh itself (before its lists).
  std::vector<Surface> surfaces = {Surface()};
  Shared<std::vector<std::uint32_t>> surface_of_face;  ///< surface index per face of the geometry

  Mesh() = default;
  /// Moves a complete draft into a mesh; a draft that is still needed has to be copied first.
  Mesh(MeshDraft&& draft);  // NOLINT(google-explicit-constructor)

  /// Returns the number of faces, the vertices of one, or its surface.
  std::size_t face_count() const { return surface_of_face->size(); }
  std::span<const std::uint32_t> face(std::size_t index) const { return geometry->face(index); }
  const Surface& surface(std::size_t face_index) const { return surfaces[(*surface_of_face)[face_index]]; }

  /// Compares faces by the values of their surfaces, whatever the order of the surface list.
  friend bool operator==(const Mesh& a, const Mesh& b);
};

/// Returns, for each surface of a mesh, whether any face uses it.
std::vector<bool> used_surfaces(const Mesh& mesh);

/// Extracts a submesh: some faces of a mesh, in that order, and the vertices that they use. Its first surface
/// is that of the first face; it has no name and no comments.
Mesh submesh(const Mesh& mesh, std::span<const std::uint32_t> faces);

/// Deduplicates surfaces: returns one index in a mesh's list for surfaces with the same text (`written_key`),
/// and appends new ones to the list.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(std::vector<Surface>& surfaces) : surfaces_(&surfaces) {}
  /// Returns the index of a surface, which it adds if it is new.
  std::uint32_t index_of(const Surface& surface);

 private:
  std::vector<Surface>* surfaces_;
  std::unordered_map<std::string, std::uint32_t> by_key_;  ///< empty until a surface is asked for
};

}  // namespace grf
