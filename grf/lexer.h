#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grf/source_location.h"

namespace grf {

/// The kind of a token; a character that begins none is Invalid.
enum class TokenKind { EndOfFile, Word, Number, String, Punctuation, Invalid };

/// A token. Views and positions are into the lexer's text: nothing is allocated per token.
struct Token {
  TokenKind kind = TokenKind::EndOfFile;
  std::string_view text;        ///< without the quotes of a string
  std::uint32_t line = 1;       ///< from 1
  const char* begin = nullptr;  ///< the first character in the text, including a quote
  const char* line_begin = nullptr;

  /// Returns whether this is that character of punctuation.
  bool is(char punctuation) const { return kind == TokenKind::Punctuation && text.front() == punctuation; }
};

/// A comment, which the parser attaches to what it precedes or trails.
struct CommentToken {
  std::string_view text;  ///< without `//`
  std::uint32_t line = 1;
};

/// Tokenizes GRF text with one token of lookahead (`grf-format`, section 1: words).
class Lexer {
 public:
  /// Starts at the beginning of the text, which the lexer keeps alive; a byte-order mark is skipped.
  Lexer(std::shared_ptr<const std::string> text, std::shared_ptr<const SourceFile> file);

  const Token& peek() const { return ahead_; }  ///< Returns the next token; `next` also steps over it.
  Token next();
  /// Returns the second token of lookahead, the third or the fourth. Costs a second scan: not for lists of
  /// numbers.
  Token peek_second() { return scan_ahead(1); }
  Token peek_third() { return scan_ahead(2); }
  Token peek_fourth() { return scan_ahead(3); }

  /// Reads `(a, b, c)` at once if the next token begins it, on one line, and it has no special case (a
  /// comment, a suffix, a number out of range). This is a fast path: most of a large scene is such lists, and
  /// to tokenize them takes several times as long. Returns false if nothing was read: the tokens then tell
  /// what there is.
  bool take_numbers(std::span<float> numbers);
  /// Reads a list of any number of integers below a limit likewise, and appends them.
  bool take_indices(std::vector<std::uint32_t>& indices, std::size_t limit);

  /// Returns the comments before the next token that were not taken or dropped yet.
  std::vector<CommentToken>& comments() { return comments_; }
  std::uint32_t line_of_last() const { return line_of_last_; }

  /// Returns the size of the text from the next token on.
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - ahead_.begin); }

  SourceLocation location(const Token& token);  ///< Returns where a token is in its file.

 private:
  void skip_space_and_comments();
  Token scan();
  Token scan_ahead(int count);
  Token scan_number();
  Token scan_string(std::string_view quote);
  template <class TakeNumber>
  const char* end_of_list(TakeNumber take_number) const;
  void go_on_at(const char* position);
  Token finish(TokenKind kind, const char* begin, std::string_view text) const;

  std::shared_ptr<const std::string> text_;
  std::shared_ptr<const SourceFile> file_;
  const char* position_;
  const char* end_;
  const char* line_begin_;
  std::uint32_t line_ = 1;
  std::uint32_t line_of_last_ = 1;
  std::vector<CommentToken> comments_;
  Token ahead_;
  Token last_located_;
  std::uint32_t last_column_ = 1;
};

}  // namespace grf
