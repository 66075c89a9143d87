// The tables of the thesis' chapter 5 are read from `tables.json`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace study {

struct PrintedRow {
  std::string name;       ///< as printed
  std::string technique;  ///< the name in this study; in tables 5.19 and 5.20, the material
  std::vector<double> values;
};

struct PrintedTable {
  std::string number, title, unit;
  std::vector<std::string> columns;
  std::vector<int> samples;  ///< sample counts, if these are the columns; else empty
  std::vector<PrintedRow> rows;
  std::vector<double> means;       ///< of the columns, if printed
  std::vector<std::string> notes;  ///< misprints

  /// Returns a value; nothing if the thesis does not have it.
  std::optional<double> value(std::string_view technique, int count) const;
};

class PrintedTables {
 public:
  explicit PrintedTables(std::vector<PrintedTable> tables) : tables_(std::move(tables)) {}
  /// Returns a table, which must exist.
  const PrintedTable& table(std::string_view number) const;
  const std::vector<PrintedTable>& tables() const { return tables_; }

 private:
  std::vector<PrintedTable> tables_;
};

/// Reads `tables.json`; nothing after an error.
std::optional<PrintedTables> read_printed(const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace study
