// Directions as people write them: two angles in radians.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/reflectance/geometry.h"

namespace command {

struct Angles {
  double theta = 0;  ///< from the normal
  double phi = 0;    ///< from the x axis
};

reflectance::Vec3f direction_of(const Angles& angles);

/// Numbers that commas or blanks separate, or nothing if there is anything else or another count of them.
std::optional<std::vector<double>> numbers_of(std::string_view text, std::size_t least, std::size_t most);

/// `theta,phi`, where phi may be left out. What is wrong with the option of that name is printed.
std::optional<Angles> angles_option(const std::string& text, const char* option);

}  // namespace command
