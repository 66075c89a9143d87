#include "renderer/command/part_arguments.h"

#include <charconv>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/command/json_values.h"

namespace command {
namespace {

/// Reads two whole numbers, not negative, with a separator between them.
std::optional<std::pair<int, int>> pair_of(std::string_view text, std::string_view separator) {
  const std::size_t middle = text.find(separator);
  if (middle == std::string_view::npos) return std::nullopt;
  const auto number = [](std::string_view digits) {
    int value = -1;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return problem == std::errc() && end == digits.data() + digits.size() ? value : -1;
  };
  const int first = number(text.substr(0, middle));
  const int second = number(text.substr(middle + separator.size()));
  if (first < 0 || second < 0) return std::nullopt;
  return std::pair(first, second);
}

/// Reads a range of numbers from the first to the last one.
std::optional<std::pair<int, int>> range_of(std::string_view text) {
  const auto range = pair_of(text, "..");
  const bool is_range = range && range->first <= range->second && range->second < transport::ImagePart::All;
  return is_range ? range : std::nullopt;
}

}  // namespace

std::optional<transport::ImagePart> image_part_of(const PartFlags& part_flags, OptionFlags& flags,
                                                  bool& is_right) {
  transport::ImagePart part;
  bool is_given = !part_flags.pilot.empty();
  const auto fail = [&](std::string_view flag, std::string_view expected) {
    fmt::print(stderr, "error: {}: expected {}\n", flag, expected);
    is_right = false;
  };
  const auto samples = flags.find("--samples");
  if (samples != flags.end() && samples->second.find("..") != std::string::npos) {
    is_given = true;
    const auto range = range_of(samples->second);
    if (!range) fail("--samples", "the first and the last sample, such as 128..255");
    if (range) std::tie(part.first_sample, part.end_sample) = std::pair(range->first, range->second + 1);
    flags.erase(samples);
  }
  if (!part_flags.tiles.empty()) {
    is_given = true;
    const auto range = range_of(part_flags.tiles);
    if (!range) fail("--tiles", "the first and the last tile, such as 0..99");
    if (range) std::tie(part.first_tile, part.end_tile) = std::pair(range->first, range->second + 1);
  }
  if (!part_flags.part.empty()) {
    is_given = true;
    const auto fraction = pair_of(part_flags.part, "/");
    const bool is_part = fraction && fraction->first >= 1 && fraction->first <= fraction->second;
    if (!is_part) fail("--part", "a number from 1 and the number of parts, such as 3/40");
    if (is_part) std::tie(part.index, part.count) = std::pair(fraction->first - 1, fraction->second);
  }
  return is_given ? std::optional(part) : std::nullopt;
}

std::string flags_text(const transport::ImagePart& part) {
  constexpr int All = transport::ImagePart::All;
  std::vector<std::string> words;
  if (part.first_sample != 0 || part.end_sample != All) {
    words.push_back(fmt::format("--samples {}..{}", part.first_sample, part.end_sample - 1));
  }
  if (part.first_tile != 0 || part.end_tile != All) {
    words.push_back(fmt::format("--tiles {}..{}", part.first_tile, part.end_tile - 1));
  }
  if (part.count > 1 || words.empty())
    words.push_back(fmt::format("--part {}/{}", part.index + 1, part.count));
  return fmt::format("{}", fmt::join(words, " "));
}

grf::ExitCode print_missing(const std::vector<transport::ImagePart>& missing, bool as_json) {
  auto list = nlohmann::json::array();
  for (const transport::ImagePart& part : missing) {
    list.push_back(flags_text(part));
    if (!as_json) fmt::print("{}\n", flags_text(part));
  }
  if (as_json) fmt::print("{}\n", json_text(nlohmann::json{{"missing", list}}, false));
  return list.empty() ? grf::ExitCode::Done : grf::ExitCode::BadInput;
}

}  // namespace command
