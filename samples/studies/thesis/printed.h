// The tables of the thesis' chapter 5, as `tables.json` has them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace study {

struct PrintedRow {
  std::string name;       ///< as printed
  std::string technique;  ///< what this study calls the same; of tables 5.19 and 5.20, the material
  std::vector<double> values;
};

struct PrintedTable {
  std::string number, title, unit;
  std::vector<std::string> columns;
  std::vector<int> samples;  ///< the columns, where they are numbers of samples; else empty
  std::vector<PrintedRow> rows;
  std::vector<double> means;       ///< of the columns, where they are printed
  std::vector<std::string> notes;  ///< what is wrong in print

  /// Nothing where the thesis has no such figure.
  std::optional<double> value(std::string_view technique, int count) const;
};

class Printed {
 public:
  explicit Printed(std::vector<PrintedTable> tables) : tables_(std::move(tables)) {}
  /// There must be one.
  const PrintedTable& table(std::string_view number) const;
  const std::vector<PrintedTable>& tables() const { return tables_; }

 private:
  std::vector<PrintedTable> tables_;
};

/// Nothing after an error.
std::optional<Printed> read_printed(const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace study
