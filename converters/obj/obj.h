#pragma once

#include "converters/format.h"

namespace convert {

/// Wavefront OBJ with its MTL material libraries.
Format obj_format();

}  // namespace convert
