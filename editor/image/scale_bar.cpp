#include "editor/image/scale_bar.h"

#include <QPainter>
#include <cmath>

namespace editor {
namespace {

QString text_of(double value) { return QString::number(value, 'g', 5); }

}  // namespace

ScaleBar::ScaleBar(QWidget* parent) : QWidget(parent), colours_(settings_) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  setAccessibleName(tr("Colour scale"));
}

void ScaleBar::set_settings(const ScreenSettings& settings) {
  settings_ = settings;
  colours_ = ScreenColours(settings);
  setToolTip(
      settings.colouring == Colouring::Signed
          ? tr("Signed difference: luminance of the image minus that of the reference, W/(sr m2).")
      : settings.is_radiance
          ? tr("Luminance in cd/m2: the luminance of the radiance, times %1 lm/W.").arg(CandelasPerWatt)
      : settings.is_relative_error ? tr("Relative standard error of the pixels.")
                                   : tr("Values of the layer; of three channels their luminance."));
  update();
}

std::vector<ScaleBar::Tick> ScaleBar::ticks() const {
  if (settings_.colouring == Colouring::Signed) {
    const double largest = colours_.scale().highest();
    return {{0, text_of(-largest)}, {0.5, "0"}, {1, "+" + text_of(largest)}};
  }
  const double unit = settings_.is_radiance ? CandelasPerWatt : settings_.is_relative_error ? 100 : 1;
  const double low = colours_.scale().lowest() * unit;
  const double high = colours_.scale().highest() * unit;
  const double range = std::log10(high / low);
  std::vector<Tick> ticks;
  for (double power = std::floor(std::log10(low)); std::pow(10, power) <= high; ++power) {
    for (const int factor : {1, 2, 5}) {
      const double value = factor * std::pow(10, power);
      if (value < low || value > high || (factor > 1 && range > 2)) continue;
      ticks.push_back({std::log10(value / low) / range, text_of(value)});
    }
  }
  return ticks;
}

QColor ScaleBar::colour_at(double fraction) const {
  if (settings_.colouring == Colouring::Signed) {
    const auto value = static_cast<float>((2 * fraction - 1) * colours_.scale().highest());
    return colours_(grf::Colour(value));
  }
  const plot::ColourScale& scale = colours_.scale();
  return colours_.false_colour(scale.lowest() * std::pow(scale.highest() / scale.lowest(), fraction));
}

void ScaleBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColours colours = colours_of(theme_of(palette()));
  const int text = fontMetrics().height();
  painter.setPen(colours.faint_text);
  const QString unit = settings_.colouring == Colouring::Signed ? tr("A - B")
                       : settings_.is_radiance                  ? tr("cd/m2")
                       : settings_.is_relative_error            ? tr("error, %")
                                                                : tr("value");
  painter.drawText(QRect(0, 0, width(), text), Qt::AlignHCenter, unit);
  const QRectF bar(Grid, 2.0 * text, 2.0 * Grid, height() - 3.0 * text);
  constexpr int Strips = 128;
  for (int i = 0; i < Strips; ++i) {
    const double top = bar.bottom() - bar.height() * (i + 1) / Strips;
    painter.fillRect(QRectF(bar.left(), top, bar.width(), bar.height() / Strips + 1),
                     colour_at((i + 0.5) / Strips));
  }
  painter.setPen(colours.text);
  for (const Tick& tick : ticks()) {
    const double y = bar.bottom() - bar.height() * tick.fraction;
    painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 4, y));
    painter.drawText(QRectF(bar.right() + 6, y - text / 2.0, width() - bar.right() - 6, text),
                     Qt::AlignVCenter | Qt::AlignLeft, tick.label);
  }
}

}  // namespace editor
