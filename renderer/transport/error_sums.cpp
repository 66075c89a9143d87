#include "renderer/transport/error_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "renderer/image/image_error.h"

namespace transport {
namespace {

using image::RelmseFloor;

/// How much larger the pixels' contrast must be than the difference of the halves not to be noise.
constexpr double ContrastOverNoise = 1.5;
/// The visible part above which a pixel's likely radiance is nearly its own mean.
constexpr double NearlyAllVisible = 0.95;
/// The number of pixels to each side that are compared along a row or column.
constexpr int LinePixels = 2;
/// The ratio of deviation and mean above which only one half of a pixel is bright.
constexpr double OneHalfBright = 0.7;
/// How many times brighter an outlier is than all neighbours but one, and than the floor.
constexpr double OutlierContrast = 2;
/// The agreement above which an outlier may be an object that every sample hits.
constexpr double SteadyAgreement = 0.9;
/// The largest radius of a small object, in pixels, and how bright other pixels are at most beside it.
constexpr int SmallObject = 2;
constexpr double BesideSmallObject = 0.5;

/// The least radiance on the bright side of an edge, as a fraction of the brightest neighbour's.
constexpr double BrightSide = 0.7;
/// The least radiance of the darker side along an edge, as a fraction of the brighter one's.
constexpr double Balance = 0.5;

/// The hits per pixel along an edge, and the number of pixels, between which and from which on they are
/// compared.
constexpr double FewestHitsAlong = 0.05;
constexpr double MostHitsAlong = 0.75;
constexpr int ComparedPixels = 5;
/// The least radiance that a hit adds to such a pixel, relative to the dark side.
constexpr double SeenHit = 0.5;

/// The variance of an edge pixel that one sample hits, in squared hits, and its growth with the hits.
constexpr double EdgeVariance = 1 / 3.0;
constexpr double EdgeVariancePower = 0.25;
/// How many times the noise of a pixel's neighbours its variance is at an edge.
constexpr double EdgeOverNoise = 4;

/// The squared radiance of a touched pixel, relative to the dark side of its edge, above which its own mean
/// says little of the true one.
constexpr double TouchedContrast = 2;
/// The largest squared relative error of a touched pixel. Measured with error_statistics_test.
constexpr double TailBound = 5000;

/// Statistics of values around a pixel.
struct Neighbours {
  int count = 0;
  double sum = 0;
  double squares = 0;
  double noise = 0;  ///< sum of their variances

  void add(double mean, double variance) {
    ++count;
    sum += mean;
    squares += mean * mean;
    noise += variance;
  }
  double mean() const { return sum / count; }
  /// The sum of the squared differences from their mean, with that of the pixel.
  double contrast(double value) const {
    const double difference = value - mean();
    return std::max(0.0, squares - sum * mean()) + difference * difference;
  }
  /// The expected contrast of noise.
  double noise_with(double variance) const { return noise * (count - 1) / count + variance; }
};

/// Statistics of the eight pixels around a value.
struct Surroundings : Neighbours {
  double darkest = std::numeric_limits<double>::max();
  double brightest = 0;
  double second_brightest = 0;
  std::array<double, 8> variances = {};

  /// The median variance: that of the smooth surroundings of an edge.
  double median_variance() const {
    std::array<double, 8> sorted = variances;
    const auto middle = sorted.begin() + count / 2;
    std::nth_element(sorted.begin(), middle, sorted.begin() + count);
    return *middle;
  }
};

/// A channel of the pixel whose error is estimated.
struct PixelValue {
  Imath::V2i pixel;
  int channel = 0;
  double mean = 0;
  double variance = 0;
};

Surroundings surroundings_of(const PixelMoments& pixels, const PixelValue& value) {
  Surroundings around;
  const Imath::V2i end(std::min(value.pixel.x + 2, pixels.bounds.x + pixels.bounds.width),
                       std::min(value.pixel.y + 2, pixels.bounds.y + pixels.bounds.height));
  for (int y = std::max(value.pixel.y - 1, pixels.bounds.y); y < end.y; ++y) {
    for (int x = std::max(value.pixel.x - 1, pixels.bounds.x); x < end.x; ++x) {
      if (Imath::V2i(x, y) == value.pixel) continue;
      const auto index = pixels.index_of(x, y);
      const double beside = pixels.means[index][value.channel];
      const double variance = pixels.variances[index][value.channel];
      around.variances[static_cast<std::size_t>(around.count)] = variance;
      around.add(beside, variance);
      around.darkest = std::min(around.darkest, beside);
      around.second_brightest = std::max(around.second_brightest, std::min(around.brightest, beside));
      around.brightest = std::max(around.brightest, beside);
    }
  }
  return around;
}

/// Collects the pixels before and after a value in its row or column.
Neighbours line_through(const PixelMoments& pixels, const PixelValue& value, const Imath::V2i& step) {
  Neighbours line;
  for (int i = 1; i <= LinePixels; ++i) {
    const std::array ends = {value.pixel - step * i, value.pixel + step * i};
    for (const Imath::V2i& end : ends) {
      if (!pixels.contains(end.x, end.y)) return line;
    }
    for (const Imath::V2i& end : ends) {
      const auto index = pixels.index_of(end.x, end.y);
      line.add(pixels.means[index][value.channel], pixels.variances[index][value.channel]);
    }
  }
  return line;
}

/// Returns 0 where the neighbours and the value differ only by noise, up to 1 where they differ by visible
/// contrast.
double visible_part(const Neighbours& around, const PixelValue& value) {
  const double contrast = around.contrast(value.mean);
  const double noise = around.noise_with(value.variance);
  return contrast > 0 ? std::max(0.0, 1 - ContrastOverNoise * noise / contrast) : 0;
}

/// Estimates the radiance of a pixel from its value and its neighbours, see `error_sums_of`.
double likely_radiance(const PixelMoments& pixels, const PixelValue& value, const Surroundings& around) {
  const auto shrunk = [&](const Neighbours& neighbours, double visible) {
    return neighbours.mean() + visible * (value.mean - neighbours.mean());
  };
  const double visible = visible_part(around, value);
  if (visible > NearlyAllVisible) return shrunk(around, visible);
  const auto excess = [&](const Neighbours& neighbours) {
    return (neighbours.contrast(value.mean) - neighbours.noise_with(value.variance)) / neighbours.count;
  };
  double least = excess(around);
  double radiance = shrunk(around, visible);
  for (const Imath::V2i& step : {Imath::V2i(1, 0), Imath::V2i(0, 1)}) {
    const Neighbours line = line_through(pixels, value, step);
    if (line.count == 0 || line.mean() < around.mean()) continue;
    const double excess_of_line = std::max(0.0, excess(line));
    if (excess_of_line >= least) continue;
    least = excess_of_line;
    radiance = shrunk(line, visible_part(line, value));
  }
  return radiance;
}

/// The expected error of pixels that the same edge barely touches, and that no sample has hit, per value that
/// it partly covers: all coverages are equally likely, so there is one such pixel per `samples` pixels that
/// more than one sample hits. A hit adds this much to the dark side, and half of that is missing.
double unseen_error(const Surroundings& around, double mean, double samples) {
  const double hit = around.brightest / samples;
  const bool is_seen = 2 * hit > around.darkest + std::sqrt(RelmseFloor);
  if (!is_seen || mean > 0.95 * around.brightest || mean <= around.darkest + hit) return 0;
  const double radiance = around.darkest + hit / 2;
  return hit * hit / 4 / (radiance * radiance + RelmseFloor) / samples;
}

/// The expected squared relative error of a pixel at an edge, between objects as bright as its darkest and
/// its brightest neighbour, see `error_estimate_of`; 0 if there is no edge.
double edge_error(const Surroundings& around, double mean, double samples) {
  if (around.count == 0 || !(mean > around.darkest)) return 0;
  const double hit = (std::max(mean, around.brightest) - around.darkest) / samples;
  const double hits = (mean - around.darkest) / hit;
  if (hits < 0.5 || hits > samples - 0.5) return 0;
  const double fewer = std::max(1.0, std::min(hits, samples - hits));
  const double variance = EdgeVariance * std::pow(fewer, EdgeVariancePower) * hit * hit;
  if (variance < EdgeOverNoise * around.median_variance()) return 0;
  return variance / (mean * mean + RelmseFloor);
}

/// The value of a pixel, if it is in the rectangle and its neighbour on the bright side is bright.
class EdgeSide {
 public:
  EdgeSide(const PixelMoments& pixels, int channel, const Imath::V2i& to_bright, double bright)
      : pixels_(pixels), channel_(channel), to_bright_(to_bright), bright_(bright) {}

  std::optional<double> value_at(const Imath::V2i& pixel) const {
    const Imath::V2i beside = pixel + to_bright_;
    const bool is_inside = pixels_.contains(pixel.x, pixel.y) && pixels_.contains(beside.x, beside.y);
    if (!is_inside || mean(beside) < bright_ || mean(pixel) >= bright_) return std::nullopt;
    return mean(pixel);
  }

 private:
  double mean(const Imath::V2i& pixel) const {
    return pixels_.means[pixels_.index_of(pixel.x, pixel.y)][channel_];
  }

  const PixelMoments& pixels_;
  int channel_;
  Imath::V2i to_bright_;
  double bright_;
};

/// The mean of some pixels.
struct MeanOf {
  double mean = 0;
  int count = 0;
};

/// The mean of a pixel and its neighbours on both sides along an edge that is nearly parallel to the rows or
/// columns; empty if there is no such edge. Both sides contribute equally many pixels: along an edge that is
/// not quite parallel, the coverage changes by the same amount from pixel to pixel. Where the edge ends, one
/// side is dark, and the mean would hide how little of the last pixels is covered.
std::optional<MeanOf> mean_along_edge(const PixelMoments& pixels, const PixelValue& value, double bright) {
  double sum = 0;
  int most = 1;
  for (const Imath::V2i& to_bright :
       {Imath::V2i(1, 0), Imath::V2i(-1, 0), Imath::V2i(0, 1), Imath::V2i(0, -1)}) {
    const EdgeSide edge(pixels, value.channel, to_bright, bright);
    if (!edge.value_at(value.pixel)) continue;
    double sum_before = 0;
    double sum_after = 0;
    int count = 1;
    for (int step = 1; step <= ErrorNeighbours; ++step) {
      const Imath::V2i along = Imath::V2i(to_bright.y, to_bright.x) * step;
      const auto before = edge.value_at(value.pixel - along);
      const auto after = edge.value_at(value.pixel + along);
      if (!before || !after) break;
      sum_before += *before;
      sum_after += *after;
      count += 2;
    }
    if (count <= most || std::min(sum_before, sum_after) < Balance * std::max(sum_before, sum_after))
      continue;
    most = count;
    sum = value.mean + sum_before + sum_after;
  }
  return most > 1 ? std::optional(MeanOf{sum / most, most}) : std::nullopt;
}

/// Returns true if no pixel farther away than `SmallObject` is nearly as bright. Then the bright pixels are
/// an object: bright samples that occur by chance would be as frequent elsewhere.
bool is_small_object(const PixelMoments& pixels, const PixelValue& value) {
  for (int y = -ErrorNeighbours; y <= ErrorNeighbours; ++y) {
    for (int x = -ErrorNeighbours; x <= ErrorNeighbours; ++x) {
      const Imath::V2i other = value.pixel + Imath::V2i(x, y);
      const bool is_near = std::max(std::abs(x), std::abs(y)) <= SmallObject;
      if (is_near || !pixels.contains(other.x, other.y)) continue;
      const double beside = pixels.means[pixels.index_of(other.x, other.y)][value.channel];
      if (beside > BesideSmallObject * value.mean) return false;
    }
  }
  return true;
}

/// Returns the squared relative error of a pixel that samples hit now and then, by its difference from the
/// pixels along its edge; empty if there is no such edge. Unlike the difference of the halves, this sees
/// where both halves were hit by chance, or neither.
std::optional<double> error_along_edge(const PixelMoments& pixels, const PixelValue& value,
                                       const Surroundings& around) {
  const double floor = around.darkest + std::sqrt(RelmseFloor);
  const double hit = (around.brightest - around.darkest) / pixels.samples;
  if (value.mean >= around.brightest || hit < SeenHit * floor) return std::nullopt;
  const auto along = mean_along_edge(pixels, value, BrightSide * around.brightest);
  if (!along || along->count < ComparedPixels) return std::nullopt;
  const double hits = (along->mean - around.darkest) / hit;
  if (hits < FewestHitsAlong || hits > MostHitsAlong) return std::nullopt;
  const double difference = value.mean - along->mean;
  return difference * difference * along->count / (along->count - 1) /
         (along->mean * along->mean + RelmseFloor);
}

/// The squared relative error of a value.
struct ValueError {
  double error = 0;
  bool is_compared = false;  ///< with other pixels, and not only measured by the halves
};

/// Returns the squared relative error of a value; empty if it is added to the outliers or touched pixels.
std::optional<ValueError> add_value(const PixelMoments& pixels, const PixelValue& value,
                                    const Surroundings& around, ErrorSums& sums) {
  const double mean = value.mean;
  const double variance = value.variance;
  if (around.count == 0) return ValueError{variance / (mean * mean + RelmseFloor)};
  const bool is_lone = mean > OutlierContrast * (around.second_brightest + std::sqrt(RelmseFloor));
  if (is_lone) {
    const double excess = mean - around.second_brightest;
    ++sums.outliers.count;
    if (around.darkest < std::sqrt(RelmseFloor)) ++sums.outliers.on_black;
    const double agreement = 1 - variance / (excess * excess);
    sums.outliers.agreement += agreement;
    if (agreement > SteadyAgreement) ++sums.outliers.steady;
  }
  sums.touched.unseen += unseen_error(around, mean, pixels.samples);
  if (!is_lone) {
    if (const auto error = error_along_edge(pixels, value, around)) return ValueError{*error, true};
  }
  if (!(variance > 0)) return ValueError();
  const double radiance = likely_radiance(pixels, value, around);
  const double error = variance / (radiance * radiance + RelmseFloor);
  if (variance <= OneHalfBright * OneHalfBright * mean * mean) return ValueError{error};
  const double own_error = variance / (mean * mean + RelmseFloor);
  if (is_lone) {
    sums.outliers.own += own_error;
    sums.outliers.neighbours += error;
    return std::nullopt;
  }
  const double brighter = mean * mean / (around.darkest * around.darkest + RelmseFloor);
  const bool is_touched =
      visible_part(around, value) > 0.5 && brighter > TouchedContrast && mean <= around.brightest;
  if (!is_touched) return ValueError{is_small_object(pixels, value) ? own_error : error};
  if (const auto along = mean_along_edge(pixels, value, BrightSide * around.brightest)) {
    return ValueError{variance / (along->mean * along->mean + RelmseFloor)};
  }
  sums.touched.errors += own_error;
  sums.touched.logarithms += own_error * std::log(brighter);
  sums.touched.bounds += own_error * std::min(TailBound, brighter);
  return std::nullopt;
}

}  // namespace

ErrorSums& ErrorSums::add(const ErrorSums& other, double factor) {
  values += factor * other.values;
  errors += factor * other.errors;
  squares += factor * other.squares;
  edges.errors += factor * other.edges.errors;
  edges.expected += factor * other.edges.expected;
  edges.squares += factor * other.edges.squares;
  touched.errors += factor * other.touched.errors;
  touched.logarithms += factor * other.touched.logarithms;
  touched.bounds += factor * other.touched.bounds;
  touched.unseen += factor * other.touched.unseen;
  outliers.count += factor * other.outliers.count;
  outliers.agreement += factor * other.outliers.agreement;
  outliers.steady += factor * other.outliers.steady;
  outliers.on_black += factor * other.outliers.on_black;
  outliers.own += factor * other.outliers.own;
  outliers.neighbours += factor * other.outliers.neighbours;
  return *this;
}

ErrorSums error_sums_of(const PixelMoments& pixels, const TileBounds& counted) {
  ErrorSums sums;
  sums.values = PixelChannels * static_cast<double>(counted.pixel_count());
  for (int y = counted.y; y < counted.y + counted.height; ++y) {
    for (int x = counted.x; x < counted.x + counted.width; ++x) {
      const auto index = pixels.index_of(x, y);
      double error = 0;
      double at_edges = 0;
      for (int c = 0; c < PixelChannels; ++c) {
        const PixelValue value{{x, y}, c, pixels.means[index][c], pixels.variances[index][c]};
        const Surroundings around = surroundings_of(pixels, value);
        const auto measured = add_value(pixels, value, around, sums);
        if (!measured) continue;
        const double at_edge = measured->is_compared ? 0 : edge_error(around, value.mean, pixels.samples);
        if (at_edge > 0) {
          at_edges += at_edge;
          sums.edges.errors += measured->error;
        } else {
          error += measured->error;
        }
      }
      sums.errors += error;
      sums.squares += error * error;
      sums.edges.expected += at_edges;
      sums.edges.squares += at_edges * at_edges;
    }
  }
  return sums;
}

double squared_error_of(const PixelMoments& pixels, const Imath::V2i& pixel) {
  const auto index = pixels.index_of(pixel.x, pixel.y);
  double error = 0;
  for (int c = 0; c < PixelChannels; ++c) {
    const PixelValue value{pixel, c, pixels.means[index][c], pixels.variances[index][c]};
    const Surroundings around = surroundings_of(pixels, value);
    const double radiance = around.count > 0 ? likely_radiance(pixels, value, around) : value.mean;
    error += value.variance / (radiance * radiance + RelmseFloor);
  }
  return error / PixelChannels;
}

}  // namespace transport
