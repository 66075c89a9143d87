#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"

namespace grf {
namespace {

/// What stands at a token, for messages.
std::string description(const Token& token) {
  constexpr std::size_t Longest = 40;
  std::string text(token.text.substr(0, Longest));
  if (token.text.size() > Longest) text += "...";
  switch (token.kind) {
    case TokenKind::EndOfFile:
      return "the end of the file";
    case TokenKind::String:
      return fmt::format("the string \"{}\"", text);
    case TokenKind::Number:
      return fmt::format("the number {}", text);
    case TokenKind::Word:
    case TokenKind::Punctuation:
      return fmt::format("'{}'", text);
    case TokenKind::Invalid:
      break;
  }
  if (token.text.size() == 1 && (token.text.front() < ' ' || token.text.front() > '~')) {
    return fmt::format("the byte 0x{:02x}", static_cast<unsigned char>(token.text.front()));
  }
  if (token.text.starts_with('"')) return "a string without its closing quote";
  return fmt::format("'{}', which is no word, number or string of GRF,", text);
}

}  // namespace

bool is_colour_keyword(std::string_view word) {
  return same_keyword(word, "rgb") || same_keyword(word, "colour") || same_keyword(word, "color");
}

bool Parser::at(std::string_view keyword) const {
  return lexer_.peek().kind == TokenKind::Word && same_keyword(lexer_.peek().text, keyword);
}

bool Parser::accept(std::string_view keyword) {
  if (!at(keyword)) return false;
  lexer_.next();
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

bool Parser::fail(const Token& token, std::string message) {
  context_.diagnostics.error(lexer_.location(token), std::move(message));
  return false;
}

bool Parser::fail_expected(std::string_view expected) {
  return fail(lexer_.peek(),
              fmt::format("found {} where {} was expected", description(lexer_.peek()), expected));
}

bool Parser::fail_unclosed(const Token& opening, std::string_view end) {
  return fail(opening, fmt::format("'{}' is never closed: expected '{}' before the end of the file",
                                   opening.text, end));
}

bool Parser::parse_number(float& number) {
  const Token& token = lexer_.peek();
  if (token.kind != TokenKind::Number) return fail_expected("a number");
  const char* first = token.text.data();
  const char* last = first + token.text.size();
  if (*first == '+') ++first;
  if (std::from_chars(first, last, number).ec == std::errc::result_out_of_range) {
    // Out of range is also said of numbers too near to zero: those are zero. What is left is an overflow.
    double exact = 0;
    const bool small = std::from_chars(first, last, exact).ec == std::errc() &&
                       std::abs(exact) <= std::numeric_limits<float>::min();
    const bool has_small_exponent =
        token.text.find("e-") != std::string_view::npos || token.text.find("E-") != std::string_view::npos;
    if (!small && !(exact == 0 && has_small_exponent)) {
      return fail(token, fmt::format("{} is out of range: numbers reach from -3.4028235e38 to 3.4028235e38",
                                     description(token)));
    }
    number = static_cast<float>(exact);
  }
  lexer_.next();
  return true;
}

bool Parser::parse_vector(Vec3f& vector) {
  return expect('(', "before three numbers") && parse_number(vector.x) &&
         expect(',', "between the numbers of a triple") && parse_number(vector.y) &&
         expect(',', "between the numbers of a triple") && parse_number(vector.z) &&
         expect(')', "after three numbers");
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
    return fail(token, fmt::format("{} is not {}: a whole number from 0 was expected", token.text, what));
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

std::string Parser::take_comment_behind(std::uint32_t line) {
  std::vector<CommentToken>& comments = lexer_.comments();
  if (comments.empty() || comments.front().line != line) return {};
  std::string text(comments.front().text);
  comments.erase(comments.begin());
  return text;
}

void Parser::drop_comments() {
  dropped_comments_ += lexer_.comments().size();
  lexer_.comments().clear();
}

}  // namespace grf
