#include "renderer/command/directions.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

namespace command {

// In double, so that a direction at the horizon is there and not beside it.
reflectance::Vec3f direction_of(const Angles& angles) {
  const double sine = std::sin(angles.theta);
  return {static_cast<float>(sine * std::cos(angles.phi)), static_cast<float>(sine * std::sin(angles.phi)),
          static_cast<float>(std::cos(angles.theta))};
}

std::optional<std::vector<double>> numbers_of(std::string_view text, std::size_t least, std::size_t most) {
  std::vector<double> numbers;
  const char* position = text.data();
  const char* end = position + text.size();
  const auto is_separator = [](char c) { return c == ' ' || c == ',' || c == '\t' || c == '\r'; };
  for (;;) {
    position = std::find_if_not(position, end, is_separator);
    if (position == end) break;
    const auto [behind, error] = std::from_chars(position, end, numbers.emplace_back());
    if (error != std::errc() || !std::isfinite(numbers.back())) return std::nullopt;
    position = behind;
  }
  if (numbers.size() < least || numbers.size() > most) return std::nullopt;
  return numbers;
}

std::optional<Angles> angles_option(const std::string& text, const char* option) {
  const auto angles = numbers_of(text, 1, 2);
  if (!angles) {
    fmt::print(stderr, "error: {}: '{}' is no direction, expected theta,phi in radians\n", option, text);
    return std::nullopt;
  }
  return Angles{angles->front(), angles->size() > 1 ? angles->back() : 0};
}

std::vector<double> light_angles(double view_degrees) {
  constexpr int StepsOfADegree = 10;
  constexpr int ClosestSteps = 18;  // down to about 1e-4 degrees
  std::vector<double> angles;
  for (int i = 0; i < 180 * StepsOfADegree; ++i) angles.push_back((i + 0.5) / StepsOfADegree - 90);
  for (const double peak : {view_degrees, -view_degrees}) {
    angles.push_back(peak);
    double distance = 1.0 / StepsOfADegree;
    for (int i = 0; i < ClosestSteps; ++i) {
      angles.push_back(peak - distance);
      angles.push_back(peak + distance);
      distance /= 1.5;
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace command
