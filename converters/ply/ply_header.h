// The header of a PLY file (Greg Turk, "The PLY Polygon File Format", 1994): the elements that the file has,
// and the properties of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace convert {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// In bytes.
std::size_t size_of(PlyType type);
bool is_float(PlyType type);
/// The older of the two names that a type has, such as `uchar`.
std::string_view name_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;    ///< of each value of a list
  std::optional<PlyType> count_type;  ///< an integer, of how many values there are in a list; none: no list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  grf::SourceLocation location;

  /// The fewest bytes that one can be written with. Where nothing stands between two values of text, the last
  /// one of the file is a byte shorter.
  std::uint64_t fewest_bytes(PlyEncoding encoding) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;   ///< in the order of the body; no two have one name
  std::vector<std::string> comments;  ///< what stands behind the word, as UTF-8
  std::size_t size = 0;               ///< in bytes: where the body begins

  const PlyElement* find(std::string_view name) const;
};

/// The bytes of a PLY file, with the file that stands for them in messages.
struct PlySource {
  std::shared_ptr<const std::string> bytes;
  std::shared_ptr<const grf::SourceFile> file;

  grf::SourceLocation whole_file() const { return {file, 0, 0}; }
  /// The line and column of a byte, for files whose lines end as the first one does.
  grf::SourceLocation place_in_text(std::size_t offset) const;
};

/// Whether a file begins as PLY files do.
bool begins_as_ply(std::string_view first_bytes);

/// Nothing after an error. Counts are such that the body has room for them.
std::optional<PlyHeader> read_ply_header(const PlySource& source, grf::Diagnostics& diagnostics);

}  // namespace convert
