#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "grf/math.h"

namespace editor {

class ColourButton;
class NumberBox;

/// Three number fields for linear RGB values of at least 0, and a button with a colour chooser.
class ColourFields : public QWidget {
  Q_OBJECT

 public:
  /// `name` is the name of the coloured thing, `help` its meaning and unit.
  ColourFields(const QString& name, const QString& help, double maximum, QWidget* parent = nullptr);

  void show_colour(const grf::Colour& colour);
  /// Shows an empty field, or `mixed`.
  void show_blank(const QString& text);
  const std::optional<grf::Colour>& colour() const { return colour_; }
  /// The first number field, which takes the keyboard focus.
  QWidget* field() const;

 signals:
  void edited(const grf::Colour& colour);
  void finished();

 private:
  void take(int channel, double number);
  void take_colour(const grf::Colour& colour);

  std::optional<grf::Colour> colour_;
  std::array<NumberBox*, 3> channels_{};
  ColourButton* button_;
};

}  // namespace editor
