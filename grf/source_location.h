#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace grf {

struct SourceFile;

/// A location in a source file. Lines and columns count from 1, columns in characters. Line 0 means the file
/// as a whole (or, in a binary file, that the column is a byte offset).
struct SourceLocation {
  std::shared_ptr<const SourceFile> file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  /// Locations do not take part in equality: all compare equal, so that types that hold one can have a
  /// defaulted comparison.
  friend bool operator==(const SourceLocation&, const SourceLocation&) { return true; }
};

/// A source file, and the location of the `include` that read it (without a file if none did).
struct SourceFile {
  std::string path;
  SourceLocation included_at;
  /// The text while it is being parsed, so that an excerpt need not read the file again.
  std::weak_ptr<const std::string> text;
};

/// Returns the location of a file as a whole.
SourceLocation whole_file(std::string path);

/// Returns the source line at a location, without its line end; empty if it is not available.
std::string source_line(const SourceLocation& location);

}  // namespace grf
