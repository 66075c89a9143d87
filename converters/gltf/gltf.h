#pragma once

#include "converters/format.h"

namespace convert {

/// The formats glTF 2: JSON with its buffer beside it (`.bin`), and one binary file.
Format gltf_format();
Format glb_format();

}  // namespace convert
