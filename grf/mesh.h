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

/// What arrives at a vertex from one direction.
struct DirectionalIrradiance {
  Vec3f direction = Vec3f(0);  ///< towards where it comes from, as written, not necessarily of unit length
  Colour irradiance = Colour(0);

  bool operator==(const DirectionalIrradiance&) const = default;
};

/// One value for all directions together, or one for each of a list. W/m2.
using Irradiance = std::variant<Colour, std::vector<DirectionalIrradiance>>;

/// Comments inside a mesh. Those inside the lists of vertices and faces are not kept.
struct MeshComments {
  Comments colour, brdf, pdf, texture, emission;  ///< of the mesh's own attributes
  Comments vertices, faces;                       ///< of the two lists as a whole
  std::vector<std::string> end;                   ///< before `end mesh`

  bool operator==(const MeshComments&) const = default;
};

/// Values at vertices that were lit by some earlier computation.
using VertexIrradiance = OptionalVertexValues<Irradiance>;

struct Mesh;

/// A mesh while it is being filled: a `Mesh` is made of it when it is whole. Each face has a surface.
struct MeshDraft : Geometry {
  std::string name;
  MeshComments comments;
  VertexIrradiance irradiance;
  std::vector<Surface> surfaces = {Surface()};
  std::vector<std::uint32_t> surface_of_face;

  MeshDraft() = default;
  /// A copy that can be changed.
  explicit MeshDraft(const Mesh& mesh);

  /// Three corners or more, each the index of a vertex, counter-clockwise seen from the front.
  void add_face(std::span<const std::uint32_t> face_corners, std::uint32_t surface_index);
  /// Appends a vertex of a mesh, with all that it has, and gives its index.
  std::uint32_t copy_vertex(const Mesh& from, std::uint32_t vertex);
  /// Gives back what the arrays have in reserve.
  void free_spare_memory();
};

/// A geometry and, beside it, what its faces are made of: giving them a BRDF copies no vertex, and changing
/// the BRDF that they have no face. Copies share all that is large.
struct Mesh {
  std::string name;  ///< may be empty; not with both plain and typographic (“ ”) quotes
  MeshComments comments;
  SharedGeometry geometry;
  Shared<VertexIrradiance> irradiance;

  /// The first surface is what the mesh says before its lists; faces with other attributes have others.
  std::vector<Surface> surfaces = {Surface()};
  Shared<std::vector<std::uint32_t>> surface_of_face;  ///< one for each face of the geometry

  Mesh() = default;
  /// The same, when it is whole. Nothing is copied: a draft that is still needed has to be copied by name.
  Mesh(MeshDraft&& draft);  // NOLINT(google-explicit-constructor)

  std::size_t face_count() const { return surface_of_face->size(); }
  std::span<const std::uint32_t> face(std::size_t index) const { return geometry->face(index); }
  const Surface& surface(std::size_t face_index) const { return surfaces[(*surface_of_face)[face_index]]; }

  /// Compares faces by what their surfaces are, not by the order in which the list has them.
  friend bool operator==(const Mesh& a, const Mesh& b);
};

/// Which of a mesh's surfaces its faces have.
std::vector<bool> used_surfaces(const Mesh& mesh);

/// A mesh of some faces of another one, in that order, and of the vertices that they use. Its own surface is
/// the first face's; it has no name and no comments.
Mesh part_of(const Mesh& mesh, std::span<const std::uint32_t> faces);

/// Gives surfaces that are written alike one index in a mesh's list, and appends those that it lacks.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(std::vector<Surface>& surfaces) : surfaces_(&surfaces) {}
  std::uint32_t index_of(const Surface& surface);

 private:
  std::vector<Surface>* surfaces_;
  std::unordered_map<std::string, std::uint32_t> by_key_;  ///< empty until a surface is asked for
};

}  // namespace grf
