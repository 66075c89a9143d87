// A mesh as the 3D view draws and picks it: polygons cut into triangles, with the face of each.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <ImathVec.h>

#include "editor/view/view_camera.h"
#include "grf/mesh.h"

namespace editor {

/// Arrays as the graphics card takes them. Optional ones are empty where no vertex has a value.
struct TriangleArrays {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<grf::Vec3f> positions;
  std::vector<Imath::V4f> normals;     ///< w is 1, or 0 for a vertex without one
  std::vector<Imath::V4f> colours;     ///< absent ones are 1
  std::vector<Imath::V4f> irradiance;  ///< W/m2 of all directions together; w as for normals
  std::vector<grf::Vec2f> uvs;         ///< absent ones are 0
  std::vector<Triangle> triangles;     ///< vertices
  std::vector<std::uint32_t> face_of_triangle;
};

/// Where a ray meets a triangle of a mesh.
struct MeshHit {
  double distance = 0;  ///< in lengths of the ray's direction
  std::uint32_t triangle = 0;
};

/// Immutable, and made in any thread.
class MeshGeometry {
 public:
  using Edge = std::array<std::uint32_t, 2>;

  explicit MeshGeometry(const grf::Mesh& mesh);

  const TriangleArrays& arrays() const { return arrays_; }
  /// Of the polygons, not of the triangles that they are cut into; each once. They are found anew at each
  /// call, since few display modes need them.
  std::vector<Edge> edges() const;
  const grf::Box3f& bounds() const { return bounds_; }
  /// The triangles of a face follow each other.
  std::size_t first_triangle(std::uint32_t face) const { return geometry_.triangulation().first_of(face); }
  std::uint32_t face_count() const { return static_cast<std::uint32_t>(centres_.size()); }
  /// The means of faces' corners, and their unit normals, 0 for a face without area.
  const std::vector<grf::Vec3f>& centres() const { return centres_; }
  const std::vector<grf::Vec3f>& normals() const { return normals_; }

  /// The nearest triangle on a ray in the mesh's coordinates, from both sides; of two at one place the first.
  std::optional<MeshHit> intersect(const ViewRay& ray) const;

 private:
  void cut_faces();
  void enclose_triangles();

  grf::SharedGeometry geometry_;
  TriangleArrays arrays_;
  std::vector<grf::Vec3f> centres_;
  std::vector<grf::Vec3f> normals_;
  grf::Box3f bounds_;
  std::vector<grf::Box3f> boxes_;  // of so many triangles each, which lie near each other in most meshes
};

}  // namespace editor
