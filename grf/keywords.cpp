#include "grf/keywords.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

namespace grf {
namespace {

constexpr std::array<std::string_view, 7> ReservedWords = {"begin", "end",  "def",  "none",
                                                           "use",   "true", "false"};

bool is_reserved(std::string_view word) {
  return std::any_of(ReservedWords.begin(), ReservedWords.end(),
                     [word](std::string_view reserved) { return same_keyword(word, reserved); });
}

std::string escaped(char c) { return fmt::format("${:02x}$", static_cast<unsigned char>(c)); }

}  // namespace

std::string lower_case(std::string_view word) {
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return lower_case(c); });
  return lower;
}

bool is_identifier(std::string_view word) {
  return !word.empty() && is_word_start(word.front()) &&
         std::all_of(word.begin(), word.end(), is_word_character) && !is_reserved(word);
}

bool is_colour_keyword(std::string_view word) {
  return same_keyword(word, "rgb") || same_keyword(word, "colour") || same_keyword(word, "color");
}

bool is_value_word(std::string_view word) {
  return is_identifier(word) && !is_colour_keyword(word) && !same_keyword(word, "brdf") &&
         !same_keyword(word, "pdf") && !same_keyword(word, "texture");
}

std::string to_identifier(std::string_view text) {
  if (text.empty()) return "$$";
  std::string identifier;
  const bool escape_first = is_digit(text.front()) || is_reserved(text);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool escape = c == '$' || !is_word_character(c) || (i == 0 && escape_first);
    identifier += escape ? escaped(c) : std::string(1, c);
  }
  return identifier;
}

std::string from_identifier(std::string_view identifier) {
  std::string text;
  for (std::size_t i = 0; i < identifier.size(); ++i) {
    const std::size_t end = identifier[i] == '$' ? identifier.find('$', i + 1) : std::string_view::npos;
    unsigned code = 0;
    const char* first = identifier.data() + i + 1;
    const bool is_escape = end == i + 3 && std::from_chars(first, first + 2, code, 16).ptr == first + 2;
    if (is_escape) {
      text += static_cast<char>(code);
      i = end;
    } else if (end == i + 1) {
      i = end;  // `$$`, the empty text
    } else {
      text += identifier[i];
    }
  }
  return text;
}

}  // namespace grf
