#pragma once

#include <string>

#include "tests/converters/obj/reference_obj.h"

namespace convert {

/// A second, independent reading of an STL file, in text or binary, that is known to be sound.
ReferenceModel read_reference_stl(const std::string& path);

/// The same of an OFF file of positions and faces alone.
ReferenceModel read_reference_off(const std::string& path);

}  // namespace convert
