#include "renderer/reflectance/measurements/csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "grf/text_file.h"

namespace reflectance {
namespace {

using Imath::V3d;

/// A cell of a CSV line and its column in characters from 1.
struct Cell {
  std::string_view text;
  std::uint32_t column = 1;
};

std::vector<Cell> split_cells(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::size_t first = begin;
    std::size_t last = end;
    const auto is_blank = [&](std::size_t at) {
      return line[at] == ' ' || line[at] == '\t' || line[at] == '\r';
    };
    while (first < last && is_blank(first)) ++first;
    while (last > first && is_blank(last - 1)) --last;
    cells.push_back({line.substr(first, last - first), static_cast<std::uint32_t>(first + 1)});
    begin = end + 1;
  }
  return cells;
}

enum Column {
  ThetaU,
  PhiU,
  ThetaV,
  PhiV,
  Ux,
  Uy,
  Uz,
  Vx,
  Vy,
  Vz,
  R,
  G,
  B,
  Value,
  Weight,
  Deviation,
  Columns
};
constexpr std::array<std::string_view, Columns> Names = {
    "theta_u", "phi_u", "theta_v", "phi_v", "ux", "uy",    "uz",     "vx",
    "vy",      "vz",    "r",       "g",     "b",  "value", "weight", "deviation"};
constexpr std::string_view Degrees = "_deg";

/// A column by its name, and whether it has degrees.
struct NamedColumn {
  Column column = Columns;  ///< `Columns` if it is unknown
  bool in_degrees = false;
};

NamedColumn column_of(std::string_view name) {
  NamedColumn named;
  named.in_degrees = name.ends_with(Degrees);
  if (named.in_degrees) name.remove_suffix(Degrees.size());
  constexpr std::array<std::pair<std::string_view, Column>, 4> Others = {
      {{"theta_o", ThetaU}, {"phi_o", PhiU}, {"theta_i", ThetaV}, {"phi_i", PhiV}}};
  for (const auto& [other, column] : Others) {
    if (other == name) named.column = column;
  }
  for (std::size_t i = 0; i < Columns; ++i) {
    if (Names[i] == name) named.column = static_cast<Column>(i);
  }
  if (named.in_degrees && named.column > PhiV) named.column = Columns;
  return named;
}

/// Takes the next line off a text.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

bool says_nothing(std::string_view line) {
  return line.starts_with('#') || line.find_first_not_of(" \t\r") == std::string_view::npos;
}

void skip_byte_order_mark(std::string_view& text) {
  if (text.starts_with(grf::ByteOrderMark)) text.remove_prefix(grf::ByteOrderMark.size());
}

/// Reads the lines of a CSV file one after the other.
class CsvReader {
 public:
  CsvReader(const std::string& path, grf::Diagnostics& diagnostics)
      : file_(grf::whole_file(path)), diagnostics_(diagnostics) {}

  std::optional<std::vector<Measurement>> read(std::string_view text) {
    skip_byte_order_mark(text);
    while (!text.empty()) {
      const std::string_view line = take_line(text);
      ++line_;
      if (says_nothing(line)) continue;
      const std::vector<Cell> cells = split_cells(line);
      const bool was_read = columns_.empty() ? read_names(cells) : read_values(cells);
      if (!was_read) return std::nullopt;
    }
    if (columns_.empty()) {
      line_ = 0;
      fail(0, fmt::format("the file is empty; its first line names the columns: {}", Hint));
      return std::nullopt;
    }
    return std::move(list_);
  }

 private:
  static constexpr std::string_view Hint =
      "theta_u,phi_u,theta_v,phi_v in radians (theta_u_deg in degrees) or ux,uy,uz,vx,vy,vz, then r,g,b or "
      "value, and perhaps weight or deviation";

  static std::array<double, Columns> all_radians() {
    std::array<double, Columns> units = {};
    units.fill(1);
    return units;
  }

  bool fail(std::uint32_t column, const std::string& message) {
    grf::SourceLocation location = file_;
    location.line = line_;
    location.column = column;
    diagnostics_.error(location, message);
    return false;
  }

  bool has(Column column) const { return at_[column] >= 0; }

  bool read_names(const std::vector<Cell>& cells) {
    at_.fill(-1);
    for (const Cell& cell : cells) {
      const auto [known, in_degrees] = column_of(cell.text);
      if (known == Columns)
        return fail(cell.column, fmt::format("unknown column '{}'; columns are {}", cell.text, Hint));
      if (at_[known] >= 0) return fail(cell.column, fmt::format("the column '{}' is repeated", cell.text));
      at_[known] = static_cast<int>(columns_.size());
      columns_.push_back(known);
      if (in_degrees) unit_[known] = std::numbers::pi / 180;
    }
    const auto has_all = [&](Column first, Column last) {
      int found = 0;
      for (int column = first; column <= last; ++column) found += has(static_cast<Column>(column)) ? 1 : 0;
      return found == last - first + 1;
    };
    const auto has_any = [&](Column first, Column last) {
      for (int column = first; column <= last; ++column) {
        if (has(static_cast<Column>(column))) return true;
      }
      return false;
    };
    if (!(has_all(ThetaU, PhiV) && !has_any(Ux, Vz)) && !(has_all(Ux, Vz) && !has_any(ThetaU, PhiV)))
      return fail(1, fmt::format("the columns of two directions are missing or mixed; columns are {}", Hint));
    if (!(has_all(R, B) && !has(Value)) && !(has(Value) && !has_any(R, B)))
      return fail(1, fmt::format("the columns of the value are missing or mixed; columns are {}", Hint));
    if (has(Weight) && has(Deviation))
      return fail(1, "there is both a weight and a deviation; one has to do");
    return true;
  }

  bool read_values(const std::vector<Cell>& cells) {
    if (cells.size() != columns_.size()) {
      const std::size_t last = std::min(cells.size(), columns_.size() + 1) - 1;
      return fail(cells[last].column,
                  fmt::format("the line has {} values, and the first line names {} columns", cells.size(),
                              columns_.size()));
    }
    std::array<double, Columns> values = {};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string_view text = cells[i].text;
      double& value = values[columns_[i]];
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size()) {
        return fail(cells[i].column,
                    fmt::format("'{}' is no number, in the column '{}'", text, Names[columns_[i]]));
      }
    }
    for (const auto& [column, least_meaning] : {std::pair(Weight, "a weight is 0 or more"),
                                                std::pair(Deviation, "a standard deviation is over 0")}) {
      if (!has(column)) continue;
      const double value = values[column];
      if (value > 0 || std::isnan(value) || (value == 0 && column == Weight)) continue;
      return fail(cells[static_cast<std::size_t>(at_[column])].column, least_meaning);
    }
    return add(values, cells);
  }

  bool add(const std::array<double, Columns>& values, const std::vector<Cell>& cells) {
    Measurement one;
    if (has(ThetaU)) {
      const auto angle = [&](Column column) { return values[column] * unit_[column]; };
      one.u = direction_at(angle(ThetaU), angle(PhiU));
      one.v = direction_at(angle(ThetaV), angle(PhiV));
    } else {
      one.u = V3d(values[Ux], values[Uy], values[Uz]);
      one.v = V3d(values[Vx], values[Vy], values[Vz]);
      for (const auto& [vector, column] : {std::pair(one.u, Ux), std::pair(one.v, Vx)}) {
        if (vector != V3d(0)) continue;
        return fail(cells[static_cast<std::size_t>(at_[column])].column, "a direction has no length");
      }
      one.u.normalize();
      one.v.normalize();
    }
    one.value = has(Value) ? V3d(values[Value]) : V3d(values[R], values[G], values[B]);
    if (has(Weight)) one.weight = values[Weight];
    one.deviation = values[Deviation];
    one.line = line_;
    list_.push_back(one);
    return true;
  }

  grf::SourceLocation file_;
  grf::Diagnostics& diagnostics_;
  std::uint32_t line_ = 0;
  std::vector<Column> columns_;       ///< in the order of the file
  std::array<int, Columns> at_ = {};  ///< the place of each column in the file, or -1
  std::array<double, Columns> unit_ = all_radians();
  std::vector<Measurement> list_;
};

}  // namespace

bool sniff_csv(std::string_view text) {
  skip_byte_order_mark(text);
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (says_nothing(line)) continue;
    const std::vector<Cell> cells = split_cells(line.substr(0, 1000));
    return cells.size() > 4 && std::all_of(cells.begin(), cells.end(), [](const Cell& cell) {
             return column_of(cell.text).column != Columns;
           });
  }
  return false;
}

std::optional<std::vector<Measurement>> parse_csv(std::string_view text, const std::string& path,
                                                  grf::Diagnostics& diagnostics) {
  return CsvReader(path, diagnostics).read(text);
}

}  // namespace reflectance
