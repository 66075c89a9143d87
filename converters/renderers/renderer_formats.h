#pragma once

#include "converters/format.h"

namespace convert {

/// Scenes for other renderers, which are only written.
Format pbrt_format();
Format mitsuba_format();

}  // namespace convert
