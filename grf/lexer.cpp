#include "grf/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

#include "grf/keywords.h"
#include "grf/text_file.h"

namespace grf {
namespace {

// Typographic quotes occur in the printed examples of the thesis, where its word processor put them.
constexpr std::array<std::string_view, 2> TypographicQuotes = {"\xE2\x80\x9C", "\xE2\x80\x9D"};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

/// Returns whether a closing quote follows; word processors differ in which typographic quote closes.
bool closes_string(std::string_view text, std::string_view opening_quote) {
  if (opening_quote == "\"") return text.front() == '"';
  return text.starts_with(TypographicQuotes[0]) || text.starts_with(TypographicQuotes[1]);
}

}  // namespace

Lexer::Lexer(std::shared_ptr<const std::string> text, std::shared_ptr<const SourceFile> file)
    : text_(std::move(text)), file_(std::move(file)) {
  position_ = text_->data();
  end_ = position_ + text_->size();
  if (text_->starts_with(ByteOrderMark)) position_ += ByteOrderMark.size();
  line_begin_ = position_;
  ahead_ = scan();
}

Token Lexer::next() {
  const Token token = ahead_;
  line_of_last_ = token.line;
  ahead_ = scan();
  return token;
}

/// Scans this many tokens after the next one, and returns the last of them.
Token Lexer::scan_ahead(int count) {
  const char* position = position_;
  const char* line_begin = line_begin_;
  const std::uint32_t line = line_;
  const std::size_t comments = comments_.size();
  Token token;
  for (int i = 0; i < count; ++i) token = scan();
  position_ = position;
  line_begin_ = line_begin;
  line_ = line;
  comments_.resize(comments);
  return token;
}

// Calls `take_number` at each number of the list; it returns the end of the number, or null. Returns
// likewise.
template <class TakeNumber>
const char* Lexer::end_of_list(TakeNumber take_number) const {
  if (!ahead_.is('(')) return nullptr;
  const char* position = position_;
  const auto skip_blanks = [&] {
    while (position != end_ && *position == ' ') ++position;
    return position != end_;
  };
  do {
    if (!skip_blanks()) return nullptr;
    position = take_number(position);
    if (position == nullptr || !skip_blanks()) return nullptr;
  } while (*position++ == ',');
  return position[-1] == ')' ? position : nullptr;
}

void Lexer::go_on_at(const char* position) {
  position_ = position;
  line_of_last_ = line_;
  ahead_ = scan();
}

bool Lexer::take_numbers(std::span<float> numbers) {
  std::size_t count = 0;
  const char* end = end_of_list([&](const char* first) -> const char* {
    const char* digits = first + (*first == '-' ? 1 : 0);
    // from_chars also accepts `nan` and `inf`, which GRF does not.
    const bool is_number = digits != end_ && (is_digit(*digits) || *digits == '.');
    if (count == numbers.size() || !is_number) return nullptr;
    const auto [next, error] = std::from_chars(first, end_, numbers[count++]);
    return error == std::errc() ? next : nullptr;
  });
  if (end == nullptr || count != numbers.size()) return false;
  go_on_at(end);
  return true;
}

bool Lexer::take_indices(std::vector<std::uint32_t>& indices, std::size_t limit) {
  const std::size_t count_before = indices.size();
  const char* end = end_of_list([&](const char* first) -> const char* {
    const auto [next, error] = std::from_chars(first, end_, indices.emplace_back());
    return error == std::errc() && indices.back() < limit ? next : nullptr;
  });
  if (end == nullptr) {
    indices.resize(count_before);
    return false;
  }
  go_on_at(end);
  return true;
}

// Counts columns from the last token that was located, if it is earlier on the same line: a file can be one
// line of a million tokens, and counting each from the start of the line would be quadratic.
SourceLocation Lexer::location(const Token& token) {
  const auto is_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  const bool goes_on = last_located_.line_begin == token.line_begin && last_located_.begin <= token.begin;
  const char* counted = goes_on ? last_located_.begin : token.line_begin;
  const auto characters = static_cast<std::uint32_t>(std::count_if(counted, token.begin, is_character));
  last_column_ = characters + (goes_on ? last_column_ : 1);
  last_located_ = token;
  return {file_, token.line, last_column_};
}

void Lexer::skip_space_and_comments() {
  while (position_ != end_) {
    if (*position_ == '\n') {
      ++position_;
      ++line_;
      line_begin_ = position_;
    } else if (is_space(*position_)) {
      ++position_;
    } else if (*position_ == '/' && end_ - position_ > 1 && position_[1] == '/') {
      const char* line_end = std::find(position_, end_, '\n');
      std::string_view text(position_ + 2, static_cast<std::size_t>(line_end - position_ - 2));
      while (text.ends_with('\r')) text.remove_suffix(1);
      comments_.push_back({text, line_});
      position_ = line_end;
    } else {
      return;
    }
  }
}

Token Lexer::finish(TokenKind kind, const char* begin, std::string_view text) const {
  return {kind, text, line_, begin, line_begin_};
}

Token Lexer::scan() {
  // The end of the file is located right after the last token, where something is missing.
  const Token end_of_file = finish(TokenKind::EndOfFile, position_, {});
  skip_space_and_comments();
  const char* begin = position_;
  if (position_ == end_) return end_of_file;
  const char c = *position_;
  if (is_word_start(c)) {
    position_ = std::find_if_not(position_, end_, is_word_character);
    return finish(TokenKind::Word, begin, {begin, static_cast<std::size_t>(position_ - begin)});
  }
  if (is_digit(c) || c == '-' || c == '+' || c == '.') return scan_number();
  if (c == '(' || c == ')' || c == ',' || c == '=' || c == '*') {
    ++position_;
    return finish(TokenKind::Punctuation, begin, {begin, 1});
  }
  if (c == '"') return scan_string("\"");
  const std::string_view rest(position_, static_cast<std::size_t>(end_ - position_));
  for (const std::string_view quote : TypographicQuotes) {
    if (rest.starts_with(quote)) return scan_string(quote);
  }
  // An invalid token is a whole UTF-8 character, so that a message can show it.
  do ++position_;
  while (position_ != end_ && (static_cast<unsigned char>(*position_) & 0xC0U) == 0x80U);
  return finish(TokenKind::Invalid, begin, {begin, static_cast<std::size_t>(position_ - begin)});
}

Token Lexer::scan_number() {
  const char* begin = position_;
  const auto skip_digits = [this] {
    const char* first = position_;
    while (position_ != end_ && is_digit(*position_)) ++position_;
    return position_ - first;
  };
  const auto at = [this](std::string_view characters) {
    return position_ != end_ && characters.find(*position_) != std::string_view::npos;
  };
  if (at("+-")) ++position_;
  auto digits = skip_digits();
  if (at(".")) {
    ++position_;
    digits += skip_digits();
  }
  bool valid = digits > 0;
  if (valid && at("eE")) {
    ++position_;
    if (at("+-")) ++position_;
    valid = skip_digits() > 0;
  }
  const char* number_end = position_;
  if (valid && at("fFdD")) ++position_;
  if (position_ != end_ && is_word_character(*position_)) {
    position_ = std::find_if_not(position_, end_, is_word_character);
    valid = false;
  }
  if (!valid) number_end = position_;
  return finish(valid ? TokenKind::Number : TokenKind::Invalid, begin,
                {begin, static_cast<std::size_t>(number_end - begin)});
}

Token Lexer::scan_string(std::string_view quote) {
  const char* begin = position_;
  position_ += quote.size();
  const char* text_begin = position_;
  while (position_ != end_ && *position_ != '\n') {
    const std::string_view rest(position_, static_cast<std::size_t>(end_ - position_));
    if (closes_string(rest, quote)) {
      const std::string_view text(text_begin, static_cast<std::size_t>(position_ - text_begin));
      position_ += quote.size();
      return finish(TokenKind::String, begin, text);
    }
    ++position_;
  }
  return finish(TokenKind::Invalid, begin, {begin, static_cast<std::size_t>(position_ - begin)});
}

}  // namespace grf
