#include "grf/diagnostics.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/text_file.h"

namespace grf {
namespace {

// A longer line is cut to the part around the column: a file can be one line of 100 MB.
constexpr std::size_t LongestExcerpt = 160;  // in characters
constexpr std::size_t ShownBeforeColumn = 100;
constexpr std::size_t LongestMessage = 2000;  // in bytes: messages repeat names, and a name can be that line
constexpr std::string_view Cut = "...";

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "";
}

std::string_view line_of(std::string_view text, std::uint32_t line) {
  for (std::uint32_t i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (line == 1 && text.starts_with(ByteOrderMark)) text.remove_prefix(ByteOrderMark.size());
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Returns the white space before a caret, with the tabs of the line so that both are indented alike.
std::string indentation_up_to(std::string_view line, std::uint32_t column) {
  std::string indentation;
  for (const char c : line) {
    if (is_continuation_byte(c)) continue;
    if (indentation.size() + 1 >= column) break;
    indentation += c == '\t' ? '\t' : ' ';
  }
  return indentation;
}

/// Returns the length in bytes of the UTF-8 character at the beginning of a text, or 0 if there is none.
std::size_t length_of_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0x80U ? 1 : lead < 0xC2U ? 0 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : 4;
  if (length == 0 || length > text.size() || lead > 0xF4U) return 0;
  const std::string_view others = text.substr(1, length - 1);
  return std::all_of(others.begin(), others.end(), is_continuation_byte) ? length : 0;
}

/// Replaces control characters and invalid UTF-8, which a terminal would not show or would interpret.
std::string printable(std::string_view text) {
  constexpr std::string_view Replacement = "\uFFFD";
  std::string printable;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    const auto lead = static_cast<unsigned char>(text.front());
    const bool is_shown = (lead >= ' ' && lead != 0x7F) || lead == '\t' || lead == '\n';
    printable += length > 0 && is_shown ? text.substr(0, length) : Replacement;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return printable;
}

std::string message_of(std::string_view text) {
  if (text.size() <= LongestMessage) return printable(text);
  std::size_t length = LongestMessage;
  while (is_continuation_byte(text[length])) --length;
  return printable(text.substr(0, length)).append(Cut);
}

/// Returns the byte offset of the character with that index, or the size if there are fewer characters.
std::size_t offset_of_character(std::string_view text, std::size_t number) {
  std::size_t offset = 0;
  for (; offset < text.size(); ++offset) {
    if (!is_continuation_byte(text[offset]) && number-- == 0) break;
  }
  return offset;
}

void set_excerpt(Diagnostic& diagnostic) {
  const std::string line = printable(source_line(diagnostic.location));
  diagnostic.excerpt_column = diagnostic.location.column;
  const std::size_t column = diagnostic.location.column;
  const std::size_t first = column > ShownBeforeColumn ? column - ShownBeforeColumn : 0;
  const std::size_t line_end = offset_of_character(line, LongestExcerpt);
  if (line_end == line.size()) {
    diagnostic.excerpt = line;
    return;
  }
  std::string_view shown = line;
  shown.remove_prefix(offset_of_character(line, first));
  const std::string_view rest = shown.substr(0, offset_of_character(shown, LongestExcerpt));
  if (first > 0) {
    diagnostic.excerpt = Cut;
    diagnostic.excerpt_column = static_cast<std::uint32_t>(column - first + Cut.size());
  }
  diagnostic.excerpt += rest;
  if (rest.size() < shown.size()) diagnostic.excerpt += Cut;
}

bool says_the_same(const Diagnostic& a, const Diagnostic& b) {
  const auto path = [](const Diagnostic& d) {
    return d.location.file ? d.location.file->path : std::string();
  };
  return a.severity == b.severity && a.location.line == b.location.line &&
         a.location.column == b.location.column && a.message == b.message && path(a) == path(b);
}

/// Computes the Damerau-Levenshtein distance, case-insensitive, row by row.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = lower_case(a[i - 1]) == lower_case(b[j - 1]) ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + substitution});
      const bool swapped = i > 1 && j > 1 && lower_case(a[i - 1]) == lower_case(b[j - 2]) &&
                           lower_case(a[i - 2]) == lower_case(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

SourceLocation whole_file(std::string path) {
  return {std::make_shared<SourceFile>(SourceFile{std::move(path), {}, {}}), 0, 0};
}

std::string source_line(const SourceLocation& location) {
  if (!location.file || location.line == 0) return {};
  if (const auto text = location.file->text.lock()) return std::string(line_of(*text, location.line));
  Diagnostics ignored_diagnostics;  // if the file cannot be read any more there is no excerpt to show
  const auto text = read_file(location.file->path, ignored_diagnostics);
  return text ? std::string(line_of(*text, location.line)) : std::string();
}

void Diagnostics::error(SourceLocation location, std::string_view message) {
  add(Severity::Error, std::move(location), message);
}

void Diagnostics::warning(SourceLocation location, std::string_view message) {
  add(Severity::Warning, std::move(location), message);
}

void Diagnostics::loss(SourceLocation location, std::string_view message) {
  losses_.emplace_back(message);
  add(Severity::Warning, std::move(location), message);
}

void Diagnostics::note(SourceLocation location, std::string_view message) {
  add(Severity::Note, std::move(location), message);
}

void Diagnostics::add(Severity severity, SourceLocation location, std::string_view message) {
  if (severity == Severity::Error) ++error_count_;
  if (severity == Severity::Warning) ++warning_count_;
  const bool is_kept = severity == Severity::Note ||
                       (severity == Severity::Error ? !is_full() : kept_warnings_ < MaximumWarnings);
  if (!is_kept) return;
  Diagnostic entry{severity, std::move(location), message_of(message), {}, 0};
  const bool is_known = severity != Severity::Note &&
                        std::any_of(entries_.begin(), entries_.end(),
                                    [&](const Diagnostic& known) { return says_the_same(known, entry); });
  if (is_known) return;
  if (severity == Severity::Error) ++kept_errors_;
  if (severity == Severity::Warning) ++kept_warnings_;
  if (takes_excerpts_) set_excerpt(entry);
  entries_.push_back(std::move(entry));
}

std::string to_text(const Diagnostic& diagnostic) {
  const SourceLocation& location = diagnostic.location;
  std::string text;
  if (location.file) text += location.file->path + ":";
  if (location.file && location.line > 0) text += fmt::format("{}:{}:", location.line, location.column);
  if (!text.empty()) text += ' ';
  text += fmt::format("{}: {}\n", name_of(diagnostic.severity), diagnostic.message);
  if (!diagnostic.excerpt.empty()) {
    text += fmt::format("  {}\n  {}^\n", diagnostic.excerpt,
                        indentation_up_to(diagnostic.excerpt, diagnostic.excerpt_column));
  }
  const SourceFile* file = location.file.get();
  while (file != nullptr && file->included_at.file) {
    const SourceLocation& include = file->included_at;
    text += fmt::format("  included from {}:{}:{}\n", include.file->path, include.line, include.column);
    file = include.file.get();
  }
  return text;
}

std::string Diagnostics::to_text() const {
  std::string text;
  for (const Diagnostic& entry : entries_) text += grf::to_text(entry);
  if (is_full()) text += fmt::format("only the first {} errors are shown\n", MaximumErrors);
  if (kept_warnings_ == MaximumWarnings) {
    text += fmt::format("only the first {} warnings are shown\n", MaximumWarnings);
  }
  return text;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t MostSuggestions = 3;
  // A longer word is not a misspelling, and each comparison costs the product of the two lengths.
  constexpr std::size_t LongestWord = 64;
  constexpr std::size_t MostCandidates = 10'000;
  const std::size_t farthest = 1 + word.size() / 3;
  std::vector<std::pair<std::size_t, std::string>> near;
  if (word.size() > LongestWord || candidates.size() > MostCandidates) return {};
  for (const std::string& candidate : candidates) {
    if (candidate.size() > word.size() + farthest || candidate.size() + farthest < word.size()) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance <= farthest && distance < candidate.size()) near.emplace_back(distance, candidate);
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  // Only the candidates at the smallest distance are helpful.
  std::erase_if(near, [&](const auto& candidate) { return candidate.first > near.front().first; });
  if (near.size() > MostSuggestions) near.resize(MostSuggestions);
  if (near.empty()) return {};
  std::string text = "did you mean ";
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (i > 0) text += i + 1 == near.size() ? " or " : ", ";
    text += "'" + near[i].second + "'";
  }
  return text + "?";
}

}  // namespace grf
