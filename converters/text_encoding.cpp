#include "converters/text_encoding.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "grf/text_file.h"
#include "grf/write.h"

namespace convert {
namespace {

constexpr std::string_view Utf16BigEndianMark = "\xFE\xFF";
constexpr std::string_view Utf16LittleEndianMark = "\xFF\xFE";
constexpr char32_t ReplacementCharacter = 0xFFFD;

std::uint8_t byte_at(std::string_view bytes, std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); }

void append_utf8(std::string& text, char32_t character) {
  const auto put = [&text](char32_t byte) { text += static_cast<char>(byte); };
  const auto put_continuation = [&](unsigned shift) { put(0x80U | ((character >> shift) & 0x3FU)); };
  if (character < 0x80) {
    put(character);
  } else if (character < 0x800) {
    put(0xC0U | (character >> 6U));
    put_continuation(0);
  } else if (character < 0x10000) {
    put(0xE0U | (character >> 12U));
    put_continuation(6);
    put_continuation(0);
  } else {
    put(0xF0U | (character >> 18U));
    put_continuation(12);
    put_continuation(6);
    put_continuation(0);
  }
}

/// Returns the length of the UTF-8 sequence at i, or 0 if it is invalid (RFC 3629: overlong, surrogate).
std::size_t sequence_length(std::string_view bytes, std::size_t i) {
  const std::uint8_t first = byte_at(bytes, i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || i + length > bytes.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte_at(bytes, i + k) & 0xC0U) != 0x80U) return 0;
  }
  const std::uint8_t second = byte_at(bytes, i + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second > 0x9F;
  const bool too_large = first == 0xF4 && second > 0x8F;
  return overlong || surrogate || too_large ? 0 : length;
}

/// Checks eight bytes at once, since most text is ASCII.
std::size_t ascii_end(std::string_view bytes, std::size_t begin) {
  constexpr std::uint64_t HighBits = 0x8080808080808080ULL;
  for (; begin + 8 <= bytes.size(); begin += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + begin, sizeof word);
    if ((word & HighBits) != 0) break;
  }
  return begin;
}

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = ascii_end(bytes, 0); i < bytes.size();) {
    const std::size_t length = sequence_length(bytes, i);
    if (length == 0) return false;
    i = length == 1 ? ascii_end(bytes, i + 1) : i + length;
  }
  return true;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (std::size_t i = 0; i < bytes.size(); ++i) append_utf8(text, byte_at(bytes, i));
  return text;
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
  const auto unit_at = [&](std::size_t i) -> char32_t {
    const char32_t first = byte_at(bytes, i);
    const char32_t second = byte_at(bytes, i + 1);
    return big_endian ? first << 8U | second : second << 8U | first;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const char32_t unit = unit_at(i);
    const bool is_surrogate = (unit & 0xF800U) == 0xD800U;
    const bool has_low = i + 3 < bytes.size() && (unit_at(i + 2) & 0xFC00U) == 0xDC00U;
    if (is_surrogate && unit < 0xDC00 && has_low) {
      i += 2;
      append_utf8(text, 0x10000U + ((unit - 0xD800U) << 10U) + (unit_at(i) - 0xDC00U));
    } else {
      append_utf8(text, is_surrogate ? ReplacementCharacter : unit);
    }
  }
  return text;
}

}  // namespace

bool is_plain_utf8(std::string_view bytes) {
  const bool has_mark = bytes.starts_with(Utf16BigEndianMark) || bytes.starts_with(Utf16LittleEndianMark) ||
                        bytes.starts_with(grf::ByteOrderMark);
  return !has_mark && is_utf8(bytes);
}

std::string to_utf8(std::string_view bytes) {
  if (bytes.starts_with(Utf16BigEndianMark)) return from_utf16(bytes.substr(2), true);
  if (bytes.starts_with(Utf16LittleEndianMark)) return from_utf16(bytes.substr(2), false);
  if (bytes.starts_with(grf::ByteOrderMark)) bytes.remove_prefix(grf::ByteOrderMark.size());
  return is_utf8(bytes) ? std::string(bytes) : from_latin1(bytes);
}

bool is_padding(std::string_view bytes) {
  return bytes.find_first_not_of(" \t\r\n\f\v\x1A") == std::string_view::npos;
}

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\0'; }, ' ');
  return grf::with_one_kind_of_quotes(std::move(text));
}

std::string xml_value(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
        result += "&#10;";
        break;
      default:
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result;
}

}  // namespace convert
