// Mesh operations of `grfconvert` change a scene between reading and writing.
#pragma once

#include <optional>

#include "converters/mesh_operations/subdivide.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

enum class Normals {
  Keep,
  Smooth,  ///< recompute smooth normals, with creases
  Flat     ///< remove normals
};

/// The mesh operations, in the order of their execution.
struct MeshOperations {
  std::optional<double> weld;      ///< distance, in the units of each mesh
  int smooth = 0;                  ///< steps
  std::optional<double> decimate;  ///< fraction of the triangles to keep, over 0, up to 1
  std::optional<Subdivision> subdivide;
  bool triangulate = false;
  Normals normals = Normals::Keep;
  double crease = 0;  ///< radians, for smooth normals

  bool any() const {
    return weld || smooth > 0 || decimate || subdivide || triangulate || normals != Normals::Keep;
  }
};

/// Applies the operations to all meshes and mesh lights of a scene without included meshes, and reports
/// losses and failures in one line per kind. If subdivision would give a mesh too many faces, that is an
/// error, and no mesh is changed.
void apply(const MeshOperations& operations, grf::Scene& scene, const grf::SourceLocation& location,
           grf::Diagnostics& diagnostics);

}  // namespace convert
