#pragma once

#include "converters/format.h"

namespace convert {

/// The format Wavefront OBJ, with its MTL material libraries.
Format obj_format();

}  // namespace convert
