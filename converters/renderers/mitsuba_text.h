#pragma once

#include <string>

#include "converters/renderers/written_scene.h"

namespace convert {

/// Returns what the RGB variants of Mitsuba 3 read and have.
RenderTarget mitsuba_target();

/// Returns the text of a scene for Mitsuba 3, as XML.
std::string mitsuba_text(const WrittenScene& scene);

}  // namespace convert
