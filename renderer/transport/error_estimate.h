#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grf/math.h"
#include "renderer/transport/tile_bounds.h"

namespace transport {

/// Error statistics of an image's pixels, to be summed over parts of the image. Errors are squared and
/// relative, as in relMSE, and taken per pixel and channel.
struct ErrorSums {
  double values = 0;  ///< pixels times channels
  /// Sum of the unbiased estimates of squared error, where the denominator is known.
  double errors = 0;
  /// Squares of what a pixel's channels add to `errors`: they measure how unevenly the error is spread.
  double squares = 0;
  /// Second-order error e^2 / (1 + e), which comes from the uncertainty of the denominator.
  double denominator_uncertainty = 0;

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

  /// Values beside a bright object that no sample seems to have hit.
  struct Untouched {
    double contrasts = 0;  ///< radiance that one hit would add, relative to their own
    double squares = 0;    ///< of the contrasts
  } untouched;

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

/// An estimate of an image's error from its own samples: sqrt(relMSE) with relMSE = mean((image - truth)^2 /
/// (truth^2 + 0.01)) over pixels and channels.
struct ErrorEstimate {
  double error = 0;
  double low = 0;  ///< bounds of the 95 % confidence interval
  double high = 0;
};

/// Returns the 97.5 % quantile of Student's t distribution by the series of Cornish and Fisher (1938). Its
/// error is less than 1 % from 3 degrees of freedom on, and the result too small below.
double student_quantile(double freedom);

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
constexpr int ErrorNeighbours = 3;

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
/// and their mean is t. Other such pixels, other edge pixels, and outliers are summed separately; see
/// `error_estimate_of`.
ErrorSums error_sums_of(const PixelMoments& pixels, const TileBounds& counted);

/// Returns the estimated squared error of one pixel, relative as in relMSE, the mean over its channels: d^2 /
/// (t^2 + 0.01) with t as above, also for outliers and for pixels that few samples have hit.
double squared_error_of(const PixelMoments& pixels, const Imath::V2i& pixel);

/// Returns the error of an image and its 95 % confidence interval; empty if no value was counted.
///
/// The interval. The estimated and the true error are both roots of sums of squares with about N degrees of
/// freedom, where N grows with (sum of var)^2 / sum of var^2, the number of pixels that the error is spread
/// over: so the square of their ratio has the distribution F(N, N). If a handful of pixels make up the error,
/// it is hardly known. The uncertainty of the denominators, which does not shrink with more pixels, is added
/// to the upper bound only, since noise in the denominators makes the error seem smaller.
///
/// Edge pixels. Few samples of each half hit the bright side of an edge pixel, so that the halves differ by 0
/// or by a whole hit: d^2 is unbiased, but where a few pixels make up the error, it is 0 or several times too
/// large. Samples that are stratified hit an edge of any coverage with nearly the same variance: if a half's
/// expected hits lie between k and k + 1, it has one of the two, which makes 1/3 squared hit per pixel in the
/// mean over all coverages, and about as the fourth root of the hits more where there are many. This expected
/// error replaces the measured one where there are few edge pixels, and tells over how many pixels the error
/// is spread.
///
/// Touched pixels. Let an edge cover a pixel so that h samples hit it in the mean, with all h equally likely.
/// For pixels with one hit, h has the pdf h exp(-h), and the squared relative error (1 - h)^2 / h^2 has the
/// tail probability 1 / (2 y): it has no mean but for the radiance of the dark side. If the squared ratio of
/// the hit to the dark side is B, no error is above B. So the sum over M such pixels grows faster than M, and
/// with B; by how much depends on the shapes of edges, and was measured. Along an edge that is parallel to
/// the pixels' rows all h are equal, and if h is small the one pixel that is hit has the whole error: so the
/// sum may be greater by B once, but no more than where a row of some 40 pixels has one hit. As many pixels
/// are not hit. If none is hit, fewer than about 3 hits were expected (the rule of three), over any number of
/// pixels: if they were so few per pixel that one would only double its radiance, these pixels have an error
/// of that number of pixels, which is 3 times the contrast of a hit.
///
/// Outliers. A value that stands out from all neighbours but one is a small bright object, or the end of a
/// thin one, or a rare bright sample of a dark object. If such objects are hit h times in the mean, the
/// halves of those that were hit agree with about h / 4: so all outliers of an image together estimate h, and
/// h times the observed value is their radiance. A few pixels say little about h, so the prior is a small h
/// on black and none elsewhere, and the interval covers what greater and smaller h would give. Objects that
/// every sample hits, such as the ends of lamps, say nothing about rare bright samples beside them: the upper
/// bound leaves out values that agree well.
std::optional<ErrorEstimate> error_estimate_of(const ErrorSums& sums);

}  // namespace transport
