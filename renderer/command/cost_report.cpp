#include "renderer/command/cost_report.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/command/cost_chart.h"
#include "renderer/command/json_values.h"
#include "renderer/command/render_progress.h"

namespace command {
namespace {

using nlohmann::ordered_json;

constexpr double OnePercent = 0.01;

ordered_json json_of_line(const CostLineResult& result) {
  const options::RenderOptions& options = result.line.options;
  ordered_json json;
  json["line"] = result.line.name;
  json["pdf"] = result.line.pdf;
  json["integrator"] = options.integrator;
  json["depth"] = options.depth;
  json["branches"] = options.split_count;
  json["points"] = options.points;
  json["precision"] = options.precision;
  return json;
}

ordered_json json_of_row(const CostLineResult& result, const CostRow& row) {
  ordered_json json = json_of_line(result);
  json["samples"] = row.samples;
  json["build_seconds"] = result.build_seconds;
  json["sampling_seconds"] = row.sampling_seconds;
  json["render_seconds"] = row.render_seconds;
  json["average_relative_error"] = number_or_null(row.average_relative_error);
  json["relmse"] = row.relmse;
  json["efficiency"] = number_or_null(row.efficiency());
  json["bytes"] = result.bytes;
  json["seeds"] = row.seeds;
  json["rounds"] = ordered_json::array();
  for (const CostRound& round : row.rounds) {
    json["rounds"].push_back({{"render_seconds", round.seconds}, {"relmse", round.relmse}});
  }
  json["settings"] = key_of(result.line);
  return json;
}

ordered_json json_of_efficiency(const std::optional<CostEfficiency>& efficiency) {
  if (!efficiency) return nullptr;
  return {{"value", efficiency->value}, {"low", efficiency->low}, {"high", efficiency->high}};
}

std::optional<double> factor_of(const std::optional<PowerLaw>& law) {
  return law ? std::optional(law->factor) : std::nullopt;
}

std::optional<double> exponent_of(const std::optional<PowerLaw>& law) {
  return law ? std::optional(law->exponent) : std::nullopt;
}

ordered_json json_of_fit(const CostLineResult& result) {
  ordered_json json = json_of_line(result);
  json["exponent"] = number_or_null(exponent_of(result.fit.over_seconds));
  json["exponent_over_samples"] = number_or_null(exponent_of(result.fit.over_samples));
  json["seconds_for_1_percent"] = number_or_null(result.seconds_for_1_percent());
  json["rows_used"] = result.fit.used.size();
  json["factor"] = number_or_null(factor_of(result.fit.over_seconds));
  json["factor_over_samples"] = number_or_null(factor_of(result.fit.over_samples));
  json["efficiency"] = json_of_efficiency(result.efficiency);
  json["op"] = op_lines_of(result.line);
  json["grf"] = result.line.scheme ? ordered_json(grf::to_text(*result.line.scheme)) : ordered_json(nullptr);
  return json;
}

ordered_json json_of_crop(const std::optional<transport::CropWindow>& crop) {
  if (!crop) return nullptr;
  return {crop->x, crop->y, crop->width, crop->height};
}

ordered_json json_of_reference(const CostResult& result) {
  ordered_json json;
  json["path"] = result.reference_path.empty() ? ordered_json(nullptr) : ordered_json(result.reference_path);
  const bool is_rendered = result.reference_path.empty();
  json["digest"] = is_rendered ? ordered_json(nullptr) : ordered_json(result.reference_digest);
  json["samples"] = is_rendered ? ordered_json(result.reference_samples) : ordered_json(nullptr);
  json["depth"] = is_rendered ? ordered_json(result.reference_depth) : ordered_json(nullptr);
  json["seconds"] = is_rendered ? ordered_json(result.reference_seconds) : ordered_json(nullptr);
  json["error"] = number_or_null(result.reference_error);
  json["image"] =
      result.reference_image.empty() ? ordered_json(nullptr) : ordered_json(result.reference_image);
  return json;
}

// Reports as text and Markdown.

std::string percent(const std::optional<double>& fraction) {
  return fraction ? fmt::format("{:.3g} %", 100 * *fraction) : "none";
}

/// Formats times with two digits below a second: studies of small images take less than a tenth of one.
std::string time_text(double seconds) {
  return seconds < 1 ? fmt::format("{:.2g} s", seconds) : duration_text(seconds);
}

/// Describes a fit as text.
std::string words_of(const CostLineResult& result) {
  const auto& law = result.fit.over_seconds;
  if (!law) return "too few rows to fit a curve.";
  const auto seconds = law->inverse(OnePercent);
  if (!seconds) return "the error does not fall with time.";
  std::string words = fmt::format("half the error costs {:.1f} times the time; 1 % error takes about {}",
                                  std::pow(2, 1 / law->exponent), time_text(*result.seconds_for_1_percent()));
  words += " on this machine";
  if (result.build_seconds >= OnePercent * *seconds) {
    words += fmt::format(", {} of that for building tables", time_text(result.build_seconds));
  }
  const double first = result.rows.front().render_seconds;
  const double last = result.rows.back().render_seconds;
  if (*seconds < first || *seconds > last) words += " (extrapolated)";
  return words + fmt::format(". error = {:.3g} t^-{:.3f}", law->factor, law->exponent) +
         (result.fit.over_samples
              ? fmt::format(", and N^-{:.3f} over samples", result.fit.over_samples->exponent)
              : "") +
         ".";
}

/// Names the line that wins, or says that there is none. A study of one line has nothing to compare.
std::string words_of_winner(const CostResult& result) {
  if (result.lines.size() < 2) return "";
  if (!result.winner) {
    return "No clear winner: the 95 % intervals of the efficiencies overlap, or are not known (they need two "
           "rounds and rows well above the error of the reference).\n";
  }
  return fmt::format("{} is the most efficient: its 95 % interval is above those of all others.\n",
                     result.lines[*result.winner].line.name);
}

std::string words_of_efficiency(const CostLineResult& result) {
  if (!result.efficiency) return "";
  return fmt::format(" Efficiency {:.3g}, 95 % interval {:.3g} to {:.3g}.", result.efficiency->value,
                     result.efficiency->low, result.efficiency->high);
}

std::string words_of_reference(const CostResult& result) {
  if (!result.reference_path.empty()) {
    return fmt::format("The reference is {}, whose own error is unknown and not subtracted.",
                       grf::file_name(result.reference_path));
  }
  return fmt::format(
      "The reference has {} samples per pixel by `path` with other seeds, depth {}; its own error is {}, "
      "which is subtracted before curves are fitted, and rows with less than twice that error are left out "
      "of "
      "the fits.",
      result.reference_samples, result.reference_depth, percent(result.reference_error));
}

std::string words_of_measures(const CostResult& result) {
  std::string words =
      fmt::format("{}x{} pixels{}, {} thread{}, ", result.width, result.height,
                  result.crop ? fmt::format(", of which {}x{} from {},{}", result.crop->width,
                                            result.crop->height, result.crop->x, result.crop->y)
                              : "",
                  result.conditions.threads, result.conditions.threads == 1 ? "" : "s");
  words += result.rounds == 1
               ? "each row rendered once. "
               : fmt::format("each row rendered {} times: the minimum of the times, the mean of the errors. ",
                             result.rounds);
  words += words_of_reference(result);
  if (result.conditions.has_centred_rays) words += " All camera rays go through pixel centres.";
  return words;
}

/// Returns the cells of a row, for text and Markdown.
std::vector<std::string> cells_of(const CostLineResult& result, const CostRow& row) {
  const auto number = [](double value) { return fmt::format("{:.4g}", value); };
  return {result.line.name,
          fmt::format("{}", row.samples),
          number(result.build_seconds),
          number(row.sampling_seconds),
          number(row.render_seconds),
          percent(row.average_relative_error),
          percent(row.error()),
          number(row.efficiency()),
          fmt::format("{}", result.bytes)};
}
const std::vector<std::string> Titles = {"line",       "samples",    "build s",
                                         "sampling s", "render s",   "average relative error",
                                         "error",      "efficiency", "bytes"};

std::string markdown_of(const CostResult& result, const std::string& picture) {
  std::string text = fmt::format("# Error against render time: {}\n\n{}\n\n![error over time]({})\n\n",
                                 grf::file_name(result.scene), words_of_measures(result), picture);
  for (const CostLineResult& one : result.lines) {
    text += fmt::format("- **{}**: {}{}\n", one.line.name, words_of(one), words_of_efficiency(one));
  }
  if (const std::string winner = words_of_winner(result); !winner.empty()) text += "\n" + winner;
  text += fmt::format("\n| {} |\n|---|{}\n", fmt::join(Titles, " | "),
                      "---:|---:|---:|---:|---:|---:|---:|---:|");
  for (const CostLineResult& one : result.lines) {
    for (const CostRow& row : one.rows) text += fmt::format("| {} |\n", fmt::join(cells_of(one, row), " | "));
  }
  return text +
         "\nSamples are per pixel; for `naive`, they are paths. The error is sqrt(relMSE), the efficiency 1 "
         "/ "
         "(relMSE x render s), and the time to 1 % error includes building tables. `sampling s` is the time "
         "that all threads together spend sampling directions, measured in a separate render.\n";
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_of(const CostResult& result) {
  std::string text =
      "line,pdf,integrator,depth,points,precision,samples,build_seconds,sampling_seconds,render_seconds,"
      "average_relative_error,relmse,efficiency,bytes\n";
  for (const CostLineResult& one : result.lines) {
    const options::RenderOptions& options = one.line.options;
    for (const CostRow& row : one.rows) {
      text += fmt::format(
          "{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{},{:.6g},{:.6g},{}\n", quoted(one.line.name),
          quoted(one.line.pdf), options.integrator, options.depth, options.points, options.precision,
          row.samples, one.build_seconds, row.sampling_seconds, row.render_seconds,
          row.average_relative_error ? fmt::format("{:.6g}", *row.average_relative_error) : "", row.relmse,
          row.efficiency(), one.bytes);
    }
  }
  return text;
}

}  // namespace

std::optional<double> CostLineResult::seconds_for_1_percent() const {
  const auto seconds = fit.over_seconds ? fit.over_seconds->inverse(OnePercent) : std::nullopt;
  return seconds ? std::optional(*seconds + build_seconds) : std::nullopt;
}

std::string json_of(const CostResult& result, bool is_one_line) {
  ordered_json json;
  json["scene"] = result.scene;
  json["width"] = result.width;
  json["height"] = result.height;
  json["threads"] = result.conditions.threads;
  json["has_centred_rays"] = result.conditions.has_centred_rays;
  json["crop"] = json_of_crop(result.crop);
  json["fingerprint"] = result.conditions.fingerprint;
  json["reference"] = json_of_reference(result);
  json["rows"] = ordered_json::array();
  json["fits"] = ordered_json::array();
  for (const CostLineResult& one : result.lines) {
    for (const CostRow& row : one.rows) json["rows"].push_back(json_of_row(one, row));
    json["fits"].push_back(json_of_fit(one));
  }
  json["winner"] =
      result.winner ? ordered_json(result.lines[*result.winner].line.name) : ordered_json(nullptr);
  return json_text(json, is_one_line) + "\n";
}

std::string text_of(const CostResult& result) {
  std::size_t width = Titles[0].size();
  for (const CostLineResult& one : result.lines) width = std::max(width, one.line.name.size());
  const auto line_of = [&](const std::vector<std::string>& cells) {
    std::string line = fmt::format("{:<{}}", cells[0], width);
    for (std::size_t i = 1; i < cells.size(); ++i) {
      line += fmt::format("  {:>{}}", cells[i], std::max<std::size_t>(10, Titles[i].size()));
    }
    return line + "\n";
  };
  std::string text = words_of_measures(result) + "\n\n" + line_of(Titles);
  for (const CostLineResult& one : result.lines) {
    for (const CostRow& row : one.rows) text += line_of(cells_of(one, row));
  }
  text += "\n";
  for (const CostLineResult& one : result.lines)
    text += fmt::format("{}: {}{}\n", one.line.name, words_of(one), words_of_efficiency(one));
  return text + words_of_winner(result);
}

bool write_cost_files(const CostResult& result, const std::string& base, grf::Diagnostics& diagnostics) {
  const std::string picture = grf::file_name(base) + ".svg";
  bool written = grf::replace_file(base + ".csv", csv_of(result), diagnostics);
  written &= grf::replace_file(base + ".json", json_of(result, false), diagnostics);
  written &= grf::replace_file(base + ".md", markdown_of(result, picture), diagnostics);
  return plot::write_picture(cost_chart(result), base + ".svg", diagnostics) && written;
}

}  // namespace command
