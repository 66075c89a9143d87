// Mesh geometry for drawing and picking consists of triangulated polygons, with the face of each triangle.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <ImathVec.h>

#include "editor/document/face_selection.h"
#include "editor/view/view_camera.h"
#include "grf/mesh.h"

namespace editor {

/// Vertex and index arrays for the GPU. Optional ones are empty if no vertex has a value.
struct TriangleArrays {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<grf::Vec3f> positions;
  std::vector<Imath::V4f> normals;     ///< w is 1, or 0 for a vertex without normal
  std::vector<Imath::V4f> colours;     ///< missing ones are 1
  std::vector<Imath::V4f> irradiance;  ///< W/m2 from all directions together; w as for normals
  std::vector<grf::Vec2f> uvs;         ///< missing ones are 0
  std::vector<Triangle> triangles;     ///< vertex indices
  std::vector<std::uint32_t> face_of_triangle;
};

/// The intersection of a ray and a triangle of a mesh.
struct MeshHit {
  double distance = 0;  ///< in lengths of the ray's direction
  std::uint32_t triangle = 0;
};

/// An immutable mesh geometry, which can be built in any thread.
class MeshGeometry {
 public:
  using Edge = std::array<std::uint32_t, 2>;

  explicit MeshGeometry(const grf::Mesh& mesh);

  const TriangleArrays& arrays() const { return arrays_; }
  /// The edges of the polygons, each once, without those of their triangulation, and without those of hidden
  /// faces only (one bit per face; empty: none is hidden). They are computed on each call, since few display
  /// modes need them.
  std::vector<Edge> edges(const FaceSelection::Faces& hidden = {}) const;
  const grf::Box3f& bounds() const { return bounds_; }
  /// The first triangle of a face; those of a face are consecutive.
  std::size_t first_triangle(std::uint32_t face) const { return geometry_.triangulation().first_of(face); }
  std::uint32_t face_count() const { return static_cast<std::uint32_t>(centres_.size()); }
  /// The centroids of faces' corners, and their unit normals, 0 for a face without area.
  const std::vector<grf::Vec3f>& centres() const { return centres_; }
  const std::vector<grf::Vec3f>& normals() const { return normals_; }

  /// The nearest intersection of a ray in local coordinates, with front or back faces; at equal distances the
  /// first triangle. Hidden faces are skipped (one bit per face; empty: none is hidden).
  std::optional<MeshHit> intersect(const ViewRay& ray, const FaceSelection::Faces& hidden = {}) const;

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
