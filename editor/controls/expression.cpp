#include "editor/controls/expression.h"

#include <cmath>
#include <numbers>

#include <muParser.h>

namespace editor {
namespace {

/// A unit as a function for muParser, one for each factor in use.
template <int Numerator, int Denominator>
double scaled(double x) {
  return x * Numerator / Denominator;
}
double radians_of(double degrees) { return degrees * std::numbers::pi / 180; }

using Scale = double (*)(double);

Scale scale_of(double factor) {
  if (factor == 1) return scaled<1, 1>;
  if (factor == 1e3) return scaled<1000, 1>;
  if (factor == 1e-3) return scaled<1, 1000>;
  if (factor == 1e6) return scaled<1000000, 1>;
  return radians_of;
}

constexpr double Degree = std::numbers::pi / 180;

QString explained(const mu::ParserError& error, const QString& text) {
  if (text.contains(',') && !text.contains('(')) return "Use a point as the decimal separator, as in 0.5.";
  return QString::fromStdString(error.GetMsg());
}

}  // namespace

std::vector<Unit> units_like(const QString& unit) {
  if (unit == "rad") return {{"rad", 1}, {"deg", Degree}};
  if (unit == "deg") return {{"deg", 1}};
  if (unit == "W") return {{"W", 1}, {"mW", 1e-3}, {"kW", 1e3}};
  if (unit == "nm") return {{"nm", 1}, {"um", 1e3}, {"mm", 1e6}};
  if (unit == "um") return {{"um", 1}, {"nm", 1e-3}, {"mm", 1e3}};
  if (unit.isEmpty()) return {};
  return {{unit, 1}};
}

Typed value_of(const QString& text, const std::vector<Unit>& units) {
  QString expression = text.trimmed();
  if (expression.isEmpty()) return {{}, "Type a number."};
  expression.replace(QChar(0xb0), "deg");
  expression.replace(QChar(0xb5), "u");
  expression.replace(QChar(0xd7), "*");
  mu::Parser parser;
  try {
    parser.DefineConst("pi", std::numbers::pi);
    for (const Unit& unit : units) parser.DefinePostfixOprt(unit.name.toStdString(), scale_of(unit.factor));
    parser.SetExpr(expression.toStdString());
    const double value = parser.Eval();
    if (parser.GetNumResults() != 1) return {{}, "Use a point as the decimal separator, as in 0.5."};
    if (!std::isfinite(value)) return {{}, "The value must be a finite number."};
    return {value, {}};
  } catch (const mu::ParserError& error) {
    return {{}, explained(error, text)};
  }
}

QString number_text(double value) { return QString::number(value, 'g', 7); }

}  // namespace editor
