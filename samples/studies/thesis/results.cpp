#include "samples/studies/thesis/results.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

namespace study {
namespace {

constexpr std::string_view Heading =
    "scene,brdf,technique,integrator,samples,build_seconds,sampling_seconds,render_seconds,"
    "average_relative_error,relmse,bytes";

}  // namespace

std::vector<const Row*> Results::select(const RowFilter& filter) const {
  const auto fits = [](std::string_view wanted, std::string_view name) {
    return wanted.empty() || wanted == name;
  };
  std::vector<const Row*> selected;
  for (const Row& row : rows) {
    if (fits(filter.scene, row.scene) && fits(filter.brdf, row.brdf) &&
        fits(filter.technique, row.technique) && fits(filter.integrator, row.integrator) &&
        (filter.samples == 0 || filter.samples == row.samples)) {
      selected.push_back(&row);
    }
  }
  return selected;
}

std::optional<double> Results::mean(const RowFilter& filter, const Quantity& quantity) const {
  const std::vector<const Row*> selected = select(filter);
  if (selected.empty()) return std::nullopt;
  double sum = 0;
  for (const Row* row : selected) sum += quantity(*row);
  return sum / static_cast<double>(selected.size());
}

std::vector<int> Results::counts(const RowFilter& filter) const {
  std::set<int> counts;
  for (const Row* row : select(filter)) counts.insert(row->samples);
  return {counts.begin(), counts.end()};
}

std::vector<std::string> Results::names(const RowFilter& filter, std::string Row::*name) const {
  std::vector<std::string> names;
  for (const Row* row : select(filter)) {
    if (std::find(names.begin(), names.end(), row->*name) == names.end()) names.push_back(row->*name);
  }
  return names;
}

std::string csv(const Results& results) {
  std::string text = std::string(Heading) + "\n";
  for (const Row& row : results.rows) {
    text += fmt::format("{},{},{},{},{},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.0f}\n", row.scene, row.brdf,
                        row.technique, row.integrator, row.samples, row.build, row.sampling, row.render,
                        row.error, row.relmse, row.bytes);
  }
  return text;
}

std::vector<Row> rows_of_csv(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != Heading)
    throw std::runtime_error("rows.csv has an unknown header: run the study again");
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    Row row;
    words >> row.scene >> row.brdf >> row.technique >> row.integrator >> row.samples >> row.build >>
        row.sampling >> row.render >> row.error >> row.relmse >> row.bytes;
    if (!words) throw std::runtime_error("rows.csv has an incomplete row: run the study again");
    rows.push_back(row);
  }
  return rows;
}

}  // namespace study
