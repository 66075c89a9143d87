// The values in the body of a PLY file, one after the other, in each of the three encodings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "converters/ply/ply_header.h"
#include "grf/diagnostics.h"

namespace convert {

class PlyValues {
 public:
  /// At the beginning of the body. All that is given outlives this.
  PlyValues(const PlySource& source, const PlyHeader& header, grf::Diagnostics& diagnostics)
      : source_(source),
        text_(*source.bytes),
        encoding_(header.encoding),
        position_(header.size),
        diagnostics_(diagnostics) {}

  /// Says what is read next, for messages.
  void begin(const PlyElement& element, std::uint64_t index) {
    element_ = &element;
    index_ = index;
  }

  /// Reads the next value, which may be infinite or no number if the type is one of floats. A double has room
  /// for each of the types. False after an error, which is said.
  bool next(PlyType type, double& value) {
    value_begin_ = position_;
    return encoding_ == PlyEncoding::Ascii ? next_of_text(type, value) : next_of_bytes(type, value);
  }

  /// The number of values in a list that comes next, for each of which the file has room.
  bool next_count(const PlyProperty& list, std::size_t& count);

  /// Passes over the properties of the element that was begun.
  bool skip_element();
  bool skip(const PlyProperty& property);

  /// Says what is wrong with the value that was read last. False, so that the caller may return it.
  bool fail(const std::string& message);

  std::size_t position() const { return position_; }
  void go_to(std::size_t position) { position_ = position; }

  /// How many bytes are left; white space, in a text, does not count.
  std::size_t bytes_left();

 private:
  bool next_of_bytes(PlyType type, double& value);
  bool next_of_text(PlyType type, double& value);
  bool parse(std::string_view word, PlyType type, double& value);
  void skip_space();
  bool fail_at_end();

  const PlySource& source_;
  std::string_view text_;
  PlyEncoding encoding_;
  std::size_t position_;
  std::size_t value_begin_ = 0;
  const PlyElement* element_ = nullptr;
  std::uint64_t index_ = 0;
  grf::Diagnostics& diagnostics_;
};

}  // namespace convert
