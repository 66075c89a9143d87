#include "renderer/reflectance/measurements/astm.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grf/cie_colour.h"
#include "renderer/reflectance/observer.h"

namespace reflectance {
namespace {

using Imath::V3d;

constexpr std::string_view Keyword = "VARS";
constexpr std::size_t MostColumns = 1000;

/// A word of a line and its column in characters from 1.
struct Word {
  std::string_view text;
  std::uint32_t column = 1;
};

/// Splits a line at commas and white space.
std::vector<Word> words_of(std::string_view line) {
  std::vector<Word> words;
  const std::string_view separators = ", \t\r";
  for (std::size_t begin = 0;;) {
    begin = line.find_first_not_of(separators, begin);
    if (begin == std::string_view::npos || words.size() > MostColumns) return words;
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.push_back({line.substr(begin, end - begin), static_cast<std::uint32_t>(begin + 1)});
    begin = end;
  }
}

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Returns the wavelength that a column's name has, such as `550nm`.
std::optional<double> wavelength_of(std::string_view name) {
  if (!name.ends_with("nm")) return std::nullopt;
  const auto wavelength = number_of(name.substr(0, name.size() - 2));
  return wavelength && *wavelength > 0 && *wavelength < 1e5 ? wavelength : std::nullopt;
}

enum Angle { ThetaI, PhiI, ThetaS, PhiS, AngleCount };

std::optional<Angle> angle_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Angle>, 6> Names = {{{"theta_i", ThetaI},
                                                                        {"phi_i", PhiI},
                                                                        {"theta_s", ThetaS},
                                                                        {"phi_s", PhiS},
                                                                        {"theta_r", ThetaS},
                                                                        {"phi_r", PhiS}}};
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  for (const auto& [known, angle] : Names) {
    if (known == lower) return angle;
  }
  return std::nullopt;
}

/// Reads the lines of a text one after the other.
class AstmReader {
 public:
  AstmReader(const std::string& path, grf::Diagnostics& diagnostics)
      : location_(grf::whole_file(path)), diagnostics_(diagnostics) {}

  std::optional<std::vector<Measurement>> read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::vector<Word> words = words_of(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      ++location_.line;
      if (words.empty()) continue;
      const bool is_read = columns_ > 0 ? read_values(words) : words[0].text != Keyword || read_names(words);
      if (!is_read) return std::nullopt;
    }
    if (columns_ == 0) {
      location_.line = 0;
      fail(0, "the file has no line VARS, which names the columns");
      return std::nullopt;
    }
    return measurements();
  }

 private:
  struct Row {
    std::array<double, AngleCount> angles = {};
    V3d value;
    std::uint32_t line = 0;
  };

  bool fail(std::uint32_t column, const std::string& message) {
    location_.column = column;
    diagnostics_.error(location_, message);
    return false;
  }

  bool read_names(const std::vector<Word>& words) {
    angle_at_.fill(-1);
    std::vector<std::string> names;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto angle = angle_of(words[i].text);
      if (!angle) {
        value_at_.push_back(i - 1);
        names.emplace_back(words[i].text);
        continue;
      }
      if (angle_at_[*angle] >= 0)
        return fail(words[i].column, fmt::format("the column '{}' is repeated", words[i].text));
      angle_at_[*angle] = static_cast<int>(i - 1);
    }
    columns_ = words.size() - 1;
    if (*std::min_element(angle_at_.begin(), angle_at_.end()) < 0)
      return fail(words[0].column, "VARS lacks one of the angles theta_i, phi_i, theta_s and phi_s");
    return find_colours(words[0].column, names);
  }

  bool find_colours(std::uint32_t column, const std::vector<std::string>& names) {
    using Names = std::vector<std::string>;
    if (names.size() == 1) {
      rows_of_weights_.assign(3, {1});
      return true;
    }
    is_xyz_ = names == Names{"X", "Y", "Z"};
    if (is_xyz_ || names == Names{"R", "G", "B"}) {
      rows_of_weights_ = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      return true;
    }
    std::vector<float> wavelengths;
    for (const std::string& name : names) {
      const auto wavelength = wavelength_of(name);
      if (!wavelength || (!wavelengths.empty() && !(*wavelength > double(wavelengths.back())))) break;
      wavelengths.push_back(static_cast<float>(*wavelength));
    }
    if (wavelengths.empty() || wavelengths.size() != names.size()) {
      return fail(column, fmt::format("the columns of values are '{}', expected one, R,G,B, X,Y,Z or "
                                      "ascending wavelengths such as 550nm",
                                      fmt::join(names, ",")));
    }
    rows_of_weights_ = rgb_weights(wavelengths);
    return true;
  }

  bool read_values(const std::vector<Word>& words) {
    if (words.size() != columns_) {
      return fail(words.back().column,
                  fmt::format("the line has {} values, and VARS names {} columns", words.size(), columns_));
    }
    std::vector<double> values;
    for (const Word& word : words) {
      const auto value = number_of(word.text);
      if (!value) return fail(word.column, fmt::format("'{}' is no number", word.text.substr(0, 40)));
      values.push_back(*value);
    }
    Row row;
    row.line = location_.line;
    for (std::size_t i = 0; i < AngleCount; ++i)
      row.angles[i] = values[static_cast<std::size_t>(angle_at_[i])];
    for (int channel = 0; channel < 3; ++channel) {
      const std::vector<double>& weights = rows_of_weights_[static_cast<std::size_t>(channel)];
      double sum = 0;
      for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * values[value_at_[i]];
      row.value[channel] = sum;
    }
    if (is_xyz_) row.value = grf::srgb_of_xyz(row.value);
    rows_.push_back(row);
    return true;
  }

  std::vector<Measurement> measurements() const {
    constexpr double Grazing = std::numbers::pi / 2;
    const bool in_degrees = std::any_of(rows_.begin(), rows_.end(), [](const Row& row) {
      return std::max(std::abs(row.angles[ThetaI]), std::abs(row.angles[ThetaS])) > Grazing + 0.01;
    });
    const double unit = in_degrees ? std::numbers::pi / 180 : 1;
    std::vector<Measurement> list;
    for (const Row& row : rows_) {
      Measurement one;
      one.u = direction_at(row.angles[ThetaS] * unit, row.angles[PhiS] * unit);
      one.v = direction_at(row.angles[ThetaI] * unit, row.angles[PhiI] * unit);
      // The colours of saturated spectra are outside of sRGB.
      const bool is_colour = rows_of_weights_[0].size() > 1;
      one.value = row.value;
      for (int k = 0; is_colour && k < 3; ++k) {
        if (one.value[k] < 0) one.value[k] = 0;
      }
      one.line = row.line;
      list.push_back(one);
    }
    return list;
  }

  grf::SourceLocation location_;
  grf::Diagnostics& diagnostics_;
  std::size_t columns_ = 0;  ///< 0 before `VARS`
  std::array<int, AngleCount> angle_at_ = {};
  std::vector<std::size_t> value_at_;                 ///< the columns of values
  std::vector<std::vector<double>> rows_of_weights_;  ///< of the values, for each channel
  bool is_xyz_ = false;
  std::vector<Row> rows_;
};

}  // namespace

bool sniff_astm(std::string_view text) {
  for (std::size_t at = text.find(Keyword); at != std::string_view::npos; at = text.find(Keyword, at + 1)) {
    if (at > 0 && text[at - 1] != '\n') continue;
    const std::vector<Word> words =
        words_of(text.substr(at, std::min<std::size_t>(text.find('\n', at), at + 1000) - at));
    return words.size() > 1 && words[0].text == Keyword && angle_of(words[1].text).has_value();
  }
  return false;
}

std::optional<std::vector<Measurement>> parse_astm(std::string_view text, const std::string& path,
                                                   grf::Diagnostics& diagnostics) {
  return AstmReader(path, diagnostics).read(text);
}

}  // namespace reflectance
