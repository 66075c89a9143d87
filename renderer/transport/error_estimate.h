#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grf/math.h"
#include "renderer/transport/tile_bounds.h"

namespace transport {

/// The error sums collect what the pixels of an image say about its error, to be added up over parts of the
/// image. Errors are squared and relative, as in relMSE; pixels and channels count alone.
struct ErrorSums {
  double values = 0;  ///< pixels times channels
  /// Estimates of the squared error where it is known what to divide by.
  double errors = 0;
  /// Squares of what the channels of a pixel add to `errors`: how unevenly the error is spread.
  double squares = 0;
  /// The part of the error that is of second order, e^2 / (1 + e): what is divided by is itself uncertain.
  double doubt = 0;

  /// The possible errors are what `errors` and `squares` would be if no pixel at an edge had less than a part
  /// of the variance of a binomial distribution.
  struct Possible {
    double errors = 0;
    double squares = 0;
  } possible;

  /// Pixels at an edge that few samples have hit, so that their radiance is hardly known.
  struct Touched {
    double errors = 0;      ///< as if a pixel's own mean were its radiance
    double logarithms = 0;  ///< of how much brighter they are than the dark side, times that error
    double bounds = 0;      ///< what the squared error of one such pixel may be, times that error
    double unseen = 0;      ///< expected errors of pixels at such edges that no sample has hit
  } touched;

  /// Values that stand out from all neighbours but one.
  struct Lone {
    double count = 0;
    double agreement = 0;   ///< from 0, only one half is bright, to 1 for each value
    double steady = 0;      ///< how many agree so well that they may be hit by every sample
    double on_black = 0;    ///< how many have a neighbour darker than the floor
    double own = 0;         ///< the squared error, if the pixels are as bright as they seem
    double neighbours = 0;  ///< the same, if they are as their neighbours
  } lone;

  ErrorSums& operator+=(const ErrorSums& other) { return add(other, 1); }
  ErrorSums operator-(const ErrorSums& other) const { return ErrorSums(*this).add(other, -1); }

 private:
  ErrorSums& add(const ErrorSums& other, double sign);
};

/// An error estimate says how far an image is from the truth, as far as its own samples tell: sqrt(relMSE)
/// with relMSE = mean((image - truth)^2 / (truth^2 + 0.01)) over pixels and channels.
struct ErrorEstimate {
  double error = 0;
  double low = 0;  ///< 95 % of images are between these
  double high = 0;
};

/// Pixels of a rectangle of an image, row by row: the mean of each, and the variance of that mean.
struct PixelMoments {
  TileBounds bounds;
  double samples = 0;  ///< of each pixel
  std::vector<Imath::V3d> means;
  std::vector<Imath::V3d> variances;

  /// Returns the index of a pixel by its place in the image.
  std::size_t index_of(int x, int y) const { return bounds.index_of(x - bounds.x, y - bounds.y); }
  bool contains(int x, int y) const {
    return x >= bounds.x && x < bounds.x + bounds.width && y >= bounds.y && y < bounds.y + bounds.height;
  }
};

/// How many pixels to each side of a pixel tell of its error.
constexpr int ErrorNeighbours = 3;

/// Adds up the estimated errors of the pixels of `counted`, a rectangle within the given one; the pixels
/// around it, up to `ErrorNeighbours` to each side, tell what is an edge.
///
/// With a and b the means of a pixel's halves, x = (a + b) / 2 its value and t the truth, d = (a - b) / 2 has
/// the distribution of x - t. More than that, d^2 differs from (x - t)^2 by -(a - t)(b - t) alone. That has
/// mean 0 because the halves are independent, and variance 4 var(x)^2, however heavy the tails of a and b
/// are. So the numerator is unbiased. The denominator t^2 is the difficulty: a rare bright sample makes d and
/// x large together, and would excuse itself if d^2 were divided by x^2; but next to a lamp, the neighbours
/// are no measure of a pixel. So t is taken to be
///
///     m + g (x - m),   g = 1 - 1.5 (sum of d^2) / (sum of (x - m)^2), at least 0,
///
/// with the neighbours' mean m and sums over the pixel and its neighbours: an empirical Bayes estimate, that
/// goes from the neighbours' mean, where all that differs is noise, to the pixel's own where the contrast is
/// more than that (Efron and Morris 1973, "Stein's estimation rule and its competitors"). Where the row or
/// the column differs less beyond its noise than all eight neighbours do, and is brighter, it takes their
/// place: the pixels of a thin line are like each other, and not like what is beside it.
///
/// Of a pixel at an edge of which one half alone is bright, t is not known so: the samples that hit the
/// bright side are few. If the edge is nearly parallel to the rows or columns of pixels, it covers as much of
/// the pixels beside, and the mean of those is t. Else, and if the pixel stands out alone, it is kept apart,
/// see `error_estimate_of`.
ErrorSums error_sums_of(const PixelMoments& pixels, const TileBounds& counted);

/// The error of an image, and an interval that holds it in 95 % of images; nothing without values.
///
/// The interval. The stated and the true error are both roots of sums of squares with about N degrees of
/// freedom, where N grows with (sum of var)^2 / sum of var^2, which is how many pixels the error is spread
/// over: so the square of their ratio has the distribution F(N, N). An error that is a handful of pixels is
/// hardly known. To that comes the doubt about what is divided by, which does not become less with more
/// pixels; it is of the upper bound only, since what noise does to the denominators makes the error seem
/// smaller.
///
/// Touched pixels. Let an edge cover a pixel so that h samples hit it in the mean; all h are as likely. Of
/// pixels with one hit, h has the density h exp(-h) and the squared relative error (1 - h)^2 / h^2 has the
/// tail probability 1 / (2 y): it has no mean but for the radiance of the dark side. The sum over M such
/// pixels is about M times ln(M) plus a constant, and seldom above M times 20. Where the hit and the dark
/// side differ by the factor B in square, no error is above B. Along an edge that is parallel to the pixels'
/// rows all h are the same, and if h is small the one pixel that is hit has the whole error: so the sum may
/// be greater by B once, but no more than where a row of some 40 pixels has one hit. As many pixels are not
/// hit.
///
/// Lone pixels. A value that stands out from all neighbours but one belongs to a small bright thing, or the
/// end of a thin one, or is a rare bright sample of a dark one. If such things are hit h times in the mean,
/// the halves of those that were hit agree with about h / 4: so all lone pixels of an image together tell h,
/// and h times what was found is their radiance. Few pixels tell little of h, so that on black a small h is
/// assumed to begin with, and else none; and the interval has what greater and smaller ones would give.
/// Things that every sample hits, such as the ends of lamps, say nothing of rare bright samples beside them:
/// the upper bound leaves out the values that agree well.
std::optional<ErrorEstimate> error_estimate_of(const ErrorSums& sums);

}  // namespace transport
