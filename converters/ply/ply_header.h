// The header of a PLY file lists its elements and their properties (Greg Turk, "The PLY Polygon File Format",
// 1994).
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

/// Returns the size of a type in bytes.
std::size_t size_of(PlyType type);
bool is_float(PlyType type);
/// Returns the older of the two names of a type, such as `uchar`.
std::string_view name_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;    ///< type of the value, or of each value of a list
  std::optional<PlyType> count_type;  ///< integer type of the number of values in a list; empty: no list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  grf::SourceLocation location;

  /// Returns the minimum number of bytes per element. In text this includes a separator per value, which the
  /// last value of the file may lack.
  std::uint64_t fewest_bytes(PlyEncoding encoding) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;   ///< in the order of the body; names are unique
  std::vector<std::string> comments;  ///< text after the keyword, as UTF-8
  std::size_t size = 0;               ///< in bytes: the offset of the body

  const PlyElement* find(std::string_view name) const;
};

/// The bytes of a PLY file, with the source file for messages.
struct PlySource {
  std::shared_ptr<const std::string> bytes;
  std::shared_ptr<const grf::SourceFile> file;

  grf::SourceLocation whole_file() const { return {file, 0, 0}; }
  /// Returns the line and column of a byte, for files with consistent line ends.
  grf::SourceLocation place_in_text(std::size_t offset) const;
};

/// Returns whether a file begins like a PLY file.
bool begins_as_ply(std::string_view first_bytes);

/// Reads the header; returns nothing after an error. Counts of elements are checked to fit the size of the
/// body.
std::optional<PlyHeader> read_ply_header(const PlySource& source, grf::Diagnostics& diagnostics);

}  // namespace convert
