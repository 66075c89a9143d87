// GRF words follow spelling rules that the lexer, the parser, the writer and the catalogue share.
#pragma once

#include <string>
#include <string_view>

namespace grf {

// Only ASCII counts, independent of the locale: a scene means the same on every machine.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
constexpr bool is_word_start(char c) {
  const char lower = lower_case(c);
  return (lower >= 'a' && lower <= 'z') || c == '_' || c == '$';
}
/// Returns whether a word may have the character, but at its start.
constexpr bool is_word_character(char c) { return is_word_start(c) || is_digit(c); }

/// Compares keywords or parameter names, case-insensitively.
constexpr bool same_keyword(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (lower_case(a[i]) != lower_case(b[i])) return false;
  }
  return true;
}

std::string lower_case(std::string_view word);  ///< Returns the word with its ASCII letters in lower case.

/// Returns whether the word may name a definition: a letter, `_` or `$`, then letters, digits, `_`, `$`, and
/// not one of `begin end def none use true false`.
bool is_identifier(std::string_view word);

/// Returns whether the word is `rgb` or one of its two other spellings, `colour` and `color`.
bool is_colour_keyword(std::string_view word);

/// Returns whether the word may be the value of a parameter: an identifier other than `rgb colour color brdf
/// pdf texture`, with which the body of a definition begins (as it does with `begin`).
bool is_value_word(std::string_view word);

/// Encodes any text as an identifier: every character that an identifier cannot have is escaped as `$hex$`,
/// its code in hexadecimal, and so is `$` itself, so that the text can be decoded. An empty text gives `$$`;
/// a leading digit and a reserved word are escaped too.
std::string to_identifier(std::string_view text);

/// Decodes the text that `to_identifier` encoded.
std::string from_identifier(std::string_view identifier);

}  // namespace grf
