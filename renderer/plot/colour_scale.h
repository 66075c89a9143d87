// Colours for values over many powers of ten.
#pragma once

#include <string>

#include "grf/math.h"
#include "renderer/plot/chart.h"
#include "renderer/plot/svg.h"

namespace plot {

/// A logarithmic scale from light yellow by green to dark blue. Its lightness falls evenly, so it is read by
/// those who confuse colours too, and in grey (YlGnBu of Harrower and Brewer 2003, "ColorBrewer.org").
class ColourScale {
 public:
  /// From and to the next of 1, 2 or 5 times a power of ten, over one power at least and four at most; values
  /// under it have the lightest colour. A largest value of 0 gives 0.1 to 1.
  ColourScale(double least, double largest);

  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

  /// Encoded as sRGB has it, 0 to 1.
  grf::Colour colour(double value) const;

 private:
  double lowest_ = 0.1;
  double highest_ = 1;
};

/// A bar of the colours, upright, with values at its right.
void draw(const ColourScale& scale, const Place& place, Svg& svg);

/// `#rrggbb`.
std::string hexadecimal(const grf::Colour& encoded);

}  // namespace plot
