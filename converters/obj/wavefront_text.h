// The syntax that OBJ and MTL files share: statements, each a keyword and its arguments, one per line.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace convert {

/// A statement. Views are into the text of the reader that returned it.
struct Statement {
  std::string_view keyword;                 ///< `#` for a comment
  std::vector<std::string_view> arguments;  ///< words, up to one that begins with `#`
  std::string_view rest;                    ///< everything after the keyword
  bool has_line_end = true;                 ///< false if the file ends in the line or right after it

  /// Returns everything after the keyword, on one line: for names, which may have spaces and a `#`.
  std::string text() const;
};

/// The treatment of lines that begin with `#`.
enum class LineComments {
  Skipped,
  Statements,  ///< statements of the keyword `#` without arguments
};

/// Splits a text into statements, skipping blank lines and comments. A backslash at the end of a line joins
/// the next one to it.
class StatementReader {
 public:
  StatementReader(std::shared_ptr<const std::string> text, std::shared_ptr<const grf::SourceFile> file,
                  LineComments comments = LineComments::Skipped);

  /// Reads the next statement, or returns false at the end of the text.
  bool next(Statement& statement);

  /// Returns the location of a part of the last statement.
  grf::SourceLocation location(std::string_view part) const;
  grf::SourceLocation whole_file() const { return {file_, 0, 0}; }

  /// Returns whether the text ends without a line end, also in a comment or blank line.
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

/// Parses a whole word as a number, if a float can represent it.
std::optional<double> parse_number(std::string_view word);

/// Parses such a number to the nearest float: rounded once, unlike the double above.
std::optional<float> parse_float(std::string_view word);

/// The text of a file as UTF-8, with the source file for messages.
struct SourceText {
  std::shared_ptr<const std::string> text;
  std::shared_ptr<const grf::SourceFile> file;
};

/// Reads a text file; returns nothing after an error: a file that cannot be read, is empty, or is not text.
/// `expected` describes it ("an OBJ model"), `asked_for_at` is the location of its name in another file.
std::optional<SourceText> read_source_text(const std::string& path, std::string_view expected,
                                           grf::Diagnostics& diagnostics,
                                           const grf::SourceLocation& asked_for_at = {});

}  // namespace convert
