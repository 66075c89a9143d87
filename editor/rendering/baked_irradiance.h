#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "grf/scene.h"

namespace editor {

/// A scene that has taken up irradiance.
struct IrradiatedScene {
  grf::Scene scene;
  std::size_t meshes = 0;      ///< places of meshes that have got irradiance
  std::size_t left_alone = 0;  ///< places of meshes that were not baked as they are now
  std::size_t dissolved = 0;   ///< includes whose blocks stand in the scene itself now
};

/// Keeps the irradiance that a bake found at the vertices of a snapshot, to be given to the scene as it is by
/// now.
class BakedIrradiance {
 public:
  BakedIrradiance() = default;
  /// The second scene is the first with irradiance: includes may be dissolved in it, and meshes copied, but
  /// their order is the same. Otherwise it is of no mesh.
  BakedIrradiance(const grf::Scene& snapshot, const grf::Scene& baked);

  /// Gives irradiance to each place of a mesh whose vertices and place are those of the snapshot. The path is
  /// that of the scene's file.
  ///
  /// Includes stay: a file that comes to have irradiance gets a name that ends in `.igrf`. One that is
  /// included at several places, where other light arrives, becomes part of the scene. A scene that names no
  /// observer takes over that of the bake.
  IrradiatedScene applied_to(grf::Scene scene, const std::string& path) const;

 private:
  /// A mesh at one of its places: its geometry, which the value keeps alive, and the matrix to the world.
  using Key = std::pair<const grf::Geometry*, std::array<double, 16>>;
  struct Arriving {
    grf::SharedGeometry geometry;
    grf::Shared<grf::VertexIrradiance> irradiance;
  };

  static Key key_of(const grf::Mesh& mesh, const grf::Matrix44d& to_world);

  std::map<Key, Arriving> places_;
  std::vector<grf::Vec3f> observers_;
};

}  // namespace editor
