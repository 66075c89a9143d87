#include "converters/mesh_operations/triangulate.h"

#include "converters/mesh_operations/rebuild.h"

namespace convert {

grf::Mesh triangulated(const grf::Mesh& mesh) {
  Rebuild rebuild(mesh);
  const grf::Triangulation& triangles = mesh.geometry.triangulation();
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    for (std::size_t i = triangles.first_of(face); i < triangles.first_of(face + 1); ++i) {
      rebuild.add_face(triangles[i], (*mesh.surface_of_face)[face]);
    }
  }
  return rebuild.take();
}

}  // namespace convert
