#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/bake/bake.h"

namespace bake {

/// A scene with baked irradiance at its vertices.
struct BakedScene {
  grf::Scene scene;
  std::size_t shared_meshes = 0;  ///< placed by `use` more than once
  std::size_t copies = 0;         ///< made of the shared meshes
};

/// Returns the irradiance at the vertices of a mesh for one of its placements, in the mesh's coordinates;
/// empty leaves the mesh unchanged.
using ArrivingIrradiance = std::function<std::optional<grf::VertexIrradiance>(
    const grf::Mesh& mesh, const grf::Matrix44d& to_world)>;

/// Returns the scene with irradiance at its vertices, which replaces what they had, mesh by mesh in the order
/// of `grf::visit`; lights have none.
///
/// Irradiance differs between placements: where a mesh is placed by `use` more than once, placements whose
/// irradiance differs from the first one's get a copy, defined beside the mesh as `name$2`, `name$3`, ...
/// Includes are kept, each with its own contents.
BakedScene with_irradiance(grf::Scene scene, const ArrivingIrradiance& arriving);

/// Returns a flat scene (`grf::flatten`) with the irradiance of its finished bake.
BakedScene with_irradiance(grf::Scene scene, const Bake& bake);

/// Returns false after an error if the copies that `with_irradiance` would make have more vertices in total
/// than this: written out, a flat scene with irradiance per placement could take hundreds of megabytes.
bool has_few_copies(const grf::Scene& scene, grf::Diagnostics& diagnostics,
                    std::size_t most_vertices = 5'000'000);

}  // namespace bake
