// The text of an OP file that is being edited: options change, and all else stays as its author wrote it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/render_options.h"

namespace options {

/// Comments, order, spacing, line ends, the spelling of keys and lines that are wrong are kept byte for byte.
/// Where a key is given twice, the first one counts.
class OpText {
 public:
  OpText() = default;
  explicit OpText(std::string_view text);

  std::string text() const;

  /// Without a byte order mark, and with `\n` at the end of each line, as text fields have it.
  std::string plain_text() const;
  /// Takes such a text. Lines that stay, before and behind what was changed, keep their own ends.
  void set_plain_text(std::string_view text);

  /// The words behind an option's key, without quotes; nothing if the key is not there.
  std::optional<std::vector<std::string>> words_of(const OptionInfo& option) const;
  /// The number of the line, from 1; 0: the key is not there.
  std::uint32_t line_of(const OptionInfo& option) const;
  /// What a line is about, or null.
  const OptionInfo* option_at(std::uint32_t line) const;

  /// What can be made of the text: values that are wrong count as not given. Paths are as they stand.
  RenderOptions options() const;

  /// Gives an option these words, right or wrong, in place of those that it has; a key that is missing comes
  /// behind the last one of its group. An option that comes to its default is removed. False, and nothing
  /// happens, if a word cannot be written: with a line end, or with a quote where it needs quotes itself.
  bool set(const OptionInfo& option, const std::vector<std::string>& words);

  /// Takes the option away; a comment behind it stays, as a line of its own.
  void remove(const OptionInfo& option);

 private:
  struct Line {
    std::string text;
    std::string end;  ///< `\n`, `\r\n`, or nothing
  };

  std::vector<std::size_t> lines_of(const OptionInfo& option) const;
  void replace(std::size_t line, const std::vector<std::string>& words);
  void add(const OptionInfo& option, const std::vector<std::string>& words);
  std::optional<std::size_t> neighbour_of(const OptionInfo& option) const;
  void remove_line(std::size_t line);

  std::string mark_;  ///< the byte order mark, if there is one
  std::vector<Line> lines_;
};

}  // namespace options
