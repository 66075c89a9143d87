#pragma once

#include "converters/format.h"

namespace convert {

/// Object File Format of Geomview, in text (Geomview manual, section 4.2.5). Read without Assimp, which
/// leaves out faces of ten corners or more, takes an index that is out of range for another one and a comment
/// for a vertex, and loses the colours of faces.
Format off_format();

}  // namespace convert
