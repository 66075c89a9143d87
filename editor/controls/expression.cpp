#include "editor/controls/expression.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

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

template <int Numerator, int Denominator>
constexpr std::pair<double, Scale> ScaleBy = {double(Numerator) / Denominator,
                                              scaled<Numerator, Denominator>};

Scale scale_of(double factor) {
  static constexpr std::pair<double, Scale> Scales[] = {
      ScaleBy<1, 1>,     ScaleBy<10, 1>,    ScaleBy<1, 10>,      ScaleBy<100, 1>,    ScaleBy<1, 100>,
      ScaleBy<1000, 1>,  ScaleBy<1, 1000>,  ScaleBy<1000000, 1>, ScaleBy<254, 10>,   ScaleBy<10, 254>,
      ScaleBy<254, 100>, ScaleBy<100, 254>, ScaleBy<254, 10000>, ScaleBy<10000, 254>};
  const auto* found = std::ranges::find(Scales, factor, &std::pair<double, Scale>::first);
  return found == std::end(Scales) ? radians_of : found->second;
}

/// Units of length with their size in 0.1 mm, so that quotients are exact.
constexpr std::pair<const char*, int> Lengths[] = {{"m", 10000}, {"cm", 100}, {"mm", 10}, {"in", 254}};

/// Zero for other units.
int tenths_of_millimetre(const QString& unit) {
  const auto* found = std::ranges::find_if(Lengths, [&](const auto& each) { return unit == each.first; });
  return found == std::end(Lengths) ? 0 : found->second;
}

constexpr double Degree = std::numbers::pi / 180;

QString explained(const mu::ParserError& error, const QString& text) {
  if (text.contains(',') && !text.contains('('))
    return QCoreApplication::translate("editor::NumberBox",
                                       "Use a point as the decimal separator, as in 0.5.");
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
  std::vector<Unit> units = {{unit, 1}};
  if (const int own_size = tenths_of_millimetre(unit); own_size > 0) {
    for (const auto& [name, size] : Lengths) {
      if (unit != name) units.push_back({name, double(size) / own_size});
    }
  }
  return units;
}

double length_unit(const QString& unit) { return tenths_of_millimetre(unit) / 10000.0; }

Typed value_of(const QString& text, const std::vector<Unit>& units) {
  QString expression = text.trimmed();
  if (expression.isEmpty()) return {{}, QCoreApplication::translate("editor::NumberBox", "Type a number.")};
  expression.replace(QChar(0xb0), "deg");
  expression.replace(QChar(0xb5), "u");
  expression.replace(QChar(0xd7), "*");
  mu::Parser parser;
  try {
    parser.DefineConst("pi", std::numbers::pi);
    for (const Unit& unit : units) parser.DefinePostfixOprt(unit.name.toStdString(), scale_of(unit.factor));
    parser.SetExpr(expression.toStdString());
    const double value = parser.Eval();
    if (parser.GetNumResults() != 1)
      return {{},
              QCoreApplication::translate("editor::NumberBox",
                                          "Use a point as the decimal separator, as in 0.5.")};
    if (!std::isfinite(value))
      return {{}, QCoreApplication::translate("editor::NumberBox", "The value must be a finite number.")};
    return {value, {}};
  } catch (const mu::ParserError& error) {
    return {{}, explained(error, text)};
  }
}

QString number_text(double value) { return QString::number(value, 'g', 7); }

}  // namespace editor
