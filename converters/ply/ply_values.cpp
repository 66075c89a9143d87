#include "converters/ply/ply_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "converters/wording.h"

namespace convert {
namespace {

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\f' || c == '\v'; }

template <class T>
T from_bytes(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> ordered;
  std::memcpy(ordered.data(), bytes, sizeof(T));
  if (swap) std::reverse(ordered.begin(), ordered.end());
  return std::bit_cast<T>(ordered);
}

template <class T>
bool fits(double value) {
  return value >= std::numeric_limits<T>::min() && value <= std::numeric_limits<T>::max();
}

bool fits(PlyType type, double value) {
  switch (type) {
    case PlyType::Int8:
      return fits<std::int8_t>(value);
    case PlyType::UInt8:
      return fits<std::uint8_t>(value);
    case PlyType::Int16:
      return fits<std::int16_t>(value);
    case PlyType::UInt16:
      return fits<std::uint16_t>(value);
    case PlyType::Int32:
      return fits<std::int32_t>(value);
    case PlyType::UInt32:
      return fits<std::uint32_t>(value);
    default:
      return true;
  }
}

/// Parses a whole word as a number. Underflow gives 0.
template <class T>
bool parse_number(std::string_view word, double& value) {
  T number = 0;
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, number);
  if (result.ptr != end) return false;
  const bool is_tiny = result.ec == std::errc::result_out_of_range &&
                       (word.find("e-") != word.npos || word.find("E-") != word.npos);
  value = is_tiny ? 0.0 : static_cast<double>(number);
  return is_tiny || result.ec == std::errc();
}

}  // namespace

bool PlyValues::next_count(const PlyProperty& list, std::size_t& count) {
  double number = 0;
  if (!next(*list.count_type, number)) return false;
  if (number < 0) return fail(fmt::format("a list of {} values", number));
  count = static_cast<std::size_t>(number);
  const bool is_text = encoding_ == PlyEncoding::Ascii;
  const std::size_t room = (text_.size() - position_) / (is_text ? 2 : size_of(list.type));
  if (count <= room) return true;
  return fail(
      fmt::format("a list of {}, for which the file is too short", counted(count, "value", "values")));
}

bool PlyValues::skip_element() {
  return std::all_of(element_->properties.begin(), element_->properties.end(),
                     [this](const PlyProperty& property) { return skip(property); });
}

bool PlyValues::skip(const PlyProperty& property) {
  std::size_t count = 1;
  if (property.count_type && !next_count(property, count)) return false;
  if (encoding_ != PlyEncoding::Ascii && property.count_type) {  // its size was checked
    position_ += count * size_of(property.type);
    return true;
  }
  double ignored = 0;
  for (; count > 0; --count) {
    if (!next(property.type, ignored)) return false;
  }
  return true;
}

std::size_t PlyValues::bytes_left() {
  if (encoding_ == PlyEncoding::Ascii) skip_space();
  return text_.size() - position_;
}

bool PlyValues::fail(const std::string& message) {
  const std::string where = fmt::format("{} {} of {}", element_->name, index_ + 1, element_->count);
  if (encoding_ == PlyEncoding::Ascii) {
    diagnostics_.error(source_.place_in_text(value_begin_), fmt::format("{}: {}", where, message));
    return false;
  }
  const auto column = static_cast<std::uint32_t>(
      std::min<std::size_t>(value_begin_, std::numeric_limits<std::uint32_t>::max()));
  diagnostics_.error({source_.file, 0, column},
                     fmt::format("{}, at byte {}: {}", where, value_begin_, message));
  return false;
}

bool PlyValues::fail_at_end() { return fail("the file ends here: it is truncated, or its header is wrong"); }

bool PlyValues::next_of_bytes(PlyType type, double& value) {
  const std::size_t size = size_of(type);
  if (text_.size() - position_ < size) return fail_at_end();
  const char* bytes = text_.data() + position_;
  const bool swap = (encoding_ == PlyEncoding::BigEndian) != (std::endian::native == std::endian::big);
  position_ += size;
  switch (type) {
    case PlyType::Int8:
      value = from_bytes<std::int8_t>(bytes, swap);
      break;
    case PlyType::UInt8:
      value = from_bytes<std::uint8_t>(bytes, swap);
      break;
    case PlyType::Int16:
      value = from_bytes<std::int16_t>(bytes, swap);
      break;
    case PlyType::UInt16:
      value = from_bytes<std::uint16_t>(bytes, swap);
      break;
    case PlyType::Int32:
      value = from_bytes<std::int32_t>(bytes, swap);
      break;
    case PlyType::UInt32:
      value = from_bytes<std::uint32_t>(bytes, swap);
      break;
    case PlyType::Float32:
      value = from_bytes<float>(bytes, swap);
      break;
    case PlyType::Float64:
      value = from_bytes<double>(bytes, swap);
      break;
  }
  return true;
}

void PlyValues::skip_space() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
}

bool PlyValues::next_of_text(PlyType type, double& value) {
  skip_space();
  value_begin_ = position_;
  while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
  const std::string_view word = text_.substr(value_begin_, position_ - value_begin_);
  if (word.empty()) return fail_at_end();
  return parse(word, type, value) ||
         fail(fmt::format("found '{}', expected a number of the type {}", word, name_of(type)));
}

// Text of a float is correctly rounded to float. Some exporters write integers as 3.0.
bool PlyValues::parse(std::string_view word, PlyType type, double& value) {
  if (word.starts_with('+') && word.substr(1, 1) != "-") word.remove_prefix(1);
  if (type == PlyType::Float32) return parse_number<float>(word, value);
  if (!parse_number<double>(word, value)) return false;
  return is_float(type) || (std::trunc(value) == value && fits(type, value));
}

}  // namespace convert
