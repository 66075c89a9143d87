#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grf {

/// Formats a count with the singular or plural text: "1 face was lost", "12 faces were lost".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace grf
