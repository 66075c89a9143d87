// What was measured.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "samples/studies/thesis/subjects.h"

namespace study {

/// One image: `bpt cost` measured it.
struct Row {
  std::string scene;
  std::string brdf;        ///< of table 5.5, a material, or what the scene has
  std::string technique;   ///< see subjects.h
  std::string integrator;  ///< naive or path
  int samples = 0;         ///< a pixel; of naive, secondary rays
  double build = 0;        ///< seconds, of the tables
  double sampling = 0;     ///< seconds of all threads, in which directions were drawn
  double render = 0;       ///< seconds, without `build`
  double error = 0;        ///< the thesis' average relative error, 1 is 100 %
  double relmse = 0;
  double bytes = 0;  ///< of the tables

  double total() const { return build + render; }
};

/// Which rows; what is empty or 0 is any.
struct Which {
  std::string_view scene = {}, brdf = {}, technique = {}, integrator = {};
  int samples = 0;
};

using Quantity = std::function<double(const Row&)>;

/// Quantities of a row: seconds of drawing and of building, and the error in percent.
inline double sampling(const Row& row) { return row.sampling; }
inline double build(const Row& row) { return row.build; }
inline double percent(const Row& row) { return 100 * row.error; }

class Results {
 public:
  std::vector<Row> rows;
  std::map<std::string, double> exponents;  ///< of `hemisphere-best`, by BRDF of table 5.5
  std::string machine, command;
  Effort effort;
  bool is_whole = true;  ///< no `--only`
  bool has_merl = false;

  bool has(std::string_view scene) const { return !select({scene}).empty(); }
  std::vector<const Row*> select(const Which& which) const;
  /// Over the BRDFs; nothing if there is no such row.
  std::optional<double> mean(const Which& which, const Quantity& quantity) const;
  /// In ascending order.
  std::vector<int> counts(const Which& which) const;
  /// Each once, in the order of the rows.
  std::vector<std::string> names(const Which& which, std::string Row::*name) const;
};

/// One line for each row.
std::string csv(const Results& results);
/// The rows that `csv` wrote; throws if the text is not from there.
std::vector<Row> rows_of_csv(const std::string& text);

}  // namespace study
