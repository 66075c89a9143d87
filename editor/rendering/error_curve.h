#pragma once

#include <QStackedWidget>
#include <optional>
#include <vector>

#include "renderer/plot/svg.h"

class QCustomPlot;

namespace editor {

/// Plots the estimated error of a render against time, on a logarithmic scale, with the target error.
class ErrorCurve : public QStackedWidget {
  Q_OBJECT

 public:
  explicit ErrorCurve(QWidget* parent = nullptr);

  void clear();
  /// Adds points in order of time, seconds. Errors that are not positive are left out.
  void add(double seconds, double error);
  /// Sets the target error; without a value there is none.
  void set_target(std::optional<double> error);
  std::size_t size() const { return points_.size(); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void draw();

  QCustomPlot* plot_;
  std::vector<plot::Point> points_;  ///< seconds, error in percent
  std::optional<double> target_;     ///< percent
};

}  // namespace editor
