#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grf {

/// Formats a count with the singular or plural text: "1 face was lost", "12 faces were lost".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// Formats a size in memory with three digits: "12 bytes", "3.14 KB", "2.5 MB".
std::string bytes_text(std::size_t bytes);

}  // namespace grf
