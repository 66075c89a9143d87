#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grf/math.h"

namespace convert {

/// A second, independent reading of a PLY file that is known to be sound: positions and faces alone.
struct ReferencePly {
  std::vector<grf::Vec3f> positions;
  std::vector<std::vector<std::size_t>> faces;

  double area() const;
  std::size_t distinct_positions() const;
  grf::Box3f bounds() const;
};

ReferencePly read_reference_ply(const std::string& path);

}  // namespace convert
