// The words of a line of an OP file, and the option that they are about.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/render_options.h"

namespace options {

struct OpWord {
  std::string text;       ///< without quotes
  std::size_t begin = 0;  ///< in bytes of the line, with its quotes
  std::size_t end = 0;
  bool is_open = false;  ///< its second quote is missing
};

/// Up to the comment, if there is one: it starts the line or follows white space, so that `a#b` and
/// `http://x` are words. A quoted word may contain spaces.
std::vector<OpWord> op_words(std::string_view line);

/// What a line is about, and how many of its words are the key: underscores may be spaces. Null if it is no
/// option.
struct OpKey {
  const OptionInfo* option = nullptr;
  std::size_t word_count = 0;
};
OpKey op_key(const std::vector<OpWord>& words);

/// The column of a byte of UTF-8 text, in characters from 1.
std::uint32_t op_column(std::string_view line, std::size_t at);

}  // namespace options
