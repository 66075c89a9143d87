// The part of `check` that looks at shapes and places.
#pragma once

#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "grf/visit.h"

namespace grf {

/// Faces of one or more meshes that something is wrong with.
struct Offenders {
  std::size_t count = 0;
  std::size_t first = 0;  ///< in its mesh
  std::size_t meshes = 0;
};

/// Warns of faces that have no area, that have all their normals on their back, or that have a texture and no
/// place in it: mesh by mesh if meshes have lines of their own, and else of all meshes of a file in one.
class FaceCheck {
 public:
  void add(const Mesh& mesh, const SourceLocation& location, Diagnostics& diagnostics);

  /// Once everything was added.
  void report(Diagnostics& diagnostics) const;

 private:
  struct Found {
    SourceLocation location;
    Offenders flat;
    Offenders turned;
    Offenders without_uv;
  };
  static void report(const Found& found, Diagnostics& diagnostics);

  std::vector<Found> without_lines_;  ///< one a file
};

/// Finds the lights in front of which there is nothing that they could light.
class LightCheck {
 public:
  void add(const Mesh& mesh, const Placement& placement);
  void add_light(const AreaLight& light, const Placement& placement, const Block& block);
  void add_light(const MeshLight& light, const Placement& placement, const Block& block);

  /// Once everything was added.
  void report(Diagnostics& diagnostics) const;

 private:
  struct Body {
    const Mesh* mesh = nullptr;
    Matrix44d to_world;
  };
  struct Light {
    const Mesh* mesh = nullptr;  ///< null for a parallelogram
    Matrix44d to_world;
    Vec3d point = Vec3d(0);  ///< of a parallelogram, with its normal
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
