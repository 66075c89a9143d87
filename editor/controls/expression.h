// Numbers as people type them: arithmetic, and units.
#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace editor {

/// A word that may stand behind a number, and what it multiplies it by.
struct Unit {
  QString name;
  double factor = 1;
};

/// What may be typed where a value is in that unit, the unit itself first: `rad` and `deg` for angles, `W`,
/// `mW` and `kW` for power, `nm` and `um` for lengths that small. Of any other word, it alone; of none, none.
std::vector<Unit> units_like(const QString& unit);

struct Typed {
  std::optional<double> value;  ///< finite
  QString error;                ///< why there is no value, in a sentence for the person who typed
};

/// The value of `0.2*3`, `sqrt(2)/pi` or `20deg`. Decimals have a point.
Typed value_of(const QString& text, const std::vector<Unit>& units);

/// A value as a box shows it: up to seven digits, which is what a float has.
QString number_text(double value);

}  // namespace editor
