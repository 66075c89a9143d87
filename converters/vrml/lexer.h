#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "converters/vrml/source.h"

namespace convert::vrml {

enum class TokenKind { EndOfFile, Word, Number, String, Punctuation, Invalid };

/// A piece of the text. Views are into the source: nothing is allocated for a token.
struct Token {
  TokenKind kind = TokenKind::EndOfFile;
  std::string_view text;  ///< a string's without its quotes, and with its backslashes
  double number = 0;      ///< its magnitude is not over that of a float
  std::size_t offset = 0;
  std::string_view problem = {};  ///< of what is invalid

  bool is(char punctuation) const { return kind == TokenKind::Punctuation && text.front() == punctuation; }
  bool is_word(std::string_view word) const { return kind == TokenKind::Word && text == word; }
};

/// What a message says of a token: what is wrong with it, or that it was found.
std::string description(const Token& token);

/// A string without the backslashes that keep quotes and backslashes inside it.
std::string unescaped(std::string_view text);

/// Cuts VRML text into tokens, one token ahead. White space, commas and comments separate them. Words are
/// taken as widely as they can be told: exporters write names that have dots, apostrophes and the like.
class Lexer {
 public:
  explicit Lexer(const Source& source, std::size_t offset = 0);

  const Token& peek() const { return ahead_; }
  Token next();

 private:
  bool is_punctuation(char c) const;
  bool ends_word(char c) const;
  void skip_separators();
  Token scan();
  Token scan_string();
  Token scan_word();
  std::size_t offset() const { return static_cast<std::size_t>(position_ - begin_); }

  const char* begin_;
  const char* position_;
  const char* end_;
  bool has_bit_masks_;  // VRML 1.0 alone writes (A | B)
  Token ahead_;
};

}  // namespace convert::vrml
