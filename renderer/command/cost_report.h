// The results of a cost study are reported as text, Markdown, CSV, JSON and a chart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/command/cost_fit.h"
#include "renderer/command/cost_lines.h"
#include "renderer/command/cost_sweep.h"

namespace command {

struct CostLineResult {
  CostLine line;
  double build_seconds = 0;  ///< build time of the scheme's tables
  std::size_t bytes = 0;     ///< size of these tables
  std::vector<CostRow> rows;
  CostFit fit;

  /// Time to an error of 1 %, building tables included; nothing if the error does not fall.
  std::optional<double> seconds_for_1_percent() const;
};

struct CostResult {
  std::string scene;
  int width = 0;
  int height = 0;
  int threads = 0;
  int rounds = 0;
  bool has_centred_rays = false;  ///< all camera rays go through pixel centres
  std::string reference_path;     ///< empty: the reference was rendered
  int reference_samples = 0;
  int reference_depth = 0;
  double reference_seconds = 0;
  std::optional<double> reference_error;  ///< sqrt(relMSE); nothing if unknown
  std::vector<CostLineResult> lines;
};

/// Returns the JSON object of `--json`, on one line for streams of JSON lines.
std::string json_of(const CostResult& result, bool is_one_line);

/// Returns the rows in columns and the fits in words.
std::string text_of(const CostResult& result);

/// Writes BASE.csv, BASE.md and BASE.svg.
bool write_cost_files(const CostResult& result, const std::string& base, grf::Diagnostics& diagnostics);

}  // namespace command
