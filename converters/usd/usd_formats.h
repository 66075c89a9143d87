#pragma once

#include "converters/format.h"

namespace convert {

/// Scenes of USD as text, and documents of MaterialX, which are only written.
Format usd_format();
Format materialx_format();

}  // namespace convert
