// A studio lights a first picture: a floor, a soft box and a rim light in proportion to the scene.
#pragma once

#include "editor/document/scene_objects.h"
#include "grf/scene.h"

namespace editor {

/// Adds a studio to a scene: a grey diffuse floor under the bounds of its meshes, a soft box from the upper
/// left in front (+z) and a rim light from behind. Radiances do not depend on the size: a white diffuse
/// object has a mean radiance of about 0.5 W/(sr m2).
grf::Scene add_studio(const grf::Scene& scene, const SceneObjects& objects);

}  // namespace editor
