// Directions are given on the command line as two angles in radians.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/studies/angles.h"

namespace command {

using studies::Angles;
using studies::direction_of;

/// Parses numbers separated by commas or blanks; nothing on other text, or a count outside [least, most].
std::optional<std::vector<double>> numbers_of(std::string_view text, std::size_t least, std::size_t most);

/// Parses `theta,phi`, where phi may be left out. Prints an error that names the option.
std::optional<Angles> angles_option(const std::string& text, const char* option);

}  // namespace command
