// An OP file is edited as text: options change, and comments and layout stay as their author wrote them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/render_options.h"

namespace options {

/// The text of an OP file. Edits keep comments, order, spacing, line ends, the spelling of keys and invalid
/// lines byte for byte. Of duplicate keys, the first one counts.
class OpText {
 public:
  OpText() = default;
  explicit OpText(std::string_view text);

  std::string text() const;

  /// Returns the text without a byte order mark and with `\n` line ends, for text fields.
  std::string plain_text() const;
  /// Sets the text from a text field. Unchanged lines at the beginning and end keep their own line ends.
  void set_plain_text(std::string_view text);

  /// Returns the words after an option's key, without quotes; nothing if the key is not there.
  std::optional<std::vector<std::string>> words_of(const OptionInfo& option) const;
  /// Returns the line number of an option, from 1; 0 if the key is not there.
  std::uint32_t line_of(const OptionInfo& option) const;
  /// Returns the option that a line sets, or null.
  const OptionInfo* option_at(std::uint32_t line) const;

  /// Parses the text leniently: invalid values are ignored. Paths are not resolved.
  RenderOptions options() const;

  /// Sets an option's words, valid or not; a missing key is added after the last one of its group. An option
  /// that has its default value is removed. Returns false and changes nothing if a word cannot be written:
  /// one with a line end, or with a quote where the word itself needs quotes.
  bool set(const OptionInfo& option, const std::vector<std::string>& words);

  /// Removes the option; a comment after it stays, as a line of its own.
  void remove(const OptionInfo& option);

 private:
  struct Line {
    std::string text;
    std::string end;  ///< `\n`, `\r\n`, or empty
  };

  std::vector<std::size_t> lines_of(const OptionInfo& option) const;
  std::vector<std::string> words_at(std::size_t line) const;
  void replace(std::size_t line, const std::vector<std::string>& words);
  void add(const OptionInfo& option, const std::vector<std::string>& words);
  std::optional<std::size_t> insertion_line(const OptionInfo& option) const;
  void remove_line(std::size_t line);

  std::string byte_order_mark_;  ///< the byte order mark, or empty
  std::vector<Line> lines_;
};

}  // namespace options
