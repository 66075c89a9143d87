#include "editor/controls/colour_button.h"

#include <QColorDialog>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/controls/gesture.h"
#include "grf/srgb.h"

namespace editor {
namespace {

float encoded(float linear) { return grf::srgb_encoded(std::clamp(linear, 0.0F, 1.0F)); }

/// The factor by which a colour exceeds what the screen can show.
float brightness(const grf::Colour& linear) { return std::max({1.0F, linear.x, linear.y, linear.z}); }

}  // namespace

QColor shown_colour(const grf::Colour& linear) {
  const grf::Colour within = linear / brightness(linear);
  return QColor::fromRgbF(encoded(within.x), encoded(within.y), encoded(within.z));
}

grf::Colour linear_colour(const QColor& shown) {
  const QColor rgb = shown.toRgb();
  return {grf::srgb_decoded(rgb.redF()), grf::srgb_decoded(rgb.greenF()), grf::srgb_decoded(rgb.blueF())};
}

ColourButton::ColourButton(QWidget* parent) : QToolButton(parent) {
  setFixedSize(3 * Grid, 3 * Grid);
  settling_.setSingleShot(true);
  settling_.setInterval(SettlingMilliseconds);
  connect(&settling_, &QTimer::timeout, this, &ColourButton::finish);
  connect(this, &QToolButton::clicked, this, &ColourButton::choose);
}

ColourButton::~ColourButton() { delete chooser_; }

void ColourButton::set_colour(const std::optional<grf::Colour>& colour) {
  if (colour == colour_) return;
  colour_ = colour;
  scale_ = brightness(colour.value_or(grf::Colour(1)));
  if (chooser_ && colour) {
    const QSignalBlocker silent(chooser_);
    chooser_->setCurrentColor(shown_colour(*colour));
  }
  update();
}

void ColourButton::choose() {
  if (!chooser_) {
    chooser_ = new QColorDialog(window());
    chooser_->setAttribute(Qt::WA_DeleteOnClose);
    chooser_->setOptions(QColorDialog::NoButtons | QColorDialog::DontUseNativeDialog);
    chooser_->setWindowFlag(Qt::Tool);
    chooser_->setModal(false);
    chooser_->setWindowTitle(accessibleName().isEmpty() ? tr("Colour") : accessibleName());
    chooser_->setCurrentColor(shown_colour(colour_.value_or(grf::Colour(0.5F))));
    connect(chooser_, &QColorDialog::currentColorChanged, this, &ColourButton::take);
    connect(chooser_, &QDialog::finished, this, &ColourButton::finish);
  }
  chooser_->show();
  chooser_->raise();
}

// Colours that come back during a choice are the chosen ones: the scale is kept.
void ColourButton::take(const QColor& shown) {
  colour_ = linear_colour(shown) * scale_;
  has_changed_ = true;
  update();
  settling_.start();
  emit changing(*colour_);
}

void ColourButton::finish() {
  settling_.stop();
  if (!has_changed_ || !colour_) return;
  has_changed_ = false;
  emit edited(*colour_);
}

void ColourButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColours colours = colours_of(theme_of(palette()));
  const QRectF swatch = QRectF(rect()).adjusted(2.5, 2.5, -2.5, -2.5);
  painter.setPen(QPen(hasFocus() ? colours.accent : colours.line, hasFocus() ? 2 : 1));
  if (colour_) {
    painter.setBrush(isEnabled() ? shown_colour(*colour_) : colours.window);
    painter.drawRoundedRect(swatch, 3, 3);
    return;
  }
  painter.setBrush(QBrush(colours.faint_text, Qt::BDiagPattern));
  painter.drawRoundedRect(swatch, 3, 3);
}

}  // namespace editor
