#include "converters/obj/mtl_image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "grf/keywords.h"

namespace convert {
namespace {

/// An option of texture maps, and its arguments.
struct Option {
  std::string_view name;
  std::size_t most_values = 1;
  bool takes_numbers = false;       ///< arguments end at the first word that is no number
  std::string_view without_effect;  ///< the default values, which have no effect; empty: any values
};

constexpr std::array<Option, 13> Options = {{
    {"-s", 3, true, "1 1 1"},
    {"-o", 3, true, "0 0 0"},
    {"-t", 3, true, "0 0 0"},
    {"-mm", 2, true, "0 1"},
    {"-bm", 1, true, "1"},
    {"-boost", 1, true, "0"},
    {"-texres", 1, true, ""},
    {"-blendu", 1, false, "on"},
    {"-blendv", 1, false, "on"},
    {"-cc", 1, false, "off"},
    {"-clamp", 1, false, "off"},
    {"-imfchan", 1, false, ""},
    {"-type", 1, false, ""},
}};

const Option* find_option(std::string_view word) {
  const auto* found = std::find_if(Options.begin(), Options.end(), [word](const Option& option) {
    return grf::same_keyword(option.name, word);
  });
  return found == Options.end() ? nullptr : found;
}

using Words = std::span<const std::string_view>;

/// Returns the arguments of an option: all that it takes, or those that are numbers.
Words values_of(const Option& option, Words words) {
  std::size_t count = 0;
  while (count < std::min(option.most_values, words.size()) &&
         (!option.takes_numbers || parse_number(words[count]))) {
    ++count;
  }
  return words.first(count);
}

bool has_effect(const Option& option, Words values) {
  std::string_view expected = option.without_effect;
  for (const std::string_view value : values) {
    const std::string_view word = expected.substr(0, expected.find(' '));
    expected.remove_prefix(std::min(word.size() + 1, expected.size()));
    const bool is_same =
        option.takes_numbers ? parse_number(value) == parse_number(word) : grf::same_keyword(value, word);
    if (!is_same) return true;
  }
  return false;
}

// One or two numbers leave the other components at their defaults.
void assign(grf::Vec2d& target, Words values) {
  if (!values.empty()) target.x = *parse_number(values[0]);
  if (values.size() > 1) target.y = *parse_number(values[1]);
}

/// Returns everything from a word on, which may have spaces and a `#`.
std::string text_from(const Statement& statement, std::size_t argument) {
  const std::string text = statement.text();
  const char* begin = statement.arguments[argument].data();
  const auto before = static_cast<std::size_t>(begin - statement.rest.data());
  if (text == statement.rest) return text.substr(before);
  std::string joined;  // continued over several lines
  for (std::size_t i = argument; i < statement.arguments.size(); ++i) {
    joined.append(joined.empty() ? "" : " ").append(statement.arguments[i]);
  }
  return joined;
}

}  // namespace

std::optional<MtlImage> parse_image(const Statement& statement) {
  MtlImage image;
  const Words words(statement.arguments);
  std::size_t i = 0;
  while (i < words.size()) {
    const Option* option = find_option(words[i]);
    if (option == nullptr) break;
    const Words values = values_of(*option, words.subspan(i + 1));
    if (option->name == "-s") {
      assign(image.uv.scale, values);
    } else if (option->name == "-o") {
      assign(image.uv.offset, values);
    } else {
      image.has_other_options = image.has_other_options || has_effect(*option, values);
    }
    i += 1 + values.size();
  }
  if (i == words.size()) return std::nullopt;
  image.name = text_from(statement, i);
  if (image.name.size() > 2 && image.name.front() == '"' && image.name.back() == '"') {
    image.name = image.name.substr(1, image.name.size() - 2);
  }
  std::replace(image.name.begin(), image.name.end(), '\\', '/');
  return image;
}

}  // namespace convert
