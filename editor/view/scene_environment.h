#pragma once

#include <memory>
#include <vector>

#include "renderer/studies/brdf_viewer/lit_object.h"
#include "renderer/studies/environment/map_lights.h"

namespace editor {

/// The environment of a scene as views show it: reduced, with the rotation and brightness of its options.
struct SceneEnvironment {
  studies::Environment sky;   ///< of the kind Map, or None
  studies::MapLights lights;  ///< of the map as it is in its file
  /// An image behind the scene that lights nothing; null: none.
  std::shared_ptr<const image::Image> backplate;
  float backplate_scale = 1;  ///< factor of its radiance

  bool is_map() const { return sky.kind == studies::Environment::Kind::Map; }
  /// The lights in world space, as bright as the options make them.
  std::vector<reflectance::DistantLight> world_lights() const;
  /// The limit of the rest, likewise.
  float limit() const { return lights.limit * sky.scale.x; }
};

}  // namespace editor
