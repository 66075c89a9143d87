#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace convert::vrml {

/// Returns whether bytes begin like a gzip file (RFC 1952).
bool is_gzip(std::string_view bytes);

struct Inflated {
  enum class State { Whole, CutOff, Damaged, TooLarge };
  std::string text;
  State state = State::Whole;
  std::size_t rest = 0;  ///< number of trailing bytes that are neither compressed data nor zero
};

/// Decompresses gzip data, or as much of it as is valid, up to a maximum number of bytes (against zip bombs).
Inflated inflate_gzip(std::string_view bytes, std::size_t most_bytes);

}  // namespace convert::vrml
