// Lamps are looked for inside of solids, where their light goes nowhere.
#pragma once

#include <cstdint>
#include <vector>

#include "grf/scene.h"
#include "grf/scene_path.h"
#include "grf/visit.h"

namespace convert {

/// A lamp: an area light, a mesh light, or the emitting faces of a mesh.
struct Lamp {
  grf::ScenePath path;
  grf::SourceLocation location;
  const grf::Mesh* mesh = nullptr;   ///< null for an area light
  std::vector<std::uint32_t> faces;  ///< of the mesh, that emit
  std::vector<grf::Vec3d> points;    ///< on the lamp, in world space: at least one
  double area = 0;                   ///< in world space
};

class Lamps {
 public:
  static constexpr std::size_t MostLamps = 64;

  void add(const grf::AreaLight& light, const grf::Placement& placement, const grf::SourceLocation& location);
  void add(const grf::MeshLight& light, const grf::Placement& placement, const grf::SourceLocation& location);
  /// Adds the faces of a mesh that emit, if there are any.
  void add_emitting(const grf::Mesh& mesh, const grf::Placement& placement,
                    const grf::SourceLocation& location);

  /// Returns the `MostLamps` lamps of the largest area.
  std::vector<const Lamp*> largest() const;
  /// Returns a point of each lamp, in world space.
  std::vector<grf::Vec3d> points() const;

 private:
  void add_faces(const grf::Mesh& mesh, std::vector<std::uint32_t> faces, const grf::Placement& placement,
                 const grf::SourceLocation& location);

  std::vector<Lamp> lamps_;
};

/// The closed meshes of a scene.
class LampSolids {
 public:
  void add(const grf::Mesh& mesh, const grf::Matrix44d& to_world, const grf::Box3d& bounds);
  /// Returns a solid whose fronts point outward and that encloses all points of a lamp, or null.
  const grf::Mesh* around(const Lamp& lamp) const;

 private:
  struct Solid {
    const grf::Mesh* mesh;
    grf::Matrix44d to_object;
    grf::Box3d bounds;  ///< in world space
  };
  std::vector<Solid> solids_;
};

}  // namespace convert
