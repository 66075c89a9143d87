#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "grf/source_location.h"

namespace grf {

enum class Severity { Note, Warning, Error };

struct Diagnostic {
  Severity severity = Severity::Error;
  SourceLocation location;
  std::string message;
  std::string excerpt;               ///< the source line, or what is around the column of a long one
  std::uint32_t excerpt_column = 0;  ///< of the excerpt, in characters from 1
};

/// Collects what is wrong with users' input. Never exits and never throws for a user's mistake.
class Diagnostics {
 public:
  /// No more errors than this are kept: later ones are mostly consequences of earlier ones.
  static constexpr std::size_t MaximumErrors = 20;
  /// Nor more warnings than this: a generated file repeats what it does wrong.
  static constexpr std::size_t MaximumWarnings = 100;

  // The same thing said twice about the same place, as of a file that is included twice, is kept once.

  void error(SourceLocation location, std::string_view message);
  void warning(SourceLocation location, std::string_view message);
  /// A warning that something of the input is not in what was made of it.
  void loss(SourceLocation location, std::string_view message);
  /// Says something that is neither right nor wrong, such as the name of a file that was rewritten.
  void note(SourceLocation location, std::string_view message);

  bool has_errors() const { return error_count_ > 0; }
  // Both count what was not kept too.
  std::size_t error_count() const { return error_count_; }
  std::size_t warning_count() const { return warning_count_; }
  /// True once MaximumErrors were reported: whoever is reading may stop.
  bool is_full() const { return kept_errors_ >= MaximumErrors; }
  const std::vector<Diagnostic>& entries() const { return entries_; }
  /// The messages of all losses, which are among the entries too.
  const std::vector<std::string>& losses() const { return losses_; }

  /// What is said is about files: this takes down one that was read.
  void add_file(const std::string& path) { files_.insert(path); }
  /// All of them, by the paths under which they were read.
  const std::set<std::string>& files() const { return files_; }

  /// `file:line:column: error: message`, the source line, a caret under the column, and the chain of
  /// includes, for each entry.
  std::string to_text() const;

 private:
  void add(Severity severity, SourceLocation location, std::string_view message);

  std::vector<Diagnostic> entries_;
  std::vector<std::string> losses_;
  std::set<std::string> files_;
  std::size_t error_count_ = 0;
  std::size_t warning_count_ = 0;
  std::size_t kept_errors_ = 0;
  std::size_t kept_warnings_ = 0;
};

/// The text of one diagnostic, as `Diagnostics::to_text` prints it.
std::string to_text(const Diagnostic& diagnostic);

/// "did you mean 'ward'?" with up to three of the candidates that are near the word, or an empty string.
/// Nearness is the Damerau-Levenshtein distance, without regard to case.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace grf
