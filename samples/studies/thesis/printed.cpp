#include "samples/studies/thesis/printed.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"

namespace study {
namespace {

using nlohmann::json;

PrintedTable table_of(const json& data) {
  PrintedTable table;
  data.at("number").get_to(table.number);
  data.at("title").get_to(table.title);
  data.at("unit").get_to(table.unit);
  for (const json& column : data.at("columns")) {
    if (column.is_number()) table.samples.push_back(column);
    table.columns.push_back(column.is_number() ? column.dump() : column.get<std::string>());
  }
  for (const json& row : data.at("rows")) {
    table.rows.push_back({row.at("name"), row.at("technique"), row.at("values")});
    if (table.rows.back().values.size() != table.columns.size()) {
      throw std::runtime_error("table " + table.number + ": a row has more or fewer values than columns");
    }
  }
  if (data.contains("means")) data.at("means").get_to(table.means);
  data.at("notes").get_to(table.notes);
  return table;
}

}  // namespace

std::optional<double> PrintedTable::value(std::string_view technique, int count) const {
  const auto column = std::find(samples.begin(), samples.end(), count);
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const PrintedRow& one) { return one.technique == technique; });
  if (column == samples.end() || row == rows.end()) return std::nullopt;
  return row->values[static_cast<std::size_t>(column - samples.begin())];
}

const PrintedTable& PrintedTables::table(std::string_view number) const {
  for (const PrintedTable& table : tables_) {
    if (table.number == number) return table;
  }
  throw std::out_of_range(fmt::format("there is no table {}", number));
}

std::optional<PrintedTables> read_printed(const std::string& path, grf::Diagnostics& diagnostics) {
  const auto text = grf::read_file(path, diagnostics);
  if (!text) return std::nullopt;
  try {
    std::vector<PrintedTable> tables;
    const json file = json::parse(*text);
    for (const json& data : file.at("tables")) tables.push_back(table_of(data));
    return PrintedTables(std::move(tables));
  } catch (const std::exception& error) {
    diagnostics.error(grf::whole_file(path), error.what());
    return std::nullopt;
  }
}

}  // namespace study
