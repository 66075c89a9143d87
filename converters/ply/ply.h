#pragma once

#include "converters/format.h"

namespace convert {

/// The format PLY, read in all of its encodings, and written as binary.
Format ply_format();

/// The format PLY written as text. It is read as `ply`.
Format ply_ascii_format();

}  // namespace convert
