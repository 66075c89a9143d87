#pragma once

#include "converters/format.h"

namespace convert {

/// The format OFF, Geomview's Object File Format, in text (Geomview manual, section 4.2.5). It is read
/// without Assimp, which drops faces of ten corners or more, replaces an index out of range by another one,
/// reads a comment as a vertex, and loses the colours of faces.
Format off_format();

}  // namespace convert
