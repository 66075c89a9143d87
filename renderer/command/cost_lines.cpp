#include "renderer/command/cost_lines.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "grf/check.h"
#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/write.h"
#include "renderer/options/scheme_model.h"
#include "renderer/reflectance/scheme.h"

namespace command {
namespace {

using options::RenderOptions;

/// The option that an axis sets.
struct AxisOption {
  std::string_view flag;
  std::string_view key;
  std::string_view scheme;     ///< the only scheme that uses it; empty: any
  std::string_view name_text;  ///< format of a line's name, with {} for the value; a plural, if it counts
  std::string_view mode = {};  ///< the only mode of the scheme that uses it; empty: any
};

constexpr std::string_view PdfFlag = "--pdf";
constexpr AxisOption AxisOptions[] = {{"--integrator", "BPT_Integrator", "", "{}"},
                                      {"--depth", "BPT_Depth", "", "depth {}"},
                                      {"--branches", "BPT_Branches", "", "{} ways"},
                                      {"--points", "BPT_Points", "", "{}"},
                                      {"--precision", "BPT_Precision", "", "{}"},
                                      {"--trees", "BPT_QT_Precomputed", "adaptive", "{} trees"},
                                      {"--resolution", "BPT_QT_ImgRes", "adaptive", "{} cells", "reject"},
                                      {"--factors", "BPT_Pdf_Factors_JK", "factored", "{} factors"}};

bool fail(std::string_view flag, const std::string& problem) {
  fmt::print(stderr, "error: {}: {}\n", flag, problem);
  return false;
}

std::vector<std::string> words_of(const options::OptionInfo& option, const std::string& text) {
  const std::size_t x = text.find('x');
  if (options::word_count(option) != 2 || x == std::string::npos) return {text};
  return {text.substr(0, x), text.substr(x + 1)};
}

void join(std::string& name, const std::string& part) { name += (name.empty() ? "" : ", ") + part; }

/// Returns the scheme of a line as given, completed by the options of that scheme.
std::optional<grf::PdfModel> complete_scheme(const CostLine& line) {
  auto model = options::scheme_model(line.options);
  if (!model || !line.scheme) return model;
  for (const grf::Argument& argument : line.scheme->arguments) {
    const auto same = [&](const grf::Argument& other) {
      return grf::same_keyword(other.name, argument.name);
    };
    std::erase_if(model->arguments, same);
    model->arguments.push_back(argument);
  }
  return model;
}

bool check_scheme(const grf::PdfModel& model, grf::Diagnostics& diagnostics) {
  return grf::check(model, reflectance::scheme_infos(), "PDF", diagnostics);
}

/// Sets the scheme of a line from a word of BPT_Pdf_Name or from the text of a PDF.
bool set_scheme(const std::string& text, CostLine& line) {
  line.pdf = text;
  const options::OptionInfo& option = *options::find_option("BPT_Pdf_Name");
  if (!set_option(line.options, option, {text})) return true;
  grf::Diagnostics diagnostics;
  line.scheme = grf::read_pdf(text, std::string(PdfFlag), diagnostics);
  const bool is_right = line.scheme && check_scheme(*line.scheme, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (is_right) line.options.scheme = line.scheme->keyword;
  return is_right;
}

bool belongs_to(const AxisOption& axis, const CostLine& line) {
  if (axis.scheme.empty()) return true;
  const auto model = complete_scheme(line);
  if (!model || !grf::same_keyword(model->keyword, axis.scheme)) return false;
  return axis.mode.empty() ||
         std::any_of(model->arguments.begin(), model->arguments.end(), [&](const grf::Argument& argument) {
           const auto* word = std::get_if<grf::Word>(&argument.value);
           return word != nullptr && grf::same_keyword(word->text, axis.mode);
         });
}

/// Returns the `--pdf` that the given axes imply; empty: any.
std::string implied_scheme(const Sweeps& sweeps) {
  std::string implied;
  for (const AxisOption& axis : AxisOptions) {
    if (axis.scheme.empty() || sweeps.count(std::string(axis.flag)) == 0) continue;
    const std::string scheme =
        axis.mode.empty() ? std::string(axis.scheme) : fmt::format("{} mode={}", axis.scheme, axis.mode);
    // A scheme with a mode is more specific.
    if (implied.empty() || scheme.starts_with(implied)) {
      implied = scheme;
    } else if (!implied.starts_with(scheme)) {
      join(implied, scheme);
    }
  }
  return implied;
}

using Lines = std::vector<CostLine>;

bool divide_by_scheme(const std::string& list, Lines& lines) {
  const CostLine base = lines.front();
  lines.clear();
  const std::vector<std::string> schemes = split_list(list);
  for (const std::string& scheme : schemes) {
    CostLine line = base;
    if (!set_scheme(scheme, line)) return false;
    if (schemes.size() > 1) line.name = scheme;
    lines.push_back(std::move(line));
  }
  return true;
}

std::string name_of(const AxisOption& axis, const std::string& value) {
  std::string name = fmt::format(fmt::runtime(axis.name_text), value);
  if (value == "1" && name.ends_with('s')) name.pop_back();
  return name;
}

/// Appends a copy of the line per value.
bool divide(const AxisOption& axis, const std::vector<std::string>& values, const CostLine& line,
            Lines& divided) {
  const options::OptionInfo& option = *options::find_option(axis.key);
  for (const std::string& value : values) {
    CostLine copy = line;
    const auto problem = set_option(copy.options, option, words_of(option, value));
    if (problem) return fail(axis.flag, *problem);
    if (values.size() > 1) join(copy.name, name_of(axis, value));
    divided.push_back(std::move(copy));
  }
  return true;
}

bool divide(const AxisOption& axis, const std::string& list, Lines& lines) {
  const std::vector<std::string> values = split_list(list);
  Lines divided;
  bool has_use = false;
  for (const CostLine& line : lines) {
    if (!belongs_to(axis, line)) {
      divided.push_back(line);
      continue;
    }
    has_use = true;
    if (!divide(axis, values, line, divided)) return false;
  }
  if (!has_use) {
    return fail(axis.flag, fmt::format("no scheme in --pdf uses it, expected {}{}", axis.scheme,
                                       axis.mode.empty() ? "" : fmt::format(" mode={}", axis.mode)));
  }
  lines = std::move(divided);
  return true;
}

/// Reports duplicate lines.
bool are_different(const Lines& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!grf::same_keyword(lines[i].name, lines[k].name)) continue;
      fmt::print(stderr, "error: '{}' would be measured twice: remove the duplicate\n", lines[i].name);
      return false;
    }
  }
  return true;
}

}  // namespace

const std::vector<SweepAxis>& sweep_axes() {
  static const std::vector<SweepAxis> axes = {
      {PdfFlag, "A,B,...",
       "sampling schemes: words of BPT_Pdf_Name, or PDFs as in a scene, such as \"hemisphere exp=50\""},
      {"--integrator", "naive,path", "integrators; with naive, all camera rays go through pixel centres"},
      {"--depth", "1,2,...", "path depths; the reference has the greatest of these and the scene's"},
      {"--branches", "1,2,...", "ways from the first hit, for path"},
      {"--points", "sobol,independent", "samplers"},
      {"--precision", "float,double", "precisions of BRDF evaluation"},
      {"--trees", "30,90,...", "numbers of quadtrees over theta, for Disk (adaptive)"},
      {"--resolution", "64,256,...", "cells along an edge of the disc's grid, for \"adaptive mode=reject\""},
      {"--factors", "2x1,4x4,...", "numbers of factors J and K, for Factored"},
  };
  return axes;
}

std::string key_of(const CostLine& line) {
  const RenderOptions& options = line.options;
  return fmt::format("{}; {} depth {} ways {} {} {}", line.scheme ? grf::to_text(*line.scheme) : "scene",
                     options.integrator, options.depth, options.split_count, options.points,
                     options.precision);
}

std::vector<std::string> op_lines_of(const CostLine& line) {
  std::vector<std::string> lines;
  if (options::scheme_model(line.options) != line.scheme) return lines;
  for (const options::OptionInfo& option : options::option_table()) {
    const bool is_of_line =
        option.key == "BPT_Pdf_Name" || std::ranges::any_of(AxisOptions, [&](const AxisOption& axis) {
          return axis.key == option.key && belongs_to(axis, line);
        });
    if (!is_of_line) continue;
    std::string text(option.key);
    for (const std::string& word : options::option_words(line.options, option)) text += " " + word;
    if (text != option.key) lines.push_back(std::move(text));
  }
  return lines;
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> words(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == ',' && depth <= 0) {
      words.emplace_back();
    } else if (c != ' ' || !words.back().empty()) {
      words.back() += c;
    }
  }
  for (std::string& word : words) word.erase(word.find_last_not_of(' ') + 1);
  return words;
}

std::optional<std::vector<CostLine>> cost_lines(const Sweeps& sweeps, const RenderOptions& render_options) {
  Lines lines(1);
  lines[0].options = render_options;
  lines[0].pdf = render_options.scheme.empty() ? "scene" : render_options.scheme;
  const auto pdf = sweeps.find(std::string(PdfFlag));
  const std::string schemes = pdf != sweeps.end() ? pdf->second : implied_scheme(sweeps);
  if (!schemes.empty() && !divide_by_scheme(schemes, lines)) return std::nullopt;
  for (const AxisOption& axis : AxisOptions) {
    const auto list = sweeps.find(std::string(axis.flag));
    if (list != sweeps.end() && !divide(axis, list->second, lines)) return std::nullopt;
  }
  if (!are_different(lines)) return std::nullopt;
  for (CostLine& line : lines) {
    line.scheme = complete_scheme(line);
    if (line.name.empty()) line.name = line.pdf;
  }
  return lines;
}

std::optional<std::vector<int>> sample_counts(const std::string& list) {
  std::vector<int> counts;
  for (const std::string& word : split_list(list)) {
    int count = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    const bool is_number = error == std::errc() && end == word.data() + word.size() && count > 0;
    if (!is_number || (!counts.empty() && count <= counts.back())) {
      fail("--samples",
           fmt::format("found '{}', expected ascending whole numbers over 0, separated by commas", word));
      return std::nullopt;
    }
    counts.push_back(count);
  }
  return counts;
}

}  // namespace command
