#pragma once

#include "converters/format.h"

namespace convert {

/// PLY, read in all of its encodings, and written binary.
Format ply_format();

/// PLY written as text. It is read as `ply`.
Format ply_ascii_format();

}  // namespace convert
