#pragma once

#include <optional>
#include <string_view>

#include "grf/diagnostics.h"

namespace convert {

/// What of an STL file Assimp may read: all of it, or what a binary one announces, with a warning of what
/// follows. Nothing after an error: a file that is cut off, or none of the format. Assimp by itself takes a
/// count of facets modulo 2^32 bytes at its word.
std::optional<std::string_view> check_stl(std::string_view bytes, const grf::SourceLocation& location,
                                          grf::Diagnostics& diagnostics);

/// True of a file that begins as STL in text does. Binary files have no mark of their own.
bool is_text_stl(std::string_view first_bytes);

}  // namespace convert
