#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"

namespace grf {
namespace {

/// Returns the beginning of a text, cut between characters.
std::string shortened(std::string_view text) {
  constexpr std::size_t Longest = 40;
  if (text.size() <= Longest) return std::string(text);
  std::size_t length = Longest;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
  return std::string(text.substr(0, length)) + "...";
}

std::string description_of_invalid(std::string_view text) {
  const bool is_ascii = (static_cast<unsigned char>(text.front()) & 0x80U) == 0;
  if (text.size() == 1 && (!is_ascii || text.front() < ' ')) {
    return fmt::format("the byte 0x{:02x}{}", static_cast<unsigned char>(text.front()),
                       is_ascii ? "" : ", which is not UTF-8");
  }
  const bool opens_string = text.starts_with('"') || text.starts_with("\u201C") || text.starts_with("\u201D");
  if (opens_string) return "a string without its closing quote";
  return fmt::format("'{}'", shortened(text));
}

/// Describes a token for messages.
std::string description(const Token& token) {
  switch (token.kind) {
    case TokenKind::EndOfFile:
      return "the end of the file";
    case TokenKind::String:
      return fmt::format("the string \"{}\"", shortened(token.text));
    case TokenKind::Number:
      return fmt::format("the number {}", shortened(token.text));
    case TokenKind::Word:
    case TokenKind::Punctuation:
      return fmt::format("'{}'", shortened(token.text));
    case TokenKind::Invalid:
      break;
  }
  return description_of_invalid(token.text);
}

/// Returns whether a number out of a float's range underflows: whether its first digit other than 0 is after
/// the decimal point, once the exponent has moved that.
bool is_tiny(std::string_view number) {
  const std::size_t exponent_mark = number.find_first_of("eE");
  const std::string_view digits = number.substr(0, exponent_mark);
  std::int32_t exponent = 0;
  if (exponent_mark != std::string_view::npos) {
    const char* first = number.data() + exponent_mark + 1;
    if (*first == '+') ++first;
    const auto error = std::from_chars(first, number.data() + number.size(), exponent).ec;
    if (error == std::errc::result_out_of_range) return *first == '-';
  }
  const auto first_digit = static_cast<std::int64_t>(digits.find_first_of("123456789"));
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  return point - first_digit + exponent < 0;
}

}  // namespace

bool Parser::at(std::string_view keyword) const {
  return lexer_.peek().kind == TokenKind::Word && same_keyword(lexer_.peek().text, keyword);
}

bool Parser::at(std::string_view first, std::string_view second) {
  if (!at(first)) return false;
  const Token next = lexer_.peek_second();
  return next.kind == TokenKind::Word && same_keyword(next.text, second);
}

bool Parser::at_identifier() const {
  return lexer_.peek().kind == TokenKind::Word && is_identifier(lexer_.peek().text);
}

bool Parser::at_colour() const {
  return lexer_.peek().kind == TokenKind::Word && is_colour_keyword(lexer_.peek().text);
}

bool Parser::accept_colour() {
  if (!at_colour()) return false;
  lexer_.next();
  return true;
}

// Takes a token and counts open blocks, for error recovery.
Token Parser::take() {
  if (at("begin")) ++open_;
  if (at("end") && open_ > 0) --open_;
  return lexer_.next();
}

bool Parser::accept(std::string_view keyword) {
  if (!at(keyword)) return false;
  take();
  return true;
}

bool Parser::accept(char punctuation) {
  if (!lexer_.peek().is(punctuation)) return false;
  lexer_.next();
  return true;
}

bool Parser::expect(std::string_view keyword, std::string_view where) {
  return accept(keyword) || fail_expected(fmt::format("'{}' {}", keyword, where));
}

bool Parser::expect(char punctuation, std::string_view where) {
  return accept(punctuation) || fail_expected(fmt::format("'{}' {}", punctuation, where));
}

void Parser::error(const Token& token, std::string_view message) {
  context_.diagnostics.error(lexer_.location(token), message);
}

bool Parser::fail(const Token& token, std::string_view message) {
  error(token, message);
  return false;
}

bool Parser::fail_expected(std::string_view expected) {
  return fail(lexer_.peek(), fmt::format("found {}, expected {}", description(lexer_.peek()), expected));
}

bool Parser::fail_unclosed(const Token& opening, std::string_view end) {
  // After an error an unclosed block is most likely its consequence, and so is one around an unclosed block
  // that was reported.
  if (context_.has_errors()) return false;
  return fail(opening, fmt::format("'{}' without '{}' before the end of the file", opening.text, end));
}

bool Parser::parse_number(float& number) {
  const Token& token = lexer_.peek();
  if (token.kind != TokenKind::Number) return fail_expected("a number");
  const char* first = token.text.data();
  const char* last = first + token.text.size();
  if (*first == '+') ++first;
  // The conversion reports underflow as out of range too: such numbers are zero.
  if (std::from_chars(first, last, number).ec == std::errc::result_out_of_range) {
    if (!is_tiny(token.text)) {
      error(token, fmt::format("{} is out of range: numbers reach from -3.4028235e38 to 3.4028235e38",
                               description(token)));
    }
    number = *first == '-' ? -0.0F : 0.0F;
  }
  lexer_.next();
  return true;
}

bool Parser::parse_vector(Vec3f& vector) {
  if (lexer_.take_numbers(std::span(vector.getValue(), 3))) return true;
  return expect('(', "and three numbers") && parse_number(vector.x) && expect(',', "and two more numbers") &&
         parse_number(vector.y) && expect(',', "and one more number") && parse_number(vector.z) &&
         expect(')', "after three numbers");
}

bool Parser::parse_vector(Vec2f& vector) {
  if (lexer_.take_numbers(std::span(vector.getValue(), 2))) return true;
  return expect('(', "before two numbers") && parse_number(vector.x) &&
         expect(',', "between the two numbers") && parse_number(vector.y) && expect(')', "after two numbers");
}

bool Parser::parse_string(std::string& string, std::string_view what) {
  if (lexer_.peek().kind != TokenKind::String) return fail_expected(what);
  string = lexer_.next().text;
  return true;
}

bool Parser::parse_index(std::uint32_t& index, std::string_view what) {
  const Token& token = lexer_.peek();
  if (token.kind != TokenKind::Number) return fail_expected(what);
  const char* first = token.text.data();
  const char* last = first + token.text.size();
  const auto [end, error] = std::from_chars(first, last, index);
  if (error == std::errc::result_out_of_range) index = std::numeric_limits<std::uint32_t>::max();
  if (error == std::errc::invalid_argument || end != last) {
    return fail(token, fmt::format("{} is not {}, expected a whole number from 0", token.text, what));
  }
  lexer_.next();
  return true;
}

std::vector<std::string> Parser::take_comments() {
  std::vector<std::string> comments;
  for (const CommentToken& comment : lexer_.comments()) comments.emplace_back(comment.text);
  lexer_.comments().clear();
  return comments;
}

// Takes the comments of the block or attribute just parsed, up to that line: those inside it that no part of
// it took, and the trailing one.
void Parser::take_comments_of(Comments& comments, std::uint32_t last_line) {
  if (!comments.behind.empty()) comments.before.push_back(std::exchange(comments.behind, {}));
  std::vector<CommentToken>& pending = lexer_.comments();
  auto comment = pending.begin();
  for (; comment != pending.end() && comment->line < last_line; ++comment) {
    comments.before.emplace_back(comment->text);
  }
  if (comment != pending.end() && comment->line == last_line) {
    comments.behind = comment->text;
    ++comment;
  }
  pending.erase(pending.begin(), comment);
}

void Parser::drop_comments() {
  dropped_comments_ += lexer_.comments().size();
  lexer_.comments().clear();
}

}  // namespace grf
