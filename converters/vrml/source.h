#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace convert::vrml {

/// The versions VRML 1.0 (1995), and VRML97 (ISO/IEC 14772-1:1997), also called 2.0.
enum class Version { Vrml1, Vrml97 };

/// The text of a VRML file as UTF-8.
class Source {
 public:
  Source(std::shared_ptr<const std::string> text, std::shared_ptr<const grf::SourceFile> file,
         Version version, bool is_compressed);

  std::string_view text() const { return *text_; }
  const std::string& path() const { return file_->path; }
  Version version() const { return version_; }

  /// Returns the location of a byte of the text, in a time independent of the length of lines.
  grf::SourceLocation location(std::size_t offset) const;
  grf::SourceLocation whole_file() const { return {file_, 0, 0}; }
  /// Returns a location that may outlive the text: lines of a compressed file can then no longer be shown.
  grf::SourceLocation lasting_location(std::size_t offset) const {
    return is_compressed_ ? whole_file() : location(offset);
  }

 private:
  struct Place {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
    void pass(std::string_view text);
  };
  static constexpr std::size_t CheckpointDistance = 4096;

  std::shared_ptr<const std::string> text_;
  std::shared_ptr<const grf::SourceFile> file_;
  Version version_;
  bool is_compressed_;
  std::vector<Place> checkpoints_;  // line and column at regular intervals of the text
};

/// Returns whether a file that begins with these bytes is VRML, compressed or not.
bool sniff(std::string_view first_bytes);

/// Reads a file, which may be compressed by gzip. Null after an error: a file that cannot be read, or is not
/// VRML. `asked_for_at` is the location of its name in another file.
std::shared_ptr<const Source> read_source(const std::string& path, const grf::SourceLocation& asked_for_at,
                                          grf::Diagnostics& diagnostics);

/// Makes a source of bytes in memory.
std::shared_ptr<const Source> make_source(std::string_view bytes, const std::string& path,
                                          const grf::SourceLocation& asked_for_at,
                                          grf::Diagnostics& diagnostics);

}  // namespace convert::vrml
