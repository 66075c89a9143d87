#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "grf/math.h"

namespace editor {

class ColourButton;
class NumberBox;

/// Three numbers R, G and B, linear, of at least 0, and a button that shows the colour and lets it be chosen.
class ColourFields : public QWidget {
  Q_OBJECT

 public:
  /// The name says what has the colour, the help its meaning and unit.
  ColourFields(const QString& name, const QString& help, double maximum, QWidget* parent = nullptr);

  void show_colour(const grf::Colour& colour);
  /// Shows that there is none, or `mixed`.
  void show_blank(const QString& text);
  const std::optional<grf::Colour>& colour() const { return colour_; }
  /// The first of the numbers, where typing begins.
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
