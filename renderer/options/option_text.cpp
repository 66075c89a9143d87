#include "renderer/options/option_text.h"

#include <concepts>

#include <fmt/format.h>

namespace options {
namespace {

// fmt writes the fewest digits that give the number back.
template <class Number>
requires std::integral<Number> || std::floating_point<Number> std::string text_of(Number number) {
  return fmt::format("{}", number);
}

std::string text_of(const std::string& text) { return text; }

std::string text_of(const ImageSize& size) { return fmt::format("{} {}", size.width, size.height); }

std::string text_of(const IntegerPair& pair) { return fmt::format("{} {}", pair.first, pair.second); }

std::string text_of(const grf::Vec3f& vector) {
  return fmt::format("{} {} {}", vector.x, vector.y, vector.z);
}

template <class Value>
std::string text_of(const std::optional<Value>& value) {
  return value ? text_of(*value) : "";
}

}  // namespace

std::string option_text(const RenderOptions& options, const OptionInfo& option) {
  return std::visit([&](const auto& value) { return text_of(options.*value.field); }, option.value);
}

}  // namespace options
