// A cost study is continued from its JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/command/cost_report.h"

namespace command {

/// A saved cost study has the rows and the reference that an earlier run measured.
struct SavedCost {
  /// The settings of a row's line, see `key_of`.
  struct Row {
    std::string key;
    CostRow row;  ///< its line index has no meaning yet
  };
  CostConditions conditions;
  std::string reference_image;   ///< path; empty: the reference was given
  std::string reference_digest;  ///< of a given reference, see `digest_of_image`
  int reference_samples = 0;
  double reference_seconds = 0;
  double reference_relmse = 0;
  std::vector<Row> rows;
};

/// Returns the digest of an image's pixels, by which studies know a reference that was given.
std::string digest_of_image(const image::Image& image);

/// Reads BASE.json of a study; nothing after an error.
std::optional<SavedCost> read_cost_study(const std::string& path, grf::Diagnostics& diagnostics);

/// Reports an error if rows measured under these conditions cannot be compared with those of the study.
bool check_conditions(const SavedCost& saved, const CostConditions& conditions, const std::string& path,
                      grf::Diagnostics& diagnostics);

}  // namespace command
