// The dark and the light theme have a palette each, and share one accent colour.
#pragma once

#include <QColor>

class QApplication;
class QPalette;

namespace editor {

enum class Theme { Dark, Light };

/// The layout grid: sizes are multiples of this many device-independent pixels.
inline constexpr int Grid = 8;

/// Colours of plots, the 3D view and icons.
struct ThemeColours {
  QColor window;      ///< background of controls
  QColor base;        ///< background of text, plots and the 3D view
  QColor text;        ///< contrast with `base` 7:1 or more
  QColor faint_text;  ///< of less importance, 4.5:1 or more
  QColor line;        ///< axes, grids and borders
  QColor accent;      ///< the selection, in the 3D view too
  QColor warning;
  QColor error;
};

ThemeColours colours_of(Theme theme);

/// The colour of a plot's curve by its number, distinct for the colour-blind (Okabe and Ito, 2008).
QColor series_colour(Theme theme, int number);

/// Applies a style like Qt's Fusion, with the palette of a theme.
void apply(Theme theme, QApplication& application);

/// The theme of a palette.
Theme theme_of(const QPalette& palette);

}  // namespace editor
