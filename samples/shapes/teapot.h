#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grf/mesh.h"

namespace shape {

/// A grid of positions and unit normals, and its faces of three or four corners.
struct Patch {
  std::vector<grf::Vec3f> positions;
  std::vector<grf::Vec3f> normals;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// The patches of the Utah teapot, of so many quads along a side each. y is up, and it stands on y = 0.
std::vector<Patch> teapot_patches(int subdivisions);
/// The same as one mesh.
grf::Mesh teapot(int subdivisions);

}  // namespace shape
