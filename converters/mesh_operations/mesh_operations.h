// What `grfconvert` does to the meshes of a scene on their way.
#pragma once

#include <optional>

#include "converters/mesh_operations/subdivide.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

enum class Normals {
  Keep,
  Smooth,  ///< new ones, with creases
  Flat     ///< none
};

/// In this order they are done.
struct MeshOperations {
  std::optional<double> weld;      ///< distance, in the units of each mesh
  int smooth = 0;                  ///< steps
  std::optional<double> decimate;  ///< share of the triangles that is to be left, over 0, up to 1
  std::optional<Subdivision> subdivide;
  bool triangulate = false;
  Normals normals = Normals::Keep;
  double crease = 0;  ///< radians, for smooth normals

  bool any() const {
    return weld || smooth > 0 || decimate || subdivide || triangulate || normals != Normals::Keep;
  }
};

/// Does that to all meshes and mesh lights of the scene, of which none is in an included file, and says what
/// was lost and what could not be done, in one line a kind. A mesh that would have too many faces once it is
/// subdivided is an error, and no mesh is changed then.
void apply(const MeshOperations& operations, grf::Scene& scene, const grf::SourceLocation& location,
           grf::Diagnostics& diagnostics);

}  // namespace convert
