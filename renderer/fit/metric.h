// The metrics of a fit compare f cos(theta_v) of a BRDF with that of data, so that grazing directions, where
// little light arrives, count little.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace fit {

enum class Metric {
  CubeRoot,  ///< difference of cube roots, near what is seen (Fores, Ferwerda and Gu 2012)
  Log,       ///< difference of log(1 + f cos), which keeps tails (Löw, Kronander, Ynnerman and Unger 2012)
  L2,        ///< difference: the peak decides
};

inline constexpr std::array<Metric, 3> Metrics = {Metric::CubeRoot, Metric::Log, Metric::L2};
inline constexpr std::array<std::string_view, 3> MetricNames = {"cuberoot", "log", "l2"};

inline std::string_view name_of(Metric metric) { return MetricNames[static_cast<std::size_t>(metric)]; }

inline std::optional<Metric> metric_of(std::string_view name) {
  for (const Metric metric : Metrics) {
    if (name_of(metric) == name) return metric;
  }
  return std::nullopt;
}

/// The function T of a metric: residuals are T(f cos) - T(data cos).
class MetricScale {
 public:
  /// Takes the mean of f cos of the data. The cube root has an infinite slope at 0, so a millionth of the
  /// mean is added below it.
  MetricScale(Metric metric, double mean_value) : metric_(metric), offset_(1e-6 * mean_value) {}

  double value(double y) const {
    switch (metric_) {
      case Metric::CubeRoot:
        return std::cbrt(y + offset_);
      case Metric::Log:
        return std::log1p(y);
      case Metric::L2:
        break;
    }
    return y;
  }

  double slope(double y) const {
    switch (metric_) {
      case Metric::CubeRoot: {
        const double root = std::cbrt(y + offset_);
        return 1 / (3 * root * root);
      }
      case Metric::Log:
        return 1 / (1 + y);
      case Metric::L2:
        break;
    }
    return 1;
  }

 private:
  Metric metric_;
  double offset_;
};

}  // namespace fit
