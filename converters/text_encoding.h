#pragma once

#include <string>
#include <string_view>

namespace convert {

/// Converts text to UTF-8 without a byte-order mark. Text with a UTF-16 byte-order mark is UTF-16; other text
/// is UTF-8 if it is valid UTF-8, and else Latin-1, which old exporters write.
std::string to_utf8(std::string_view bytes);

/// Returns whether `to_utf8` leaves the bytes unchanged.
bool is_plain_utf8(std::string_view bytes);

/// Returns whether bytes after the end of the data are harmless padding: line ends, blanks or DOS's
/// end-of-file mark. Any others show that the file was misread.
bool is_padding(std::string_view bytes);

/// Converts a text to one line with one kind of quotes, as names and comments of GRF are.
std::string on_one_line(std::string text);

/// Returns a text as the value of an XML attribute. Control characters, which XML lacks, become blanks.
std::string xml_value(std::string_view text);

}  // namespace convert
