#include "samples/studies/thesis/tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "samples/studies/markdown.h"
#include "samples/studies/sampling/cases.h"
#include "samples/studies/sampling/technique.h"

namespace study {
namespace {

/// Formats a sample count, as 10² for 100.
std::string count_text(int count) {
  const auto root = static_cast<int>(std::lround(std::sqrt(count)));
  return root * root == count && count > 1 ? fmt::format("{}²", root) : fmt::format("{}", count);
}

std::string cell(const std::optional<double>& value) { return value ? figure(*value) : ""; }

void add_today(Table& table, const PrintedTable& printed, const Content& content, std::string_view technique,
               const Results& results) {
  for (const std::string_view integrator : {"naive", "path"}) {
    const RowFilter line = {content.scene, {}, technique, integrator};
    if (results.select(line).empty()) continue;
    std::vector<std::string> row = {fmt::format("`{}`, {}", technique, integrator)};
    for (const int count : printed.samples) {
      row.push_back(cell(results.mean({content.scene, {}, technique, integrator, count}, content.quantity)));
    }
    table.add(row);
  }
}

struct Column {
  std::string_view technique;
  Quantity quantity;
  std::string_view title = {};  ///< of columns that the thesis does not have
};
using Columns = std::vector<Column>;

/// Writes a row of the thesis' and today's figures per material, and their means over the measured ones.
std::string material_table(const PrintedTable& printed, const Columns& columns, const Results& results) {
  std::vector<std::string> header = {"material"};
  for (const std::string& column : printed.columns) {
    header.push_back(column + ", thesis");
    header.emplace_back("today");
  }
  for (std::size_t i = printed.columns.size(); i < columns.size(); ++i) {
    header.emplace_back(columns[i].title);
  }
  Table table(header);
  const auto add = [&](const std::string& name, std::string_view material,
                       const std::vector<double>& thesis) {
    std::vector<std::string> row = {name};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i < thesis.size()) row.push_back(figure(thesis[i]));
      row.push_back(
          cell(results.mean({"measured", material, columns[i].technique, "naive"}, columns[i].quantity)));
    }
    table.add(row);
  };
  for (const PrintedRow& row : printed.rows) {
    if (!results.select({"measured", row.technique}).empty()) add(row.name, row.technique, row.values);
  }
  add("mean (thesis: of all)", {}, printed.means);
  return table.str();
}

}  // namespace

bool is_glossy(std::string_view brdf) {
  const auto text_of = [&]() -> std::string {
    for (const Case& one : cases()) {
      if (one.name == brdf) return one.brdf;
    }
    for (const Material& one : materials()) {
      if (one.name == brdf) return one.brdf;
    }
    return {};
  };
  const std::string text = text_of();
  return text.empty() || has_glossy_part(brdf_of(text));
}

std::string sweep_table(const PrintedTable& printed, const Content& content, const Results& results) {
  std::vector<std::string> header = {printed.unit};
  for (const int count : printed.samples) header.push_back(count_text(count));
  Table table(header);
  for (const PrintedRow& row : printed.rows) {
    std::vector<std::string> cells = {row.name + ", thesis"};
    for (const double value : row.values) cells.push_back(figure(value));
    table.add(cells);
    add_today(table, printed, content, row.technique, results);
  }
  for (const std::string_view technique : content.more)
    add_today(table, printed, content, technique, results);
  return table.str();
}

std::string precomputation_table(const PrintedTable& printed, const Results& results) {
  const Quantity seconds = [](const Row& row) { return row.build; };
  const Quantity kilobytes = [](const Row& row) { return row.bytes / 1024; };
  return material_table(printed,
                        {{"cascade", seconds},
                         {"compressed", seconds},
                         {"reject", seconds},
                         {"cascade", kilobytes},
                         {"compressed", kilobytes},
                         {"reject", kilobytes},
                         {"warp", seconds, "`warp`, s"},
                         {"warp", kilobytes, "`warp`, KB"}},
                        results);
}

std::string material_times_table(const PrintedTable& printed, const Results& results) {
  const Quantity seconds = [](const Row& row) { return row.sampling; };
  const Quantity percent = [](const Row& row) { return 100 * row.error; };
  return material_table(printed,
                        {{"uniform", seconds},
                         {"cascade", seconds},
                         {"compressed", seconds},
                         {"reject", seconds},
                         {"warp", seconds, "`warp`, s"},
                         {"uniform", percent, "error, %: `uniform`"},
                         {"cascade", percent, "`cascade`"},
                         {"compressed", percent, "`compressed`"},
                         {"reject", percent, "`reject`"},
                         {"warp", percent, "`warp`"}},
                        results);
}

std::string notes(const PrintedTable& printed) {
  std::string text;
  for (const std::string& note : printed.notes) text += "- In print: " + note + "\n";
  return text.empty() ? text : "\n" + text;
}

}  // namespace study
