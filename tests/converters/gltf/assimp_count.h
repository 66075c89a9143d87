#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "grf/math.h"
#include "grf/scene.h"

namespace convert {

/// Statistics of a model that do not depend on the reader. Instances count.
struct ModelCount {
  std::size_t faces = 0;
  std::size_t positions = 0;  ///< distinct ones of each mesh's faces
  double area = 0;            ///< in the world
  grf::Box3d bounds;
};

/// Counts a file imported by Assimp without post-processing; nothing if Assimp cannot read it.
std::optional<ModelCount> assimp_count(const std::string& path);

/// Counts a scene likewise.
ModelCount count_of(const grf::Scene& scene);

}  // namespace convert
