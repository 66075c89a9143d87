// Measurements of the study.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "samples/studies/thesis/subjects.h"

namespace study {

/// The measurements of one image by `bpt cost`.
struct Row {
  std::string scene;
  std::string brdf;        ///< of table 5.5, a material, or that of the scene
  std::string technique;   ///< see subjects.h
  std::string integrator;  ///< naive or path
  int samples = 0;         ///< per pixel; for naive, secondary rays
  double build = 0;        ///< build time of the tables, seconds
  double sampling = 0;     ///< time spent sampling directions, seconds, sum over threads
  double render = 0;       ///< render time, seconds, without `build`
  double error = 0;        ///< the thesis' average relative error, 1 is 100 %
  double relmse = 0;
  double bytes = 0;  ///< size of the tables

  double total() const { return build + render; }
};

/// A filter of rows; an empty string or 0 matches any.
struct RowFilter {
  std::string_view scene = {}, brdf = {}, technique = {}, integrator = {};
  int samples = 0;
};

using Quantity = std::function<double(const Row&)>;

// Quantities of a row: sampling and build times in seconds, and the error in percent.
inline double sampling(const Row& row) { return row.sampling; }
inline double build(const Row& row) { return row.build; }
inline double percent(const Row& row) { return 100 * row.error; }

class Results {
 public:
  std::vector<Row> rows;
  std::map<std::string, double> exponents;  ///< of `hemisphere-best`, per BRDF of table 5.5
  std::string machine, command;
  Effort effort;
  bool is_whole = true;  ///< without `--only`
  bool has_merl = false;

  bool has(std::string_view scene) const { return !select({scene}).empty(); }
  std::vector<const Row*> select(const RowFilter& filter) const;
  /// Returns the mean over the BRDFs; nothing if there is no such row.
  std::optional<double> mean(const RowFilter& filter, const Quantity& quantity) const;
  /// Returns the sample counts in ascending order.
  std::vector<int> counts(const RowFilter& filter) const;
  /// Returns the distinct names in the order of the rows.
  std::vector<std::string> names(const RowFilter& filter, std::string Row::*name) const;
};

/// Writes one line per row.
std::string csv(const Results& results);
/// Parses the text of `csv`; throws on any other.
std::vector<Row> rows_of_csv(const std::string& text);

}  // namespace study
