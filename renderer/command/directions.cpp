#include "renderer/command/directions.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

namespace command {

std::optional<std::vector<double>> numbers_of(std::string_view text, std::size_t least, std::size_t most) {
  std::vector<double> numbers;
  const char* position = text.data();
  const char* end = position + text.size();
  const auto is_separator = [](char c) { return c == ' ' || c == ',' || c == '\t' || c == '\r'; };
  for (;;) {
    position = std::find_if_not(position, end, is_separator);
    if (position == end) break;
    const auto [next, error] = std::from_chars(position, end, numbers.emplace_back());
    if (error != std::errc() || !std::isfinite(numbers.back())) return std::nullopt;
    position = next;
  }
  if (numbers.size() < least || numbers.size() > most) return std::nullopt;
  return numbers;
}

std::optional<Angles> angles_option(const std::string& text, const char* option) {
  const auto angles = numbers_of(text, 1, 2);
  if (!angles) {
    fmt::print(stderr, "error: {}: '{}' is not a direction, expected theta,phi in radians\n", option, text);
    return std::nullopt;
  }
  return Angles{angles->front(), angles->size() > 1 ? angles->back() : 0};
}

}  // namespace command
