// Parses typed numbers: arithmetic, and units.
#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace editor {

/// A unit suffix, and its conversion factor.
struct Unit {
  QString name;
  double factor = 1;
};

/// The units that can be typed for a value in `unit`, which comes first: `rad` and `deg` for angles, `W`,
/// `mW` and `kW` for power, `nm` and `um` for small lengths, `m`, `cm`, `mm` and `in` for others. Any other
/// unit has no alternatives.
std::vector<Unit> units_like(const QString& unit);

/// The unit `m`, `cm`, `mm` or `in` in metres.
double length_unit(const QString& unit);

struct Typed {
  std::optional<double> value;  ///< finite
  QString error;                ///< error message for the user, a sentence
};

/// Evaluates `0.2*3`, `sqrt(2)/pi` or `20deg`. The decimal separator is a point.
Typed value_of(const QString& text, const std::vector<Unit>& units);

/// Formats a value with up to seven digits, the precision of a float.
QString number_text(double value);

}  // namespace editor
