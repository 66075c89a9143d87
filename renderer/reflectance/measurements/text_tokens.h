#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace reflectance {

/// Reads the words and numbers of a text of measured data, between white space, one after the other. Lines
/// that start with `#` are comments. Errors name line and column.
class TextTokens {
 public:
  static constexpr std::size_t MostValues = std::size_t(1) << 24U;

  TextTokens(std::string_view text, const std::string& path, grf::Diagnostics& diagnostics);

  /// Returns the next word and goes on; empty at the end.
  std::string_view next();
  /// Returns the next word and stays there; empty at the end.
  std::string_view peek();

  /// Reads a finite number, or reports an error that says what was expected.
  std::optional<double> number(std::string_view what);
  /// Reads the number of angles, and the angles: finite, in degrees, ascending and in a range.
  bool angles(std::string_view what, double least, double most, std::vector<double>& radians);

  /// Reports an error at the word that `next` returned last, and returns false.
  bool fail(const std::string& message);

 private:
  void skip_blank();

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  std::uint32_t line_ = 1;
  grf::SourceLocation last_;  ///< of the word that was read last
  grf::Diagnostics& diagnostics_;
};

}  // namespace reflectance
