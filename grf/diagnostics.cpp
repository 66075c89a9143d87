#include "grf/diagnostics.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"

namespace grf {
namespace {

/// Longer lines are cut: a file of one line of 100 MB must not be printed whole.
constexpr std::size_t LongestExcerpt = 200;

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
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// White space that puts a caret under the column, keeping tabs so that both lines are indented alike.
std::string indentation_up_to(std::string_view line, std::uint32_t column) {
  std::string indentation;
  for (const char c : line) {
    if (is_continuation_byte(c)) continue;
    if (indentation.size() + 1 >= column) break;
    indentation += c == '\t' ? '\t' : ' ';
  }
  return indentation;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> distance(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) distance[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) distance[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = lower_case(a[i - 1]) == lower_case(b[j - 1]) ? 0 : 1;
      distance[i][j] =
          std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1, distance[i - 1][j - 1] + substitution});
      const bool swapped = i > 1 && j > 1 && lower_case(a[i - 1]) == lower_case(b[j - 2]) &&
                           lower_case(a[i - 2]) == lower_case(b[j - 1]);
      if (swapped) distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
    }
  }
  return distance[a.size()][b.size()];
}

}  // namespace

SourceLocation whole_file(std::string path) {
  return {std::make_shared<SourceFile>(SourceFile{std::move(path), {}, {}}), 0, 0};
}

std::string source_line(const SourceLocation& location) {
  if (!location.file || location.line == 0) return {};
  if (const auto text = location.file->text.lock()) return std::string(line_of(*text, location.line));
  std::ifstream file(location.file->path);
  std::string line;
  for (std::uint32_t i = 0; i < location.line; ++i) {
    if (!std::getline(file, line)) return {};
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

void Diagnostics::error(SourceLocation location, std::string message) {
  add(Severity::Error, std::move(location), std::move(message));
}

void Diagnostics::warning(SourceLocation location, std::string message) {
  add(Severity::Warning, std::move(location), std::move(message));
}

void Diagnostics::note(SourceLocation location, std::string message) {
  add(Severity::Note, std::move(location), std::move(message));
}

std::size_t Diagnostics::warning_count() const {
  return static_cast<std::size_t>(std::count_if(
      entries_.begin(), entries_.end(), [](const Diagnostic& d) { return d.severity == Severity::Warning; }));
}

void Diagnostics::add(Severity severity, SourceLocation location, std::string message) {
  if (severity == Severity::Error) {
    if (is_full()) return;
    ++error_count_;
  }
  std::string excerpt = source_line(location);
  entries_.push_back({severity, std::move(location), std::move(message), std::move(excerpt)});
}

std::string to_text(const Diagnostic& diagnostic) {
  const SourceLocation& location = diagnostic.location;
  std::string text;
  if (location.file) text += location.file->path + ":";
  if (location.file && location.line > 0) text += fmt::format("{}:{}:", location.line, location.column);
  if (!text.empty()) text += ' ';
  text += fmt::format("{}: {}\n", name_of(diagnostic.severity), diagnostic.message);
  // The excerpt of a very long line would hide the message, and its caret would be off the screen.
  if (!diagnostic.excerpt.empty() && diagnostic.excerpt.size() <= LongestExcerpt) {
    text += fmt::format("  {}\n  {}^\n", diagnostic.excerpt,
                        indentation_up_to(diagnostic.excerpt, location.column));
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
  return text;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t MostSuggestions = 3;
  std::vector<std::pair<std::size_t, std::string>> near;
  // A word of over 64 characters is no misspelling of a keyword, and the distance costs the square.
  if (word.size() > 64) return {};
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance <= 1 + word.size() / 3 && distance < candidate.size())
      near.emplace_back(distance, candidate);
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
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
