#pragma once

#include <QPointer>
#include <QTimer>
#include <QToolButton>
#include <optional>

#include "grf/math.h"

class QColorDialog;

namespace editor {

/// A linear colour as screens want it: components over 1 are brought down together. And back.
QColor shown_colour(const grf::Colour& linear);
grf::Colour linear_colour(const QColor& shown);

/// A swatch of a linear RGB colour. A click opens a chooser beside the window, which is not modal. Of a
/// colour that is brighter than screens can show, say a radiance, the chosen one is brought up by as much as
/// that one was brought down.
class ColourButton : public QToolButton {
  Q_OBJECT

 public:
  explicit ColourButton(QWidget* parent = nullptr);
  ~ColourButton() override;

  /// Without a signal; nothing where several things differ.
  void set_colour(const std::optional<grf::Colour>& colour);
  const std::optional<grf::Colour>& colour() const { return colour_; }

 signals:
  void changing(const grf::Colour& colour);  ///< while somebody chooses
  void edited(const grf::Colour& colour);    ///< after a pause, and when the chooser is closed

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void choose();
  void take(const QColor& shown);
  void finish();

  std::optional<grf::Colour> colour_;
  float scale_ = 1;  // of the colour to what is shown
  bool has_changed_ = false;
  QPointer<QColorDialog> chooser_;
  QTimer settling_;
};

}  // namespace editor
