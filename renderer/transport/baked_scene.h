#pragma once

#include <cstddef>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/transport/bake.h"

namespace transport {

/// A scene with what arrives at its vertices.
struct BakedScene {
  grf::Scene scene;
  std::size_t shared_meshes = 0;  ///< that are placed by `use` more than once
  std::size_t copies = 0;         ///< that were made of them
};

/// Gives the vertices of a flat scene (`grf::flatten`) the irradiance of a bake that has ended, in place of
/// what they had; those of lights have none. Directions are in the mesh's coordinates, as positions are.
///
/// What arrives differs from place to place: of a mesh that is placed by `use` more than once, all places but
/// the first get a copy, defined beside it as `name$2`, `name$3`, ...
BakedScene with_irradiance(grf::Scene scene, const Bake& bake);

/// False after an error if the copies that `with_irradiance` would make have more vertices than that, all
/// together: of a flat scene of which each has irradiance, a file would be hundreds of megabytes.
bool has_few_copies(const grf::Scene& scene, grf::Diagnostics& diagnostics,
                    std::size_t most_vertices = 5'000'000);

}  // namespace transport
