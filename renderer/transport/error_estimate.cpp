#include "renderer/transport/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace transport {
namespace {

/// The 97.5 % quantile of the standard normal distribution.
constexpr double NormalQuantile = 1.96;

/// The squared expected error as a fraction of the square of a pixel's estimated squared error: 1/3 if the
/// halves' means are normally distributed, and less with heavy tails; but then the few pixels of unknown
/// variance count in full, and images that lack their rare bright samples understate the error. Measured, as
/// the following constants, on 122 scenes like those of error_statistics_test, with 100 seeds each.
constexpr double UncertainPart = 0.4;

/// The prior for outliers: as if this many had been observed, whose halves agreed this much on black: where
/// nothing else shines, no path finds light by chance.
constexpr double OutlierPixelsBefore = 5;
constexpr double OutlierAgreementBefore = 0.12;

/// The number of edge pixels whose measured error counts as much as the expected one.
constexpr double EdgePixelsBefore = 12;

// Measured, as UncertainPart was.
constexpr double TailPart = 0.43;          ///< of touched pixels' errors, for the least touched ones
constexpr double TailContrastPower = 0.3;  ///< growth of that with the squared contrast
constexpr double TailPixelsPower = 0.2;    ///< and with the number of touched pixels
constexpr double FewTouchedPixels = 0.3;   ///< below which that number counts as this
constexpr double ManyTouchedPixels = 60;   ///< above which it counts as this: the tail is sampled then
constexpr double UnseenPart = 0.2;         ///< of the error of pixels without hits, in most images
constexpr double TouchedPart = 0.72;       ///< of the touched pixels' errors, which may be missing
constexpr double EdgeSquares = 3.5;        ///< of edge pixels' squares: the tails of a binomial distribution

/// The contribution of separately counted pixels to the sums.
struct Supplement {
  double errors = 0;
  double squares = 0;
};

/// Spreads an error equally over values, and over the channels of a pixel.
Supplement spread_over(double errors, double values) {
  return {errors, errors * errors * PixelChannels / values};
}

/// The squared contrast of touched pixels to the dark side: its geometric mean.
double contrast_of(const ErrorSums::Touched& touched) {
  return std::exp(touched.logarithms / touched.errors);
}

Supplement errors_of(const ErrorSums::Touched& touched) {
  if (!(touched.errors > 0)) return {};
  const double pixels = std::clamp(touched.errors / PixelChannels, FewTouchedPixels, ManyTouchedPixels);
  const double tail =
      TailPart * std::pow(contrast_of(touched), TailContrastPower) * std::pow(pixels, TailPixelsPower);
  return spread_over(touched.errors * (1 + tail), touched.errors);
}

// The more edge pixels there are, the less their measured errors are noise.
Supplement errors_of(const ErrorSums::Edges& edges) {
  if (!(edges.expected > 0)) return {};
  const double pixels = edges.expected * edges.expected / edges.squares;
  const double measured = pixels * pixels / (pixels * pixels + EdgePixelsBefore * EdgePixelsBefore);
  const double errors = measured * edges.errors + (1 - measured) * edges.expected;
  const double quotient = errors / edges.expected;
  return {errors, EdgeSquares * quotient * quotient * edges.squares};
}

/// How much larger the squared errors of touched pixels, and of those that were not hit, may be: a single
/// pixel may be touched far less than the others.
double bound_of(const ErrorSums::Touched& touched) {
  const double unseen = std::max(0.0, touched.unseen);
  const double of_unseen = UnseenPart * (unseen + std::sqrt(unseen));
  if (!(touched.errors > 0)) return of_unseen;
  const double of_one = PixelChannels * touched.bounds / std::max<double>(PixelChannels, touched.errors);
  return of_one + of_unseen;
}

/// The squared error of all outliers, and its bounds.
struct OutlierErrors {
  double errors = 0;
  double low = 0;
  double high = 0;
};

/// The error if the halves of outliers agree this much.
double errors_at(const ErrorSums::Outliers& outliers, double agreement) {
  const double hits = std::min(1.0, 4 * agreement / (1 + agreement));
  const double own = hits > 0 ? outliers.own / (hits * hits) : std::numeric_limits<double>::max();
  return std::min(std::max(outliers.own, outliers.neighbours), own);
}

/// The agreement of the outliers' halves, combined with the prior.
struct Agreement {
  double pixels = 0;
  double mean = 0;

  /// Bounds of Wilson's interval for a proportion, which also holds for a few pixels that all agree (Wilson
  /// 1927, "Probable inference, the law of succession, and statistical inference").
  double bound(double sign) const {
    constexpr double Squared = NormalQuantile * NormalQuantile;
    const double spread = std::sqrt(Squared * (mean * (1 - mean) + Squared / (4 * pixels)) / pixels);
    return std::clamp((mean + Squared / (2 * pixels) + sign * spread) / (1 + Squared / pixels), 0.0, 1.0);
  }
};

Agreement agreement_of(const ErrorSums::Outliers& outliers, double without) {
  const double pixels = (outliers.count - without) / PixelChannels + OutlierPixelsBefore;
  const double before = OutlierPixelsBefore * OutlierAgreementBefore * outliers.on_black / outliers.count;
  return {pixels, std::clamp(((outliers.agreement - without) / PixelChannels + before) / pixels, 0.0, 1.0)};
}

OutlierErrors errors_of(const ErrorSums::Outliers& outliers) {
  if (!(outliers.count > 0.5)) return {};
  const Agreement agreement = agreement_of(outliers, 0);
  return {errors_at(outliers, agreement.mean), errors_at(outliers, agreement.bound(1)),
          errors_at(outliers, agreement_of(outliers, outliers.steady).bound(-1))};
}

/// The largest difference, in 95 % of cases, of the logarithms of two estimates of one error, each the root
/// of a mean square with this many degrees of freedom: the root of F's quantile is exp of this, since 2 t /
/// sqrt(v) = sqrt(F) - 1/sqrt(F) (Cacoullos 1965, "A relation between t and F-distributions").
double logarithm_of_ratio(double freedom) {
  return std::asinh(student_quantile(freedom) / std::sqrt(freedom));
}

/// The increase of the logarithm when this much is added to a squared error of 1, halved for its root.
double half_logarithm(double added) { return std::log1p(added) / 2; }

/// The degrees of freedom of a sum of squared errors, given the sum of the squares of the pixels' errors.
double freedom_of(double errors, double squares) {
  return std::max(1.0, errors * errors / std::max(0.0, squares) / UncertainPart);
}

}  // namespace

double student_quantile(double freedom) {
  constexpr double Z = NormalQuantile;
  constexpr double Z2 = Z * Z;
  const double v = 1 / freedom;
  return Z * (1 + v * ((Z2 + 1) / 4 + v * (((5 * Z2 + 16) * Z2 + 3) / 96 +
                                           v * (((3 * Z2 + 19) * Z2 + 17) * Z2 - 15) / 384)));
}

ErrorEstimate with_bias(const ErrorEstimate& noise, const ErrorEstimate& bias) {
  return {std::hypot(noise.error, bias.error), std::hypot(noise.low, bias.low),
          std::hypot(noise.high, bias.high)};
}

std::optional<ErrorEstimate> error_estimate_of(const ErrorSums& sums) {
  if (!(sums.values > 0)) return std::nullopt;
  const Supplement edges = errors_of(sums.edges);
  const Supplement touched = errors_of(sums.touched);
  const OutlierErrors outliers = errors_of(sums.outliers);
  const double errors = sums.errors + edges.errors + touched.errors + outliers.errors;
  if (!(errors > 0)) return ErrorEstimate();
  const double outlier_squares =
      outliers.errors > 0 ? spread_over(outliers.errors, sums.outliers.own).squares : 0;
  const double freedom = freedom_of(errors, sums.squares + edges.squares + touched.squares + outlier_squares);
  // All of these refer to the logarithm of the error.
  const double deviation = logarithm_of_ratio(freedom);
  const double tail_above = half_logarithm(bound_of(sums.touched) / errors);
  // There may also be no tail.
  const double tail_below = -half_logarithm(-TouchedPart * touched.errors / errors);
  const double outliers_above = half_logarithm((outliers.high - outliers.errors) / errors);
  const double outliers_below = -half_logarithm(-(outliers.errors - outliers.low) / errors);
  const double above = std::hypot(deviation, tail_above, outliers_above);
  const double below = std::hypot(deviation, tail_below, outliers_below);
  const double error = std::sqrt(errors / sums.values);
  return ErrorEstimate{error, error * std::exp(-below), error * std::exp(above)};
}

}  // namespace transport
