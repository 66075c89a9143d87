// A line of an OP file is split into words, of which the first are the key of an option.
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
  std::size_t begin = 0;  ///< byte offset in the line, quotes included
  std::size_t end = 0;
  bool is_open = false;  ///< the closing quote is missing
};

/// Splits a line into words, up to a comment. A comment starts the line or follows white space, so that `a#b`
/// and `http://x` are words. A quoted word may contain spaces.
std::vector<OpWord> op_words(std::string_view line);

/// The option that a line sets.
struct OpKey {
  const OptionInfo* option = nullptr;  ///< null if the key is unknown
  std::size_t word_count = 0;          ///< words of the key: spaces may stand for underscores
};
OpKey op_key(const std::vector<OpWord>& words);

/// Returns the column of a byte of UTF-8 text, in characters from 1.
std::uint32_t op_column(std::string_view line, std::size_t at);

}  // namespace options
