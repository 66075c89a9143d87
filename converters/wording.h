#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace convert {

/// Formats a count with the singular or plural text: "1 face was lost", "12 faces were lost".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// Formats a list of names for a message: "'a', 'b', 'c' and 4 more".
std::string listed(const std::vector<std::string>& names);

}  // namespace convert
