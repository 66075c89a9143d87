// The objects of a 3DS file, read from its chunks (3D Studio File Toolkit, Release 3: "3DS File Format"). For
// Assimp's scene has them cut into triangles that share nothing, with normals that are wrong: it smooths
// faces without a smoothing group into all others, and takes an index that is out of range for another one.
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
  std::uint32_t groups = 0;                   ///< a bit for each smoothing group
  std::size_t material = NoMaterial;          ///< its place among the file's materials
};

struct ThreeDsObject {
  std::string name;
  std::vector<grf::Vec3f> positions;
  std::vector<ThreeDsFace> faces;
  std::size_t uv_count = 0;
};

struct ThreeDsFile {
  std::vector<ThreeDsObject> objects;  ///< those of triangles, in the order of the file
  std::vector<std::string> materials;  ///< names, in the order of the file
};

/// Nothing after an error, which has the offset of the chunk: a list that is cut off, an index out of range.
std::optional<ThreeDsFile> read_three_ds(std::string_view bytes, const grf::SourceLocation& location,
                                         grf::Diagnostics& diagnostics);

}  // namespace convert
