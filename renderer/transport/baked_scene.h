#pragma once

#include <cstddef>
#include <functional>
#include <optional>

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

/// The function gives the irradiance that arrives at the vertices of a mesh at one of its places, in the
/// mesh's coordinates; nothing leaves what the mesh has.
using ArrivingIrradiance = std::function<std::optional<grf::VertexIrradiance>(
    const grf::Mesh& mesh, const grf::Matrix44d& to_world)>;

/// Gives the vertices of a scene irradiance, mesh by mesh in the order of `grf::visit`, in place of what they
/// had; those of lights have none.
///
/// What arrives differs from place to place: of a mesh that is placed by `use` more than once, places with
/// other irradiance than the first get a copy, defined beside it as `name$2`, `name$3`, ... Includes are
/// kept, each with contents of its own.
BakedScene with_irradiance(grf::Scene scene, const ArrivingIrradiance& arriving);

/// The same for a flat scene (`grf::flatten`) and a bake of it that has ended.
BakedScene with_irradiance(grf::Scene scene, const Bake& bake);

/// False after an error if the copies that `with_irradiance` would make have more vertices than that, all
/// together: of a flat scene of which each has irradiance, a file would be hundreds of megabytes.
bool has_few_copies(const grf::Scene& scene, grf::Diagnostics& diagnostics,
                    std::size_t most_vertices = 5'000'000);

}  // namespace transport
