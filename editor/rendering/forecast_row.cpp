#include "editor/rendering/forecast_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QShowEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"

namespace editor {
namespace {

/// The targets of a forecast, and the options' own one.
constexpr std::size_t MostButtons = 4;

bool is_same(double target, std::optional<double> other) {
  return other && std::abs(target - *other) < 1e-5 * target;
}

}  // namespace

ForecastRow::ForecastRow(QWidget* parent)
    : QWidget(parent),
      label_(new QLabel(this)),
      row_(new QHBoxLayout),
      times_{{0.05, {}, {}, {}}, {0.02, {}, {}, {}}, {0.01, {}, {}, {}}} {
  auto* column = tight_layout<QVBoxLayout>(this, 2);
  label_->setAccessibleName(tr("Forecast of the render time"));
  label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  column->addWidget(label_);
  row_->setSpacing(Grid / 2);
  column->addLayout(row_);
  set_measuring();
}

void ForecastRow::set_forecasts(const std::vector<ForecastTime>& times) {
  times_ = times;
  if (times_.size() > MostButtons) times_.resize(MostButtons);
  label_->setText(tr("Time until the image has an error of:"));
  label_->setToolTip(
      tr("Forecast from a short probe of the image on this machine, as if nothing else ran. The true time is "
         "in the interval with 90 % probability"));
  show_buttons();
}

void ForecastRow::set_measuring() {
  label_->setText(tr("Forecast: measuring how long a render takes…"));
  label_->setToolTip(tr("A short probe of the image runs in the background with the lowest priority"));
  show_buttons();
}

void ForecastRow::set_problem(const QString& why) {
  label_->setText(tr("No forecast: %1").arg(why.section('\n', 0, 0)));
  label_->setToolTip(why);
  for (ForecastTime& time : times_) time = {time.target_error, {}, {}, {}};
  show_buttons();
}

void ForecastRow::set_target(std::optional<double> error) {
  target_ = error;
  show_buttons();
}

void ForecastRow::show_buttons() {
  while (buttons_.size() < times_.size()) add_button();
  for (; buttons_.size() > times_.size(); buttons_.pop_back()) {
    buttons_.back()->hide();
    buttons_.back()->deleteLater();
  }
  for (std::size_t i = 0; i < buttons_.size(); ++i) show_button(*buttons_[i], times_[i]);
}

void ForecastRow::add_button() {
  auto* button = new QToolButton(this);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(button, &QToolButton::clicked, this, [this, i = buttons_.size()] {
    emit target_chosen(times_[i].target_error);
    show_buttons();  // a click on the current target does not unset it
  });
  row_->addWidget(button);
  buttons_.push_back(button);
}

void ForecastRow::show_button(QToolButton& button, const ForecastTime& time) {
  const QString target = percent_text(time.target_error);
  const auto text_of = [](const std::optional<double>& seconds) {
    return seconds ? rough_duration_text(*seconds) : tr("never");
  };
  const bool is_known = time.low.has_value();
  const QString low = text_of(time.low);
  const QString high = text_of(time.high);
  QString text = tr("%1: %2").arg(target, is_known ? text_of(time.seconds) : QStringLiteral("…"));
  if (is_known) text += "\n" + (low == high ? low : tr("%1 to %2").arg(low, high));
  button.setText(text);
  button.setMinimumHeight(2 * button.fontMetrics().lineSpacing() + Grid);
  button.setChecked(is_same(time.target_error, target_));
  button.setAccessibleName(tr("Render until an error of %1").arg(target));
  QString tip = tr("Set the target error to %1, without a limit of samples").arg(target);
  if (is_known) {
    tip = tr("The render takes %1, with 90 % probability %2 to %3, until its estimated error is %4.")
              .arg(text_of(time.seconds), low, high, target) +
          " " + tip;
  }
  button.setToolTip(tip);
  button.setAccessibleDescription(tip);
}

void ForecastRow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit became_visible();
}

QString rough_duration_text(double seconds) {
  const auto rounded = [](double value) {
    const double unit = value < 20 ? 1 : value < 60 ? 5 : 10;
    return QString::number(std::max(1.0, std::round(value / unit) * unit), 'f', 0);
  };
  constexpr double Minute = 60;
  constexpr double Hour = 60 * Minute;
  constexpr double Day = 24 * Hour;
  if (seconds < 1) return ForecastRow::tr("under 1 s");
  if (seconds < 1.5 * Minute) return ForecastRow::tr("%1 s").arg(rounded(seconds));
  if (seconds < 1.5 * Hour) return ForecastRow::tr("%1 min").arg(rounded(seconds / Minute));
  if (seconds < 2 * Day) return ForecastRow::tr("%1 h").arg(rounded(seconds / Hour));
  return ForecastRow::tr("%1 days").arg(rounded(seconds / Day));
}

}  // namespace editor
