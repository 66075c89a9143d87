#pragma once

#include <QWidget>
#include <vector>

#include "editor/appearance/theme.h"
#include "editor/image/screen_colours.h"

namespace editor {

/// The colour scale of false colours in cd/m2, or of signed differences.
class ScaleBar : public QWidget {
  Q_OBJECT

 public:
  explicit ScaleBar(QWidget* parent = nullptr);

  void set_settings(const ScreenSettings& settings);

  QSize sizeHint() const override { return {9 * Grid, 20 * Grid}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Tick {
    double fraction;  ///< fraction of the height, from below
    QString label;
  };
  std::vector<Tick> ticks() const;
  QColor colour_at(double fraction) const;

  ScreenSettings settings_;
  ScreenColours colours_;
};

}  // namespace editor
