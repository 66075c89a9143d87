#include "renderer/reflectance/schemes/factor_files.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grf/text_file.h"

namespace reflectance {
namespace {

constexpr std::string_view WeightsTitle = "granada factors 1";
constexpr std::string_view CurvesTitle = "granada factors cdf 1";
constexpr std::string_view End = "end";

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

std::vector<std::string> header(std::string_view title, const FactorFiles& files) {
  const FactorSize& size = files.size;
  return {std::string(title), "brdf " + on_one_line(files.brdf_identity),
          fmt::format("uTh {} uPh {} pTh {} pPh {} J {} K {} half {}", size.view_angles, size.view_azimuths,
                      size.rows, size.columns, size.view_factors, size.factors, size.by_half)};
}

/// Reads line by line, and reports only the first error.
class Reader {
 public:
  Reader(const std::string& path, grf::Diagnostics& diagnostics) : diagnostics_(diagnostics) {
    location_ = grf::whole_file(path);
    text_ = grf::read_file(path, diagnostics);
    if (!text_) return;
    rest_ = *text_;
    auto file = std::make_shared<grf::SourceFile>(*location_.file);
    file->text = text_;
    location_.file = std::move(file);
  }

  bool expect(std::string_view expected) {
    const auto line = next_line();
    if (!line) return fail(fmt::format("the file ends too early: expected '{}'", expected));
    return *line == expected || fail(fmt::format("expected '{}'", expected));
  }

  bool expect_end() { return expect(End) && (rest_.empty() || fail("unexpected text after the end", 1)); }

  /// Reads a line of exactly so many numbers in [0,1].
  bool read(std::size_t count, std::vector<float>& numbers) {
    const auto line = next_line();
    if (!line) return fail(fmt::format("the file ends too early: expected {} numbers", count));
    const char* place = line->data();
    const char* const end = place + line->size();
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0 && place != end && *place == ' ') ++place;
      float number = 0;
      const auto [behind, error] = std::from_chars(place, end, number);
      if (error != std::errc() || (behind != end && *behind != ' '))
        return fail(fmt::format("expected {} numbers, but number {} cannot be read", count, i + 1));
      if (!(number >= 0 && number <= 1) || std::signbit(number))
        return fail(fmt::format("number {} is not in [0,1]", i + 1));
      numbers.push_back(number);
      place = behind;
    }
    return place == end || fail(fmt::format("expected {} numbers, but there are more", count));
  }

  /// Reads a cdf: numbers that rise from 0 to 1.
  bool read_curve(std::size_t count, std::vector<float>& numbers) {
    if (!read(count, numbers)) return false;
    const std::span<const float> curve = std::span(numbers).last(count);
    return (curve.front() == 0 && curve.back() == 1 && std::is_sorted(curve.begin(), curve.end())) ||
           fail("this cumulative distribution does not rise from 0 to 1");
  }

 private:
  std::optional<std::string_view> next_line() {
    if (!text_) return std::nullopt;
    ++location_.line;
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) return std::nullopt;  // the last line must end with a newline, too
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }

  bool fail(std::string_view message, std::uint32_t lines_on = 0) {
    if (!text_) return false;  // already reported
    location_.line += lines_on;
    diagnostics_.error(location_, message);
    return false;
  }

  grf::Diagnostics& diagnostics_;
  grf::SourceLocation location_;
  std::shared_ptr<const std::string> text_;
  std::string_view rest_;
};

bool read_header(Reader& reader, const std::vector<std::string>& lines) {
  return std::all_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return reader.expect(line); });
}

std::string line_of(std::span<const float> numbers) { return fmt::format("{}\n", fmt::join(numbers, " ")); }

}  // namespace

bool FactorFiles::exist() const {
  std::error_code ignored;
  return std::filesystem::exists(weights_path(), ignored) || std::filesystem::exists(curves_path(), ignored);
}

std::optional<Factors> FactorFiles::load(grf::Diagnostics& diagnostics) const {
  std::vector<float> weights;
  Reader weights_file(weights_path(), diagnostics);
  if (!read_header(weights_file, header(WeightsTitle, *this))) return std::nullopt;
  for (std::size_t i = 0; i < size.views(); ++i) {
    if (!weights_file.read(size.lobes(), weights)) return std::nullopt;
  }
  if (!weights_file.expect_end()) return std::nullopt;

  std::vector<float> curves;
  Reader curves_file(curves_path(), diagnostics);
  if (!read_header(curves_file, header(CurvesTitle, *this))) return std::nullopt;
  for (std::size_t i = 0; i < size.lobes(); ++i) {
    if (!curves_file.read_curve(size.rows + 1, curves)) return std::nullopt;
    if (!curves_file.read_curve(size.columns + 1, curves)) return std::nullopt;
  }
  if (!curves_file.expect_end()) return std::nullopt;
  return Factors(size, std::move(weights), std::move(curves));
}

bool FactorFiles::save(const Factors& factors, grf::Diagnostics& diagnostics) const {
  std::string weights_text;
  for (const std::string& line : header(WeightsTitle, *this)) weights_text += line + '\n';
  std::span<const float> weights = factors.view_weights();
  for (; !weights.empty(); weights = weights.subspan(size.lobes())) {
    weights_text += line_of(weights.first(size.lobes()));
  }
  weights_text += fmt::format("{}\n", End);

  std::string curves_text;
  for (const std::string& line : header(CurvesTitle, *this)) curves_text += line + '\n';
  std::span<const float> curves = factors.curves();
  while (!curves.empty()) {
    for (const std::size_t count : {size.rows + 1, size.columns + 1}) {
      curves_text += line_of(curves.first(count));
      curves = curves.subspan(count);
    }
  }
  curves_text += fmt::format("{}\n", End);
  return grf::replace_file(weights_path(), weights_text, diagnostics) &&
         grf::replace_file(curves_path(), curves_text, diagnostics);
}

}  // namespace reflectance
