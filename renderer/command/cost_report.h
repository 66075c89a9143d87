// What a study of cost has found, for people and for programs.
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
  double build_seconds = 0;  ///< of the scheme's tables
  std::size_t bytes = 0;     ///< that they hold
  std::vector<CostRow> rows;
  CostFit fit;

  /// Rendering and building tables until the error is 1 %; nothing if the error does not fall.
  std::optional<double> seconds_for_1_percent() const;
};

struct CostResult {
  std::string scene;
  int width = 0;
  int height = 0;
  int threads = 0;
  int rounds = 0;
  bool has_centred_rays = false;  ///< all rays from the eye go through the middles of pixels
  std::string reference_path;     ///< empty: it was rendered
  int reference_samples = 0;
  int reference_depth = 0;
  double reference_seconds = 0;
  std::optional<double> reference_error;  ///< sqrt(relMSE); nothing if that is not known
  std::vector<CostLineResult> lines;
};

/// One object, as `--json` prints it; after lines of progress in one line.
std::string json_of(const CostResult& result, bool is_one_line);

/// The rows in columns and the fits in words.
std::string text_of(const CostResult& result);

/// Writes BASE.csv, BASE.md and BASE.svg.
bool write_cost_files(const CostResult& result, const std::string& base, grf::Diagnostics& diagnostics);

}  // namespace command
