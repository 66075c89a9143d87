#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "editor/rendering/render_report.h"

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace editor {

/// Shows what a render will cost: a button per target error, with the forecast time until the render reaches
/// it. A click chooses the target.
class ForecastRow : public QWidget {
  Q_OBJECT

 public:
  explicit ForecastRow(QWidget* parent = nullptr);

  void set_forecasts(const std::vector<ForecastTime>& times);
  const std::vector<ForecastTime>& forecasts() const { return times_; }
  /// Says that the scene or the options have changed, and that a new forecast is being made.
  void set_measuring();
  /// Says why there is no forecast.
  void set_problem(const QString& why);
  /// Marks the target error of the render options.
  void set_target(std::optional<double> error);

 signals:
  void target_chosen(double error);
  void became_visible();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void show_buttons();
  void add_button();
  void show_button(QToolButton& button, const ForecastTime& time);

  QLabel* label_;
  QHBoxLayout* row_;
  std::vector<QToolButton*> buttons_;
  std::vector<ForecastTime> times_;
  std::optional<double> target_;
};

/// Formats a forecast duration with two digits at most: `8 s`, `20 s`, `9 min`, `3 h`, `12 days`.
QString rough_duration_text(double seconds);

}  // namespace editor
