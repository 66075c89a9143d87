#include "editor/document/face_loops.h"

#include "grf/topology.h"

namespace editor {
namespace {

constexpr std::uint32_t InvalidIndex = grf::SharedEdges::InvalidIndex;

/// Selects from face to face across opposite edges.
class LoopWalk {
 public:
  LoopWalk(const grf::SharedGeometry& geometry, std::uint32_t mesh, FaceSelection& selection)
      : geometry_(geometry), edges_(geometry.edges()), mesh_(mesh), selection_(selection) {}

  /// Walks into a face from one of its edges. Returns whether the walk came back to that edge.
  bool run(const grf::HalfEdge& start) {
    grf::HalfEdge at = start;
    for (;;) {
      const std::uint32_t first = geometry_->face_offsets[at.face];
      if (geometry_->face_offsets[at.face + 1] - first != 4) return false;
      selection_.set({mesh_, at.face});
      const std::uint32_t opposite = first + (at.corner - first + 2) % 4;
      const std::uint32_t edge = edges_.at_corner(opposite);
      if (edge == InvalidIndex) return false;
      const auto of_faces = edges_.faces_at(edge);
      if (of_faces.size() != 2) return false;
      at = of_faces[of_faces[0].corner == opposite ? 1 : 0];
      if (at.corner == start.corner) return true;
    }
  }

 private:
  const grf::SharedGeometry& geometry_;
  const grf::SharedEdges& edges_;
  std::uint32_t mesh_;
  FaceSelection& selection_;
};

}  // namespace

FaceSelection face_loop(const SceneObjects& objects, FaceId face, std::uint32_t corner) {
  FaceSelection result(objects);
  const grf::SharedGeometry& geometry = objects.meshes[face.mesh].mesh->geometry;
  const std::uint32_t edge = geometry.edges().at_corner(geometry->face_offsets[face.face] + corner);
  if (edge == InvalidIndex) return result;
  const auto of_faces = geometry.edges().faces_at(edge);
  LoopWalk walk(geometry, face.mesh, result);
  if (of_faces.size() > 2) {
    // The loop ends at such an edge: it has only the side of the given face.
    for (const grf::HalfEdge& start : of_faces) {
      if (start.face == face.face) walk.run(start);
    }
    return result;
  }
  if (!walk.run(of_faces[0]) && of_faces.size() == 2) walk.run(of_faces[1]);
  return result;
}

FaceSelection crossing_face_loop(const SceneObjects& objects, FaceId face, std::uint32_t corner) {
  const std::size_t corners = objects.meshes[face.mesh].mesh->face(face.face).size();
  return face_loop(objects, face, static_cast<std::uint32_t>((corner + 1) % corners));
}

}  // namespace editor
