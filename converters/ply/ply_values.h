// PLY values are read from the body of a file in each of the three encodings.
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
  /// Starts at the beginning of the body. The arguments must outlive this.
  PlyValues(const PlySource& source, const PlyHeader& header, grf::Diagnostics& diagnostics)
      : source_(source),
        text_(*source.bytes),
        encoding_(header.encoding),
        position_(header.size),
        diagnostics_(diagnostics) {}

  /// Sets the element that is read next, for messages.
  void begin(const PlyElement& element, std::uint64_t index) {
    element_ = &element;
    index_ = index;
  }

  /// Reads the next value of any type as a double; floats may be infinite or NaN. Returns false after an
  /// error.
  bool next(PlyType type, double& value) {
    value_begin_ = position_;
    return encoding_ == PlyEncoding::Ascii ? next_of_text(type, value) : next_of_bytes(type, value);
  }

  /// Reads the number of values of a list, which is checked to fit the size of the file.
  bool next_count(const PlyProperty& list, std::size_t& count);

  /// Skips the properties of the current element.
  bool skip_element();
  bool skip(const PlyProperty& property);

  /// Reports an error of the last value, and returns false.
  bool fail(const std::string& message);

  std::size_t position() const { return position_; }
  void go_to(std::size_t position) { position_ = position; }

  /// Returns the number of bytes left, without white space in a text.
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
