#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "converters/vrml/source.h"

namespace convert::vrml {

enum class TokenKind { EndOfFile, Word, Number, String, Punctuation, Invalid };

/// A token. Views are into the source: nothing is allocated per token.
struct Token {
  TokenKind kind = TokenKind::EndOfFile;
  std::string_view text;  ///< without the quotes of a string, but with its backslashes
  double number = 0;      ///< within the range of a float
  std::size_t offset = 0;
  std::string_view problem = {};  ///< of an invalid token

  bool is(char punctuation) const { return kind == TokenKind::Punctuation && text.front() == punctuation; }
  bool is_word(std::string_view word) const { return kind == TokenKind::Word && text == word; }
};

/// Describes a token for messages: its problem, or that it was found.
std::string description(const Token& token);

/// Removes the escapes (backslashes) of a string.
std::string unescaped(std::string_view text);

/// Tokenizes VRML text with one token of lookahead. White space, commas and comments separate tokens. Words
/// may have any unambiguous characters: exporters write names with dots, apostrophes and the like.
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
  bool has_bit_masks_;  // only VRML 1.0 has (A | B)
  Token ahead_;
};

}  // namespace convert::vrml
