#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grf/math.h"

namespace convert {

struct ReferenceFace {
  std::vector<grf::Vec3d> corners;
  std::string material;  ///< empty: none was named before it
};

struct ReferenceModel {
  std::vector<ReferenceFace> faces;  ///< of three corners or more, in the order of the file

  double area() const;
  std::size_t distinct_positions() const;
};

/// Reads a valid OBJ file by a second, independent implementation: only positions, faces and materials.
ReferenceModel read_reference(const std::string& path);

}  // namespace convert
