#pragma once

#include <QPolygonF>
#include <utility>

namespace editor {

/// A selection box or lasso that the pointer draws, in logical pixels.
class RegionGesture {
 public:
  void begin(const QPointF& at, bool is_lasso) {
    start_ = at;
    is_lasso_ = is_lasso;
    polygon_.clear();
    if (is_lasso) polygon_ << at;
  }
  void extend(const QPointF& to) {
    if (is_lasso_) {
      polygon_ << to;
    } else {
      polygon_ = QPolygonF(QRectF(start_, to).normalized());
    }
  }
  const QPolygonF& polygon() const { return polygon_; }
  /// Ends the gesture. The polygon has fewer than three corners if nothing was drawn.
  QPolygonF take() { return std::exchange(polygon_, {}); }

 private:
  QPointF start_;
  bool is_lasso_ = false;
  QPolygonF polygon_;
};

}  // namespace editor
