#pragma once

#include <vector>

#include "converters/gltf/gltf_file.h"
#include "converters/losses.h"
#include "grf/math.h"
#include "grf/scene.h"

namespace convert {

/// Converts the lights of a glTF file (KHR_lights_punctual), which have no size. GRF has only area lights, so
/// each becomes a small mesh that emits and reflects nothing, with the same intensity, in the file's unit of
/// luminance:
///
/// - A point light is an icosahedron of radius 0.05 m, or 1/200 of the scene's diagonal if that is less. Its
///   radiance is that of a sphere with this intensity in the mean over all directions.
/// - A spot light is a disc of that radius. On its axis it has the light's intensity; the cone is lost.
/// - A directional light is a disc as large as the sun (0.533 degrees across), 100 diagonals away.
class GltfLights {
 public:
  GltfLights(const GltfFile& file, Losses& losses) : file_(file), losses_(losses) {}

  static bool has_light(const tinygltf::Node& node);

  /// Takes the light of a node that has one, with the node's transform to the scene.
  void take(const tinygltf::Node& node, const grf::Matrix44d& to_scene);

  bool empty() const { return placed_.empty(); }

  /// Returns the meshes of the lights that were taken, for a scene with these bounds of its faces.
  std::vector<grf::Block> blocks(const grf::Box3d& bounds, const grf::SourceLocation& location) const;

 private:
  /// A light at its place.
  struct Placed {
    const tinygltf::Light* light = nullptr;
    grf::Vec3d place = grf::Vec3d(0);
    grf::Vec3d direction = grf::Vec3d(0);  ///< unit vector in which it shines
  };

  const GltfFile& file_;
  Losses& losses_;
  std::vector<Placed> placed_;
};

}  // namespace convert
