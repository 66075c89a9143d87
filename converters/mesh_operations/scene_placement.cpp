#include "converters/mesh_operations/scene_placement.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"

namespace convert {
namespace {

using Kind = grf::TransformStep::Kind;

std::vector<std::string> words_of(std::string_view text) {
  constexpr std::string_view Space = " \t\r\n(),";
  std::vector<std::string> words;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(Space), text.size()));
    if (text.empty()) return words;
    const std::size_t end = std::min(text.find_first_of(Space), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::optional<Kind> kind_of(const std::string& word) {
  if (grf::same_keyword(word, "scale")) return Kind::Scale;
  if (grf::same_keyword(word, "rotation")) return Kind::Rotation;
  if (grf::same_keyword(word, "translation")) return Kind::Translation;
  return std::nullopt;
}

std::optional<double> number_of(const std::string& word) {
  double number = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  const bool is_number = error == std::errc() && stop == end && std::isfinite(static_cast<float>(number));
  return is_number ? std::optional(number) : std::nullopt;
}

/// Parses three numbers from a word on; returns nothing if they are missing.
std::optional<grf::Vec3d> vector_at(const std::vector<std::string>& words, std::size_t at) {
  if (at + 3 > words.size()) return std::nullopt;
  grf::Vec3d vector;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = number_of(words[at + i]);
    if (!number) return std::nullopt;
    vector[static_cast<int>(i)] = *number;
  }
  return vector;
}

}  // namespace

std::span<const LengthUnit> length_units() {
  static constexpr std::array Units = {LengthUnit{"mm", 0.001}, LengthUnit{"cm", 0.01},
                                       LengthUnit{"inch", 0.0254}, LengthUnit{"foot", 0.3048},
                                       LengthUnit{"m", 1}};
  return Units;
}

std::optional<std::vector<grf::TransformStep>> read_transform_steps(std::string_view text,
                                                                    std::string& problem) {
  constexpr double Degree = std::numbers::pi / 180;
  const std::vector<std::string> words = words_of(text);
  std::vector<grf::TransformStep> steps;
  if (words.empty()) problem = "expected scale, rotation or translation";
  for (std::size_t i = 0; i < words.size() && problem.empty(); i += 4) {
    const auto kind = kind_of(words[i]);
    const auto vector = kind ? vector_at(words, i + 1) : std::nullopt;
    if (!kind) {
      problem = fmt::format("found '{}', expected scale, rotation or translation", words[i]);
    } else if (!vector) {
      problem = fmt::format("expected three numbers after '{}'", words[i]);
    } else {
      const grf::Vec3f value(*kind == Kind::Rotation ? *vector * Degree : *vector);
      if (*kind == Kind::Scale && (value.x == 0 || value.y == 0 || value.z == 0))
        problem = "a scale of zero makes the scene degenerate";
      steps.push_back({*kind, value});
    }
  }
  if (!problem.empty()) return std::nullopt;
  return steps;
}

grf::TransformStep z_up_to_y_up() {
  return {Kind::Rotation, grf::Vec3f(-std::numbers::pi_v<float> / 2, 0, 0)};
}

void place(grf::Scene& scene, const std::vector<grf::TransformStep>& steps,
           const grf::SourceLocation& location) {
  if (steps.empty()) return;
  grf::Transform transform;
  transform.steps = steps;
  transform.body = std::move(scene.contents);
  grf::Block block;
  block.content = std::move(transform);
  block.location = location;
  scene.contents = {};
  scene.contents.blocks.push_back(std::move(block));
}

}  // namespace convert
