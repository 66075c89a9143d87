// What OBJ and MTL files have in common: statements, each a keyword and its arguments, one a line.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace convert {

/// Views are into the text of the reader that gave the statement.
struct Statement {
  std::string_view keyword;                 ///< `#` of a comment
  std::vector<std::string_view> arguments;  ///< words, up to a `#` that begins one
  std::string_view rest;                    ///< all that stands behind the keyword
  bool has_line_end = true;                 ///< false where the file ends inside the line, or just behind it

  /// All that stands behind the keyword, on one line: for names, which may have spaces and a `#`.
  std::string text() const;
};

/// What becomes of lines that begin with `#`.
enum class LineComments {
  PassedOver,
  Statements,  ///< of the keyword `#` without arguments
};

/// Cuts a text into statements, passing over blank lines and comments. A backslash at the end of a line joins
/// the next one to it.
class StatementReader {
 public:
  StatementReader(std::shared_ptr<const std::string> text, std::shared_ptr<const grf::SourceFile> file,
                  LineComments comments = LineComments::PassedOver);

  /// Fills in the next statement, or returns false at the end of the text.
  bool next(Statement& statement);

  /// The place of a part of the last statement.
  grf::SourceLocation location(std::string_view part) const;
  grf::SourceLocation whole_file() const { return {file_, 0, 0}; }

  /// True if the text ends inside a line, be it a comment or a blank one.
  bool ends_inside_line() const;

 private:
  std::string_view next_line();

  std::shared_ptr<const std::string> text_;
  std::shared_ptr<const grf::SourceFile> file_;
  LineComments comments_;
  const char* position_;
  const char* end_;
  const char* line_begin_;  // of the last statement
  std::uint32_t line_ = 1;  // the number of that line
};

/// The number that the word is from its first character to its last, if a float can hold it.
std::optional<double> parse_number(std::string_view word);

/// The float nearest to such a number: rounded once, unlike the double above.
std::optional<float> parse_float(std::string_view word);

/// A file's text as UTF-8, with the file that stands for it in messages.
struct SourceText {
  std::shared_ptr<const std::string> text;
  std::shared_ptr<const grf::SourceFile> file;
};

/// Nothing after an error: a file that cannot be read, has no bytes, or is not text. `expected` is what it
/// should have been ("an OBJ model"), `asked_for_at` the place of another file that names it.
std::optional<SourceText> read_source_text(const std::string& path, std::string_view expected,
                                           grf::Diagnostics& diagnostics,
                                           const grf::SourceLocation& asked_for_at = {});

}  // namespace convert
