#pragma once

#include <string>

#include "tests/converters/obj/reference_obj.h"

namespace convert {

/// Reads a valid STL file, in text or binary, by a second, independent implementation.
ReferenceModel read_reference_stl(const std::string& path);

/// Reads a valid OFF file of only positions and faces likewise.
ReferenceModel read_reference_off(const std::string& path);

}  // namespace convert
