#include "converters/vrml/lexer.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <system_error>

#include <fmt/format.h>

#include "grf/keywords.h"

namespace convert::vrml {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }
// Control characters and commas separate tokens like white space.
bool is_separator(char c) { return static_cast<unsigned char>(c) <= ' ' || c == ',' || c == '\x7F'; }

bool begins_number(std::string_view word) {
  if (word.front() == '+' || word.front() == '-') word.remove_prefix(1);
  if (word.starts_with('.')) word.remove_prefix(1);
  return !word.empty() && grf::is_digit(word.front());
}

/// Parses the 32-bit integer after `0x` (ISO/IEC 14772-1, 5.5: SFInt32).
bool parse_hexadecimal(std::string_view digits, double& number) {
  std::uint32_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value, 16);
  number = static_cast<double>(static_cast<std::int32_t>(value));
  return result.ec == std::errc() && result.ptr == end;
}

/// Parses a word as a number; returns an error message, or an empty string.
std::string_view parse_number(std::string_view word, double& number) {
  constexpr std::string_view NoNumber = "is not a number";
  constexpr std::string_view TooLarge = "is too large for a float";
  if (word.starts_with("0x") || word.starts_with("0X")) {
    return parse_hexadecimal(word.substr(2), number) ? "" : NoNumber;
  }
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, number);
  if (result.ptr != end) return NoNumber;
  if (result.ec == std::errc::result_out_of_range) {
    if (word.find("e-") == std::string_view::npos && word.find("E-") == std::string_view::npos)
      return TooLarge;
    number = 0;
    return {};
  }
  if (result.ec != std::errc()) return NoNumber;
  return std::abs(number) <= std::numeric_limits<float>::max() ? "" : TooLarge;
}

}  // namespace

std::string description(const Token& token) {
  switch (token.kind) {
    case TokenKind::EndOfFile:
      return "the file ends here";
    case TokenKind::Invalid:
      return fmt::format("'{}' {}", token.text, token.problem);
    case TokenKind::String:
      return fmt::format("found \"{}\"", token.text);
    case TokenKind::Word:
    case TokenKind::Number:
    case TokenKind::Punctuation:
      break;
  }
  return fmt::format("found '{}'", token.text);
}

std::string unescaped(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\')) ++i;
    plain += text[i];
  }
  return plain;
}

Lexer::Lexer(const Source& source, std::size_t offset)
    : begin_(source.text().data()),
      position_(begin_ + offset),
      end_(begin_ + source.text().size()),
      has_bit_masks_(source.version() == Version::Vrml1),
      ahead_(scan()) {}

Token Lexer::next() {
  const Token token = ahead_;
  ahead_ = scan();
  return token;
}

bool Lexer::is_punctuation(char c) const {
  if (c == '{' || c == '}' || c == '[' || c == ']') return true;
  return has_bit_masks_ && (c == '(' || c == ')' || c == '|');
}

bool Lexer::ends_word(char c) const { return is_separator(c) || is_punctuation(c) || c == '"' || c == '#'; }

void Lexer::skip_separators() {
  while (position_ != end_) {
    if (*position_ == '#') {
      while (position_ != end_ && !is_line_end(*position_)) ++position_;
    } else if (is_separator(*position_)) {
      ++position_;
    } else {
      return;
    }
  }
}

Token Lexer::scan() {
  skip_separators();
  if (position_ == end_) return {TokenKind::EndOfFile, {}, 0, offset()};
  if (*position_ == '"') return scan_string();
  if (!is_punctuation(*position_)) return scan_word();
  const Token token{TokenKind::Punctuation, {position_, 1}, 0, offset()};
  ++position_;
  return token;
}

Token Lexer::scan_string() {
  const std::size_t begin = offset();
  const char* first = ++position_;
  while (position_ != end_ && *position_ != '"')
    position_ += *position_ == '\\' && position_ + 1 != end_ ? 2 : 1;
  const std::string_view text(first, static_cast<std::size_t>(position_ - first));
  if (position_ == end_) return {TokenKind::Invalid, "\"", 0, begin, "begins a string that has no end"};
  ++position_;
  return {TokenKind::String, text, 0, begin};
}

Token Lexer::scan_word() {
  Token token{TokenKind::Word, {}, 0, offset()};
  const char* first = position_;
  while (position_ != end_ && !ends_word(*position_)) ++position_;
  token.text = {first, static_cast<std::size_t>(position_ - first)};
  if (!begins_number(token.text)) return token;
  // Some libraries print NaN and infinity as `-1.#IND` and `1.#INF`: no comment begins there.
  const std::string_view rest(position_, static_cast<std::size_t>(end_ - position_));
  const bool is_not_finite =
      token.text.ends_with('.') &&
      (rest.starts_with("#IN") || rest.starts_with("#QNAN") || rest.starts_with("#SNAN"));
  token.problem = is_not_finite ? "is not a finite number" : parse_number(token.text, token.number);
  token.kind = token.problem.empty() ? TokenKind::Number : TokenKind::Invalid;
  return token;
}

}  // namespace convert::vrml
