#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace convert::vrml {

/// True of bytes that begin as compressed files do (RFC 1952).
bool is_gzip(std::string_view bytes);

struct Inflated {
  enum class State { Whole, CutOff, Damaged, TooLarge };
  std::string text;
  State state = State::Whole;
  std::size_t rest = 0;  ///< bytes behind the end that are neither compressed nor zero
};

/// What the bytes were before they were compressed, or as much of it as can be had: no more than so many
/// bytes, however many the compressed ones stand for.
Inflated inflate_gzip(std::string_view bytes, std::size_t most_bytes);

}  // namespace convert::vrml
