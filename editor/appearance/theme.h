// How the editor looks: one palette for dark, one for light, and one accent colour.
#pragma once

#include <QColor>

class QApplication;
class QPalette;

namespace editor {

enum class Theme { Dark, Light };

/// Sizes are multiples of this many device-independent pixels.
inline constexpr int Grid = 8;

/// What plots, the 3D view and icons draw with.
struct ThemeColours {
  QColor window;      ///< behind controls
  QColor base;        ///< behind text, plots and the 3D view
  QColor text;        ///< contrast with `base` 7:1 or more
  QColor faint_text;  ///< of less importance, 4.5:1 or more
  QColor line;        ///< axes, grids and borders
  QColor accent;      ///< the selection, in the 3D view too
  QColor warning;
  QColor error;
};

ThemeColours colours_of(Theme theme);

/// Colours of lines in one plot, apart for the colour-blind too (Okabe and Ito, 2008), by their number.
QColor series_colour(Theme theme, int number);

/// A style like Qt's Fusion, with the palette of a theme.
void apply(Theme theme, QApplication& application);

/// The theme that a palette belongs to.
Theme theme_of(const QPalette& palette);

}  // namespace editor
