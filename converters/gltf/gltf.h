#pragma once

#include "converters/format.h"

namespace convert {

/// glTF 2 as JSON with its buffer beside it (`.bin`), and as one binary file.
Format gltf_format();
Format glb_format();

}  // namespace convert
