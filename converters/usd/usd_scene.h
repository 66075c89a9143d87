// A scene as the text of a USD file, and what else is known after it was written.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "converters/format.h"
#include "converters/losses.h"
#include "converters/usd/exchange_material.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

struct UsdScene {
  std::string text;
  ExchangeMaterials materials;
  /// The faces of each material: the index of the material, and the path of a subset of a mesh.
  std::vector<std::pair<std::size_t, std::string>> assignments;
  std::size_t meshes = 0;
  Losses losses;
};

/// Makes the text of a USD file in `path` without a view, and its materials. The scene, which must outlive
/// the result, is without includes, and has file names relative to `path`.
UsdScene usd_scene_of(const grf::Scene& scene, const std::string& path);

/// Returns the same with the view of an OP file, or a default one. An image around the scene is written into
/// a folder beside the file. Nothing after an error.
std::optional<UsdScene> usd_scene_of(const grf::Scene& scene, const std::string& path,
                                     const WriteOptions& options, grf::Diagnostics& diagnostics);

}  // namespace convert
