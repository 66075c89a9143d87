#include "converters/vrml/node.h"

#include <cmath>

#include <fmt/format.h>

#include "converters/vrml/lexer.h"
#include "converters/wording.h"

namespace convert::vrml {

const Field* NodeReader::find(std::string_view name) const {
  for (std::size_t i = node_.fields.size(); i > 0; --i) {
    if (node_.fields[i - 1].name == name) return &node_.fields[i - 1];
  }
  return nullptr;
}

template <class T>
const T* NodeReader::value(std::string_view name, std::string_view expected) const {
  const Field* field = find(name);
  if (field == nullptr || std::holds_alternative<std::monostate>(field->value)) return nullptr;
  const T* value = std::get_if<T>(&field->value);
  if (value == nullptr) error_at(name, fmt::format("the field '{}' is {}", name, expected));
  return value;
}

std::span<const double> NodeReader::exactly(std::string_view name, std::size_t count) const {
  const auto* numbers = value<std::vector<double>>(
      name, count == 1 ? std::string("a number") : fmt::format("{} numbers", count));
  if (numbers == nullptr) return {};
  if (numbers->size() == count) return *numbers;
  error_at(name, fmt::format("the field '{}' has {}, expected {}", name,
                             counted(numbers->size(), "number", "numbers"), count));
  return {};
}

double NodeReader::number(std::string_view name, double fallback) const {
  const auto number = exactly(name, 1);
  return number.empty() ? fallback : number[0];
}

grf::Vec2d NodeReader::pair(std::string_view name, const grf::Vec2d& fallback) const {
  const auto numbers = exactly(name, 2);
  return numbers.empty() ? fallback : grf::Vec2d(numbers[0], numbers[1]);
}

grf::Vec3d NodeReader::triple(std::string_view name, const grf::Vec3d& fallback) const {
  const auto numbers = exactly(name, 3);
  return numbers.empty() ? fallback : grf::Vec3d(numbers[0], numbers[1], numbers[2]);
}

bool NodeReader::flag(std::string_view name, bool fallback) const {
  // VRML 1.0 also has 0 and 1 as booleans.
  const Field* field = find(name);
  if (field != nullptr && std::holds_alternative<std::vector<double>>(field->value)) {
    return number(name, fallback ? 1 : 0) != 0;
  }
  const auto word = words(name);
  if (word.empty()) return fallback;
  const bool is_true = word[0] == "TRUE" || word[0] == "true";
  const bool is_false = word[0] == "FALSE" || word[0] == "false";
  if (word.size() != 1 || !(is_true || is_false)) {
    error_at(name, fmt::format("the field '{}' is TRUE or FALSE", name));
    return fallback;
  }
  return is_true;
}

int NodeReader::integer(std::string_view name, int fallback) const {
  constexpr double Largest = 2147483647;
  const double value = number(name, fallback);
  if (value == std::floor(value) && std::abs(value) <= Largest) return static_cast<int>(value);
  error_at(name, fmt::format("the field '{}' is a whole number", name));
  return fallback;
}

std::span<const double> NodeReader::numbers(std::string_view name, std::size_t group_size) const {
  const auto* numbers = value<std::vector<double>>(name, "a list of numbers");
  if (numbers == nullptr) return {};
  if (numbers->size() % group_size == 0) return *numbers;
  error_at(name, fmt::format("the field '{}' has {}, which is not a multiple of {}", name,
                             counted(numbers->size(), "number", "numbers"), group_size));
  return {};
}

std::vector<std::string> NodeReader::strings(std::string_view name) const {
  const Field* field = find(name);
  std::vector<std::string> strings;
  if (field == nullptr) return strings;
  if (const auto* words = std::get_if<Words>(&field->value)) {
    for (const std::string_view word : words->words) strings.emplace_back(word);
  } else if (const auto* texts = value<Strings>(name, "a string")) {
    for (const std::string_view text : texts->texts) strings.push_back(unescaped(text));
  }
  return strings;
}

std::span<const std::string_view> NodeReader::words(std::string_view name) const {
  const auto* words = value<Words>(name, "a word without quotes");
  return words == nullptr ? std::span<const std::string_view>() : words->words;
}

std::span<const Node* const> NodeReader::nodes(std::string_view name) const {
  const auto* nodes = value<std::vector<const Node*>>(name, "of nodes");
  return nodes == nullptr ? std::span<const Node* const>() : *nodes;
}

const Node* NodeReader::node(std::string_view name) const {
  const auto all = nodes(name);
  if (all.size() > 1) error_at(name, fmt::format("the field '{}' has one node at most", name));
  return all.empty() ? nullptr : all.front();
}

void NodeReader::error_at_number(std::string_view name, std::size_t index, std::string_view message) const {
  const Field* field = find(name);
  if (field == nullptr) return diagnostics_.error(node_.location(), message);
  Lexer lexer(*node_.source, field->value_offset);
  if (lexer.peek().is('[')) lexer.next();
  for (std::size_t i = 0; i < index; ++i) lexer.next();
  diagnostics_.error(node_.source->location(lexer.peek().offset), message);
}

void NodeReader::error_at(std::string_view name, std::string_view message) const {
  const Field* field = find(name);
  diagnostics_.error(field == nullptr ? node_.location() : node_.source->location(field->offset), message);
}

}  // namespace convert::vrml
