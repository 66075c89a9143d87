// The objects of a 3DS file are read from its chunks (3D Studio File Toolkit, Release 3: "3DS File Format").
// Assimp splits them into triangles without shared vertices and with wrong normals: it smooths faces without
// a smoothing group with all others, and replaces an index out of range by another one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/math.h"

namespace convert {

struct ThreeDsFace {
  static constexpr std::size_t NoMaterial = std::numeric_limits<std::size_t>::max();

  std::array<std::uint16_t, 3> corners = {};  ///< indices of positions of its object
  std::uint32_t groups = 0;                   ///< a bit per smoothing group
  std::size_t material = NoMaterial;          ///< index into the file's materials
};

struct ThreeDsObject {
  std::string name;
  std::vector<grf::Vec3f> positions;
  std::vector<ThreeDsFace> faces;
  std::size_t uv_count = 0;
};

struct ThreeDsFile {
  std::vector<ThreeDsObject> objects;  ///< triangle meshes, in the order of the file
  std::vector<std::string> materials;  ///< names, in the order of the file
};

/// Reads the objects; returns nothing after an error at the offset of a chunk, such as a truncated list or an
/// index out of range.
std::optional<ThreeDsFile> read_three_ds(std::string_view bytes, const grf::SourceLocation& location,
                                         grf::Diagnostics& diagnostics);

}  // namespace convert
