#pragma once

#include <QSlider>
#include <QTimer>

namespace editor {

/// How slider positions map to a range.
enum class SliderScale { Linear, Logarithmic };

/// A horizontal slider over real numbers. A click beside the handle moves it there.
class ScaledSlider : public QSlider {
  Q_OBJECT

 public:
  explicit ScaledSlider(QWidget* parent = nullptr);

  /// Sets the range. A logarithmic scale that begins at 0 or below is linear near 0, under a millionth of the
  /// maximum.
  void set_range(double minimum, double maximum, SliderScale scale);
  /// Makes the numbers integers, of which a key or the wheel reaches each.
  void set_whole(bool is_whole) { is_whole_ = is_whole; }
  /// Sets the number, without a signal. Numbers out of range are shown at the end.
  void set_number(double number);
  double number() const { return number_; }

 signals:
  void changing(double number);  ///< while dragging
  void edited(double number);    ///< once, on release

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  double number_at(int position) const;
  int position_of(double number) const;
  void move_to(int position);
  void finish();

  double minimum_ = 0;
  double maximum_ = 1;
  double number_ = 0;
  SliderScale scale_ = SliderScale::Linear;
  bool is_whole_ = false;
  bool is_updating_ = false;  // the position follows a number that was set
  bool has_moved_ = false;
  QTimer settling_;  // of keys and wheel
};

}  // namespace editor
