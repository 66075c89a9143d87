#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace grf {

struct SourceFile;

/// Where a thing was written. Lines and columns count from 1, columns in characters.
/// Line 0 means the file as a whole (or, in a binary file, that the column is a byte offset).
struct SourceLocation {
  std::shared_ptr<const SourceFile> file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  /// All locations are equal: two scenes are the same scene wherever they were written, and this lets
  /// every type that holds a location have a defaulted comparison.
  friend bool operator==(const SourceLocation&, const SourceLocation&) { return true; }
};

/// A file that was read, and the place of the `include` that asked for it (no file if none did).
struct SourceFile {
  std::string path;
  SourceLocation included_at;
  /// The text while it is being read, so that an excerpt needs no second look at the disk.
  std::weak_ptr<const std::string> text;
};

/// A location that means the file as a whole.
SourceLocation whole_file(std::string path);

/// The line of source at a location, without its line end; empty where there is none to show.
std::string source_line(const SourceLocation& location);

}  // namespace grf
