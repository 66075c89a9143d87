#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grf/math.h"

namespace convert {

/// Reads a valid PLY file by a second, independent implementation: only positions and faces.
struct ReferencePly {
  std::vector<grf::Vec3f> positions;
  std::vector<std::vector<std::size_t>> faces;

  double area() const;
  std::size_t distinct_positions() const;
  grf::Box3f bounds() const;
};

ReferencePly read_reference_ply(const std::string& path);

}  // namespace convert
