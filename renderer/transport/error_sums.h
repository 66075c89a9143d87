#pragma once

#include <cstddef>
#include <vector>

#include "grf/math.h"
#include "renderer/transport/tile_bounds.h"

namespace transport {

/// The number of a pixel's channels.
constexpr int PixelChannels = 3;

/// Error statistics of an image's pixels, to be summed over parts of the image. Errors are squared and
/// relative, as in relMSE, and taken per pixel and channel.
struct ErrorSums {
  double values = 0;  ///< pixels times channels
  /// Sum of the unbiased estimates of squared error, where the denominator is known.
  double errors = 0;
  /// Squares of what a pixel's channels add to `errors`: they measure how unevenly the error is spread.
  double squares = 0;

  /// Edge pixels: samples hit one of two objects of very different radiance.
  struct Edges {
    double errors = 0;    ///< squared errors, estimated from the pixels' halves
    double expected = 0;  ///< the same, of straight edges whose coverage is unknown
    double squares = 0;   ///< squares of what a pixel's channels add to `expected`
  } edges;

  /// Edge pixels that few samples have hit, so that their radiance is hardly known.
  struct Touched {
    double errors = 0;      ///< as if a pixel's own mean were its true radiance
    double logarithms = 0;  ///< log of their brightness relative to the dark side, times that error
    double bounds = 0;      ///< upper bound of one such pixel's squared error, times that error
    double unseen = 0;      ///< expected error of pixels at such edges that no sample has hit
  } touched;

  /// Outliers: values that stand out from all neighbours but one.
  struct Outliers {
    double count = 0;
    double agreement = 0;   ///< from 0, only one half is bright, to 1; summed over values
    double steady = 0;      ///< how many agree so well that every sample may hit them
    double on_black = 0;    ///< how many have a neighbour darker than the floor
    double own = 0;         ///< the squared error, if the pixels are as bright as they seem
    double neighbours = 0;  ///< the same, if they are as bright as their neighbours
  } outliers;

  ErrorSums& operator+=(const ErrorSums& other) { return add(other, 1); }
  ErrorSums operator-(const ErrorSums& other) const { return ErrorSums(*this).add(other, -1); }
  /// The sums of this many such images, or of this fraction of the image.
  ErrorSums operator*(double factor) const { return ErrorSums().add(*this, factor); }

 private:
  ErrorSums& add(const ErrorSums& other, double factor);
};

/// The mean of each pixel of a rectangle of an image, and the variance of that mean; row by row.
struct PixelMoments {
  TileBounds bounds;
  double samples = 0;  ///< per pixel
  std::vector<Imath::V3d> means;
  std::vector<Imath::V3d> variances;

  /// Returns the index of a pixel from its position in the image.
  std::size_t index_of(int x, int y) const { return bounds.index_of(x - bounds.x, y - bounds.y); }
  bool contains(int x, int y) const {
    return x >= bounds.x && x < bounds.x + bounds.width && y >= bounds.y && y < bounds.y + bounds.height;
  }
};

/// The radius, in pixels, of the neighbourhood that is used for a pixel's error.
constexpr int ErrorNeighbours = 7;

/// Sums the estimated errors of the pixels of `counted`, a rectangle within the given one; the pixels around
/// it, up to `ErrorNeighbours` to each side, serve to detect edges.
///
/// With a and b the means of a pixel's halves, x = (a + b) / 2 its value and t the truth, d = (a - b) / 2 has
/// the distribution of x - t. Moreover, d^2 differs from (x - t)^2 only by -(a - t)(b - t), which has mean 0
/// because the halves are independent, and variance 4 var(x)^2, however heavy the tails of a and b are. So
/// the numerator is unbiased. The denominator t^2 is the difficulty: a rare bright sample makes d and x large
/// together, and would excuse itself if d^2 were divided by x^2; but next to a lamp, the neighbours do not
/// represent a pixel. So t is estimated as
///
///     m + g (x - m),   g = 1 - 1.5 (sum of d^2) / (sum of (x - m)^2), at least 0,
///
/// with the neighbours' mean m and sums over the pixel and its neighbours: an empirical Bayes estimate, which
/// shrinks from the pixel's own value, where the contrast exceeds the noise, to the neighbours' mean, where
/// all differences are noise (Efron and Morris 1973, "Stein's estimation rule and its competitors"). Where
/// the row or the column exceeds its noise by less than all eight neighbours do, and is brighter, it replaces
/// them: the pixels of a thin line resemble each other, and not those beside it.
///
/// This fails for a pixel at an edge of which only one half is bright: few samples hit the bright side. If
/// the edge is nearly parallel to the rows or columns of pixels, it covers as much of the adjacent pixels,
/// and their mean is t. If nothing else around is bright, it belongs to a small object, and t is its own
/// value. Along an edge that samples hit now and then, the difference from t is taken instead of d: of a
/// hundred such pixels, a few that are hit twice make up the error. Other such pixels, other edge pixels, and
/// outliers are summed separately; see `error_estimate_of`.
ErrorSums error_sums_of(const PixelMoments& pixels, const TileBounds& counted);

/// Returns the estimated squared error of one pixel, relative as in relMSE, the mean over its channels: d^2 /
/// (t^2 + 0.01) with t as above, also for outliers and for pixels that few samples have hit.
double squared_error_of(const PixelMoments& pixels, const Imath::V2i& pixel);

}  // namespace transport
