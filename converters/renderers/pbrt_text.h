#pragma once

#include <string>

#include "converters/renderers/written_scene.h"

namespace convert {

/// Returns what pbrt-v4 reads and has; its images around a scene are square.
RenderTarget pbrt_target();

/// Returns the text of a scene for pbrt-v4. Its world is ours: the camera's image is mirrored to make up for
/// the left-handed coordinates of pbrt, in which nothing else depends on the hand.
std::string pbrt_text(const WrittenScene& scene);

}  // namespace convert
