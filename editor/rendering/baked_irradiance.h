#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "grf/scene.h"

namespace editor {

/// A scene after baked irradiance was applied.
struct IrradiatedScene {
  grf::Scene scene;
  std::size_t meshes = 0;             ///< number of mesh instances that received irradiance
  std::size_t skipped = 0;            ///< number of mesh instances that differ from the baked ones
  std::size_t expanded_includes = 0;  ///< number of includes that were replaced by their blocks
};

/// Holds the irradiance that a bake computed for a snapshot, to be applied to the current scene.
class BakedIrradiance {
 public:
  BakedIrradiance() = default;
  /// `baked` is `snapshot` with irradiance: includes may be replaced by their blocks and meshes copied, but
  /// their order is the same. Otherwise nothing is applied.
  BakedIrradiance(const grf::Scene& snapshot, const grf::Scene& baked);

  /// Applies the irradiance to each mesh instance whose vertices and transform equal those of the snapshot.
  /// The path is that of the scene's file.
  ///
  /// Includes are kept: a file that receives irradiance gets a name that ends in `.igrf`. One that is
  /// included at several places, which receive different light, becomes part of the scene. A scene without an
  /// observer gets that of the bake.
  IrradiatedScene applied_to(grf::Scene scene, const std::string& path) const;

 private:
  /// A mesh instance: its geometry, which the value keeps alive, and the matrix to world space.
  using Key = std::pair<const grf::Geometry*, std::array<double, 16>>;
  struct BakedMesh {
    grf::SharedGeometry geometry;
    grf::Shared<grf::VertexIrradiance> irradiance;
  };

  static Key key_of(const grf::Mesh& mesh, const grf::Matrix44d& to_world);

  std::map<Key, BakedMesh> places_;
  std::vector<grf::Vec3f> observers_;
};

}  // namespace editor
