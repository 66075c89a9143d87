#pragma once

#include <optional>

#include "renderer/transport/error_sums.h"

namespace transport {

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

/// Returns the error of an image and its 95 % confidence interval; empty if no value was counted.
///
/// The interval. The estimated and the true error are both roots of sums of squares with about N degrees of
/// freedom, where N grows with (sum of var)^2 / sum of var^2, the number of pixels that the error is spread
/// over: so the square of their ratio has the distribution F(N, N). If a handful of pixels make up the error,
/// it is hardly known.
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

/// Returns the error of an image that differs from the truth by noise and by a bias: the noise has mean 0, so
/// the squares add up.
ErrorEstimate with_bias(const ErrorEstimate& noise, const ErrorEstimate& bias);

}  // namespace transport
