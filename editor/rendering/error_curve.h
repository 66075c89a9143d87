#pragma once

#include <QStackedWidget>
#include <optional>
#include <vector>

#include "renderer/plot/svg.h"

class QCustomPlot;

namespace editor {

/// How the estimated error of a render falls with time, on a logarithmic scale, and the target that it is to
/// reach.
class ErrorCurve : public QStackedWidget {
  Q_OBJECT

 public:
  explicit ErrorCurve(QWidget* parent = nullptr);

  void clear();
  /// In the order of time, seconds. Errors that are not over 0 are left out.
  void add(double seconds, double error);
  /// Nothing: there is none.
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
  std::optional<double> target_;     ///< in percent
};

}  // namespace editor
