#include "renderer/reflectance/measurements/text_tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "grf/text_file.h"

namespace reflectance {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

TextTokens::TextTokens(std::string_view text, const std::string& path, grf::Diagnostics& diagnostics)
    : text_(text), last_(grf::whole_file(path)), diagnostics_(diagnostics) {
  if (text_.starts_with(grf::ByteOrderMark)) at_ = line_start_ = grf::ByteOrderMark.size();
}

void TextTokens::skip_blank() {
  while (at_ < text_.size()) {
    if (at_ == line_start_ && text_[at_] == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (text_[at_] == '\n') {
      line_start_ = ++at_;
      ++line_;
    } else if (is_blank(text_[at_])) {
      ++at_;
    } else {
      return;
    }
  }
}

std::string_view TextTokens::peek() {
  skip_blank();
  std::size_t end = at_;
  while (end < text_.size() && !is_blank(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view TextTokens::next() {
  const std::string_view word = peek();
  last_.line = line_;
  last_.column = static_cast<std::uint32_t>(at_ - line_start_ + 1);
  at_ += word.size();
  return word;
}

bool TextTokens::fail(const std::string& message) {
  diagnostics_.error(last_, message);
  return false;
}

std::optional<double> TextTokens::number(std::string_view what) {
  std::string_view word = next();
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (!word.empty() && error == std::errc() && end == word.data() + word.size() && std::isfinite(value))
    return value;
  fail(word.empty() ? fmt::format("the file ends before {}", what)
                    : fmt::format("'{}' is no finite number, for {}", word.substr(0, 40), what));
  return std::nullopt;
}

bool TextTokens::angles(std::string_view what, double least, double most, std::vector<double>& radians) {
  const auto count = number(fmt::format("the number of angles of {}", what));
  if (!count) return false;
  if (!(*count >= 1 && *count <= 100'000 && *count == std::floor(*count)))
    return fail(fmt::format("'{}' has {} angles, expected 1 to 100000", what, *count));
  radians.clear();
  for (auto i = static_cast<std::size_t>(*count); i > 0; --i) {
    const auto degrees = number(fmt::format("an angle of {}", what));
    if (!degrees) return false;
    if (!(*degrees >= least && *degrees <= most))
      return fail(fmt::format("an angle of {} is {}, expected {} to {}", what, *degrees, least, most));
    const double angle = *degrees * std::numbers::pi / 180;
    if (!radians.empty() && !(angle > radians.back()))
      return fail(fmt::format("the angles of {} are not ascending", what));
    radians.push_back(angle);
  }
  return true;
}

}  // namespace reflectance
