// A colour scale maps numbers to colours.
#pragma once

#include "grf/math.h"
#include "renderer/plot/chart.h"
#include "renderer/plot/svg.h"

namespace plot {

/// A logarithmic colour map from light yellow by green to dark blue. Its lightness is monotonic, so that the
/// colour-blind and grey prints can read it (YlGnBu of Harrower and Brewer 2003, "ColorBrewer.org").
class ColourScale {
 public:
  /// Rounds the limits to 1, 2 or 5 times a power of ten, one to four decades apart; values below have the
  /// lightest colour. A largest value of 0 gives 0.1 to 1.
  ColourScale(double least, double largest);

  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

  /// Returns the colour of a value, sRGB-encoded, 0 to 1.
  grf::Colour colour(double value) const;

 private:
  double lowest_ = 0.1;
  double highest_ = 1;
};

/// Draws a vertical colour bar with values at its right.
void draw(const ColourScale& scale, const Rectangle& place, Svg& svg);

/// A linear colour map, whose lightness tells more from less.
class LinearColourScale {
 public:
  enum class Palette {
    Sequential,  ///< the colours of `ColourScale`
    Diverging,   ///< blue, white, red, for values about a middle (RdBu of ColorBrewer.org)
  };

  /// Takes the values of the first and the last colour; values beyond have those.
  LinearColourScale(double lowest, double highest, Palette palette);

  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

  /// Returns the colour of a value, sRGB-encoded, 0 to 1.
  grf::Colour colour(double value) const;

 private:
  double lowest_;
  double highest_;
  Palette palette_;
};

/// Draws a vertical colour bar with values at its right, five of them.
void draw(const LinearColourScale& scale, const Rectangle& place, Svg& svg);

}  // namespace plot
