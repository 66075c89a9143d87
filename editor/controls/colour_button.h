#pragma once

#include <QPointer>
#include <QTimer>
#include <QToolButton>
#include <optional>

#include "grf/math.h"

class QColorDialog;

namespace editor {

/// Converts a linear colour for the screen: colours with components over 1 are scaled down. And back.
QColor shown_colour(const grf::Colour& linear);
grf::Colour linear_colour(const QColor& shown);

/// A swatch of a linear RGB colour. A click opens a modeless colour chooser beside the window. For a colour
/// brighter than the screen can show, such as a radiance, the chosen colour is scaled up by the same factor.
class ColourButton : public QToolButton {
  Q_OBJECT

 public:
  explicit ColourButton(QWidget* parent = nullptr);
  ~ColourButton() override;

  /// Sets the colour, without a signal; nothing for mixed values.
  void set_colour(const std::optional<grf::Colour>& colour);
  const std::optional<grf::Colour>& colour() const { return colour_; }

 signals:
  void changing(const grf::Colour& colour);  ///< while choosing
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
