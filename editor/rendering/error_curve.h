#pragma once

#include <QPointF>
#include <QWidget>
#include <optional>
#include <vector>

namespace editor {

/// How the estimated error of a render falls with time, on a logarithmic scale, and the target that it is to
/// reach.
class ErrorCurve : public QWidget {
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
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Range {
    double least = 0;
    double most = 0;
  };
  Range error_range() const;
  QPointF place(const QRectF& area, const Range& errors, double seconds, double error) const;
  void draw_frame(QPainter& painter, const QRectF& area, const Range& errors) const;

  std::vector<QPointF> points_;  ///< seconds, error
  std::optional<double> target_;
};

}  // namespace editor
