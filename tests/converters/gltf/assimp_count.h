#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "grf/math.h"
#include "grf/scene.h"

namespace convert {

/// What can be counted of a model whoever reads it. Instances count each.
struct ModelCount {
  std::size_t faces = 0;
  std::size_t positions = 0;  ///< distinct ones of each mesh's faces
  double area = 0;            ///< in the world
  grf::Box3d bounds;
};

/// What Assimp makes of a file, without any step of its own behind the reading; nothing if it cannot read it.
std::optional<ModelCount> assimp_count(const std::string& path);

/// The same of a scene.
ModelCount count_of(const grf::Scene& scene);

}  // namespace convert
