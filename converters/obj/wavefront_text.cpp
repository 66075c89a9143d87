#include "converters/obj/wavefront_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "converters/text_encoding.h"
#include "grf/text_file.h"

namespace convert {
namespace {

/// Character classes, as flags of a lookup table, since texts are long.
enum CharacterKind : std::uint8_t {
  LineEnd = 1,
  Space = 2,  // also line ends: those inside a statement follow a backslash
  Backslash = 4,
};

constexpr std::array<std::uint8_t, 256> character_kinds() {
  std::array<std::uint8_t, 256> kinds = {};
  for (const char c : {'\n', '\r'}) kinds[static_cast<std::uint8_t>(c)] = LineEnd | Space;
  for (const char c : {' ', '\t', '\f', '\v'}) kinds[static_cast<std::uint8_t>(c)] = Space;
  kinds[static_cast<std::uint8_t>('\\')] = Backslash;
  return kinds;
}
constexpr std::array<std::uint8_t, 256> CharacterKinds = character_kinds();

bool is_any(char c, unsigned kinds) { return (CharacterKinds[static_cast<std::uint8_t>(c)] & kinds) != 0; }
bool is_line_end(char c) { return is_any(c, LineEnd); }
bool is_space(char c) { return is_any(c, Space); }

/// Returns whether there is a backslash that joins the next line to this one.
bool joins_lines(const char* position, const char* end) {
  return *position == '\\' && position + 1 != end && is_line_end(position[1]);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// Takes the next word at the front of the text; empty at its end.
std::string_view take_word(std::string_view& text) {
  const char* position = text.data();
  const char* end = position + text.size();
  while (position != end && (is_space(*position) || joins_lines(position, end))) ++position;
  const char* begin = position;
  while (position != end &&
         (!is_any(*position, Space | Backslash) || (*position == '\\' && !joins_lines(position, end)))) {
    ++position;
  }
  text.remove_prefix(static_cast<std::size_t>(position - text.data()));
  return {begin, static_cast<std::size_t>(position - begin)};
}

// Numbers may have a plus sign, which from_chars does not accept.
std::string_view without_plus(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  return word;
}

}  // namespace

std::string Statement::text() const {
  const bool is_one_line = std::none_of(rest.begin(), rest.end(), is_line_end);
  return is_one_line ? std::string(rest) : fmt::format("{}", fmt::join(arguments, " "));
}

StatementReader::StatementReader(std::shared_ptr<const std::string> text,
                                 std::shared_ptr<const grf::SourceFile> file, LineComments comments)
    : text_(std::move(text)),
      file_(std::move(file)),
      comments_(comments),
      position_(text_->data()),
      end_(text_->data() + text_->size()),
      line_begin_(position_) {}

bool StatementReader::next(Statement& statement) {
  while (position_ != end_) {
    // The line count is that of the start of the last statement.
    line_ += static_cast<std::uint32_t>(std::count(line_begin_, position_, '\n'));
    line_begin_ = position_;
    std::string_view line = next_line();
    statement.keyword = take_word(line);
    if (statement.keyword.empty()) continue;
    statement.arguments.clear();
    if (statement.keyword.front() == '#') {
      if (comments_ == LineComments::Skipped) continue;
      const char* begin = statement.keyword.data() + 1;
      statement.rest = trimmed({begin, static_cast<std::size_t>(line.data() + line.size() - begin)});
      statement.keyword = statement.keyword.substr(0, 1);
      return true;
    }
    statement.rest = trimmed(line);
    for (auto word = take_word(line); !word.empty() && word.front() != '#'; word = take_word(line)) {
      statement.arguments.push_back(word);
    }
    statement.has_line_end = position_ != end_ || !ends_inside_line();
    return true;
  }
  return false;
}

// Takes the text up to the next line end that is not escaped by a backslash, and skips that line end.
std::string_view StatementReader::next_line() {
  const char* begin = position_;
  while (position_ != end_ && !is_line_end(*position_)) {
    if (*position_ != '\\') {
      ++position_;
      continue;
    }
    const bool joins = joins_lines(position_, end_);
    const bool two_characters = joins && end_ - position_ > 2 && position_[1] == '\r' && position_[2] == '\n';
    position_ += joins ? (two_characters ? 3 : 2) : 1;
  }
  const std::string_view line(begin, static_cast<std::size_t>(position_ - begin));
  if (position_ != end_) ++position_;
  return line;
}

grf::SourceLocation StatementReader::location(std::string_view part) const {
  const auto line = line_ + static_cast<std::uint32_t>(std::count(line_begin_, part.data(), '\n'));
  const std::string_view before(line_begin_, static_cast<std::size_t>(part.data() - line_begin_));
  const std::size_t last_line_end = before.rfind('\n');
  const char* begin = line_begin_ + (last_line_end == std::string_view::npos ? 0 : last_line_end + 1);
  const auto is_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return {file_, line, 1 + static_cast<std::uint32_t>(std::count_if(begin, part.data(), is_character))};
}

bool StatementReader::ends_inside_line() const { return !text_->empty() && !is_line_end(text_->back()); }

std::optional<float> parse_float(std::string_view word) {
  const std::string_view digits = without_plus(word);
  float number = 0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, number);
  if (result.ec == std::errc() && result.ptr == end && std::isfinite(number)) return number;
  // Underflow is valid, although it is reported as out of range.
  const std::optional<double> wide = parse_number(word);
  return wide ? std::optional(static_cast<float>(*wide)) : std::nullopt;
}

std::optional<double> parse_number(std::string_view word) {
  word = without_plus(word);
  double number = 0;
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, number);
  const bool is_whole = result.ec == std::errc() && result.ptr == end;
  return is_whole && std::abs(number) <= std::numeric_limits<float>::max() ? std::optional(number)
                                                                           : std::nullopt;
}

std::optional<SourceText> read_source_text(const std::string& path, std::string_view expected,
                                           grf::Diagnostics& diagnostics,
                                           const grf::SourceLocation& asked_for_at) {
  const auto bytes = grf::read_file(path, diagnostics, asked_for_at);
  if (!bytes) return std::nullopt;
  SourceText source;
  source.text = is_plain_utf8(*bytes) ? bytes : std::make_shared<const std::string>(to_utf8(*bytes));
  source.file = std::make_shared<grf::SourceFile>(grf::SourceFile{path, asked_for_at, source.text});
  const grf::SourceLocation location{source.file, 0, 0};
  if (source.text->empty()) {
    diagnostics.error(location, fmt::format("the file is empty, expected {}", expected));
  } else if (source.text->find('\0') != std::string::npos) {
    diagnostics.error(location, fmt::format("this is a binary file, expected {}, which is text", expected));
  } else {
    return source;
  }
  return std::nullopt;
}

}  // namespace convert
