#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "grf/source_location.h"

namespace grf {

enum class Severity { Note, Warning, Error };  ///< How bad a diagnostic is: errors leave no result.

/// A message about the input, and where in it.
struct Diagnostic {
  Severity severity = Severity::Error;
  SourceLocation location;
  std::string message;
  std::string excerpt;               ///< the source line, or the part of a long one around the column
  std::uint32_t excerpt_column = 0;  ///< column in the excerpt, in characters from 1
};

/// Collects errors, warnings and notes about users' input. Never exits and never throws for a user's mistake.
class Diagnostics {
 public:
  /// The number of errors kept: later ones are mostly consequences of earlier ones.
  static constexpr std::size_t MaximumErrors = 20;
  /// The number of warnings kept: a generated file repeats its mistakes.
  static constexpr std::size_t MaximumWarnings = 100;

  Diagnostics() = default;
  /// Returns a list whose entries another one is to repeat: they have no excerpts, which are searched for in
  /// the whole source each time.
  static Diagnostics to_be_repeated() {
    Diagnostics diagnostics;
    diagnostics.takes_excerpts_ = false;
    return diagnostics;
  }

  // Duplicates (the same message at the same location, as in a file that is included twice) are kept once.

  void error(SourceLocation location, std::string_view message);  ///< Adds an error, or a warning.
  void warning(SourceLocation location, std::string_view message);
  /// Warns that the result does not keep something of the input.
  void loss(SourceLocation location, std::string_view message);
  /// Adds a note: information that is no problem, such as the name of a file that was rewritten.
  void note(SourceLocation location, std::string_view message);

  bool has_errors() const { return error_count_ > 0; }  ///< Returns whether there was an error.
  // These counts include diagnostics that were not kept.
  std::size_t error_count() const { return error_count_; }
  std::size_t warning_count() const { return warning_count_; }
  /// Returns true once MaximumErrors were reported: a reader may stop.
  bool is_full() const { return kept_errors_ >= MaximumErrors; }
  const std::vector<Diagnostic>& entries() const { return entries_; }
  /// Returns the messages of all losses, which are among the entries too.
  const std::vector<std::string>& losses() const { return losses_; }

  /// Records a file that was read.
  void add_file(const std::string& path) { files_.insert(path); }
  /// Returns the files that were read, by the paths under which they were opened.
  const std::set<std::string>& files() const { return files_; }

  /// Formats each entry as `file:line:column: error: message`, the source line, a caret under the column, and
  /// the chain of includes.
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
  bool takes_excerpts_ = true;
};

/// Formats one diagnostic as `Diagnostics::to_text` does.
std::string to_text(const Diagnostic& diagnostic);

/// Returns "did you mean 'ward'?" with up to three candidates similar to the word, or an empty string.
/// Similarity is the Damerau-Levenshtein distance, case-insensitive.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace grf
