// `check` validates geometry, too: degenerate faces, normals, and lights that illuminate nothing.
#pragma once

#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "grf/visit.h"

namespace grf {

/// Faces of one or more meshes that have the same defect.
struct FaceDefects {
  std::size_t count = 0;
  std::size_t first = 0;  ///< index of the first face in its mesh
  std::size_t meshes = 0;
};

/// Warns about degenerate faces (zero area), faces whose normals all point to the back, and textured faces
/// without uv: once per mesh if meshes have line numbers, and otherwise once per file.
class FaceCheck {
 public:
  /// Looks for defects of one mesh. For each of its surfaces, `reads_images` tells whether images need uv.
  void add(const Mesh& mesh, const std::vector<bool>& reads_images, const SourceLocation& location,
           Diagnostics& diagnostics);

  /// Reports the defects, once every mesh was added.
  void report(Diagnostics& diagnostics) const;

 private:
  struct Found {
    SourceLocation location;
    FaceDefects flat;
    FaceDefects turned;
    FaceDefects without_uv;
  };
  static void report(const Found& found, Diagnostics& diagnostics);

  std::vector<Found> without_lines_;  ///< one per file
};

/// Finds lights that face no geometry, and so cannot illuminate anything.
class LightCheck {
 public:
  /// Adds geometry that lights may face, or a light.
  void add(const Mesh& mesh, const Placement& placement);
  void add_light(const AreaLight& light, const Placement& placement, const Block& block);
  void add_light(const MeshLight& light, const Placement& placement, const Block& block);

  /// Reports the lights, once the whole scene was added.
  void report(Diagnostics& diagnostics) const;

 private:
  struct Body {
    const Mesh* mesh = nullptr;
    Matrix44d to_world;
  };
  struct Light {
    const Mesh* mesh = nullptr;  ///< null for a parallelogram
    Matrix44d to_world;
    Vec3d point = Vec3d(0);  ///< a corner of a parallelogram, with its normal
    Vec3d normal = Vec3d(0);
    SourceLocation location;
  };

  class Front;
  class World;

  static bool faces_something(const Light& light, const World& world);

  std::vector<Body> bodies_;
  std::vector<Light> lights_;
};

}  // namespace grf
