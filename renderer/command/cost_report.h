// The results of a cost study are reported as text, Markdown, CSV, JSON and a chart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/command/cost_efficiency.h"
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
  std::optional<CostEfficiency> efficiency;  ///< over all sample counts, see `efficiencies_of`

  /// Time to an error of 1 %, building tables included; nothing if the error does not fall.
  std::optional<double> seconds_for_1_percent() const;
};

/// Conditions under which rows of different runs can be compared.
struct CostConditions {
  std::string fingerprint;  ///< of the scene, the image and the program, without the settings of lines
  int threads = 0;
  bool has_centred_rays = false;  ///< all camera rays go through pixel centres
};

struct CostResult {
  std::string scene;
  int width = 0;
  int height = 0;
  std::optional<transport::CropWindow> crop;
  int rounds = 0;
  CostConditions conditions;
  std::string reference_path;    ///< empty: the reference was rendered
  std::string reference_digest;  ///< of a given reference, see `digest_of_image`
  std::string reference_image;   ///< file name of the rendered reference, beside the tables
  int reference_samples = 0;
  int reference_depth = 0;
  double reference_seconds = 0;
  std::optional<double> reference_error;  ///< sqrt(relMSE); nothing if unknown
  std::vector<CostLineResult> lines;
  std::optional<std::size_t> winner;  ///< index of the line that is clearly more efficient than all others
};

/// Returns the JSON object of `--json`, on one line for streams of JSON lines.
std::string json_of(const CostResult& result, bool is_one_line);

/// Returns the rows in columns and the fits in words.
std::string text_of(const CostResult& result);

/// Writes BASE.csv, BASE.md, BASE.svg and BASE.json.
bool write_cost_files(const CostResult& result, const std::string& base, grf::Diagnostics& diagnostics);

}  // namespace command
