#pragma once

#include <string>
#include <string_view>

namespace convert {

/// The text as UTF-8 without a byte-order mark. Text that begins with a mark of UTF-16 is taken at its word;
/// other text is UTF-8 if it is valid as such, and else Latin-1, which old exporters write.
std::string to_utf8(std::string_view bytes);

/// True of bytes that `to_utf8` gives back as they are.
bool is_plain_utf8(std::string_view bytes);

/// Whether a program that adds a line end, blanks or the end-of-file mark of DOS may have put these bytes
/// behind what a format says that a file has. Any others show that the file was misread.
bool is_padding(std::string_view bytes);

}  // namespace convert
