#include "editor/controls/scaled_slider.h"

#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "editor/controls/gesture.h"

namespace editor {
namespace {

constexpr int Positions = 1000;

/// The value below which a logarithmic scale is linear.
double knee(double minimum, double maximum) {
  return minimum > 0 ? 0 : std::max(std::abs(minimum), maximum) * 1e-6;
}

/// Rounds to three digits: dragging is not more precise, and files stay readable.
double rounded(double number) {
  if (number == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(number))) - 2);
  return std::round(number / unit) * unit;
}

}  // namespace

ScaledSlider::ScaledSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, Positions);
  setSingleStep(Positions / 100);
  setPageStep(Positions / 10);
  setFocusPolicy(Qt::StrongFocus);
  settling_.setSingleShot(true);
  settling_.setInterval(SettlingMilliseconds);
  connect(&settling_, &QTimer::timeout, this, &ScaledSlider::finish);
  connect(this, &QSlider::valueChanged, this, &ScaledSlider::move_to);
  connect(this, &QSlider::sliderReleased, this, &ScaledSlider::finish);
}

void ScaledSlider::set_range(double minimum, double maximum, SliderScale scale) {
  minimum_ = minimum;
  maximum_ = maximum;
  scale_ = scale;
  set_number(number_);
}

void ScaledSlider::set_number(double number) {
  const QScopedValueRollback updating(is_updating_, true);
  number_ = number;
  if (!isSliderDown()) setValue(position_of(number));
}

double ScaledSlider::number_at(int position) const {
  if (position <= 0) return minimum_;
  if (position >= Positions) return maximum_;
  const double share = static_cast<double>(position) / Positions;
  if (scale_ == SliderScale::Linear) return rounded(minimum_ + share * (maximum_ - minimum_));
  const double k = knee(minimum_, maximum_);
  if (k > 0) return rounded(minimum_ + k * std::expm1(share * std::log1p((maximum_ - minimum_) / k)));
  return rounded(minimum_ * std::pow(maximum_ / minimum_, share));
}

int ScaledSlider::position_of(double number) const {
  const double inside = std::clamp(number, minimum_, maximum_);
  const double k = knee(minimum_, maximum_);
  double share = 0;
  if (scale_ == SliderScale::Linear) {
    share = (inside - minimum_) / (maximum_ - minimum_);
  } else if (k > 0) {
    share = std::log1p((inside - minimum_) / k) / std::log1p((maximum_ - minimum_) / k);
  } else {
    share = std::log(inside / minimum_) / std::log(maximum_ / minimum_);
  }
  return static_cast<int>(std::lround(share * Positions));
}

void ScaledSlider::move_to(int position) {
  if (is_updating_) return;
  double next = number_at(position);
  if (is_whole_) next = std::round(next);
  if (is_whole_ && !isSliderDown() && next == number_)
    next = std::clamp(next + (position > position_of(number_) ? 1 : -1), minimum_, maximum_);
  number_ = next;
  has_moved_ = true;
  emit changing(number_);
  if (!isSliderDown()) settling_.start();
}

void ScaledSlider::finish() {
  settling_.stop();
  if (!has_moved_) return;
  has_moved_ = false;
  emit edited(number_);
}

void ScaledSlider::mousePressEvent(QMouseEvent* event) {
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
  const QPoint point = event->position().toPoint();
  if (event->button() == Qt::LeftButton && !handle.contains(point)) {
    const QRect groove = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
    setValue(QStyle::sliderValueFromPosition(0, Positions, point.x() - groove.x() - handle.width() / 2,
                                             groove.width() - handle.width(), option.upsideDown));
    settling_.stop();  // the release ends the gesture
  }
  QSlider::mousePressEvent(event);
}

void ScaledSlider::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  QSlider::wheelEvent(event);
}

}  // namespace editor
