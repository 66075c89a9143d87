#pragma once

#include <optional>
#include <string_view>

#include "grf/diagnostics.h"

namespace convert {

/// Validates an STL file and returns the bytes to give to Assimp: all of them, or the facets that a binary
/// header announces, with a warning about trailing bytes. Returns nothing after an error: a file that is
/// truncated, or not STL. Assimp itself trusts the count of facets modulo 2^32 bytes.
std::optional<std::string_view> check_stl(std::string_view bytes, const grf::SourceLocation& location,
                                          grf::Diagnostics& diagnostics);

/// Returns whether a file begins like STL in text. Binary files have no magic number.
bool is_text_stl(std::string_view first_bytes);

}  // namespace convert
