// Errors at equal time: tables' build, sampling and tracing together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samples/studies/thesis/results.h"

namespace study {

/// The error of one line of a sweep over the time that it costs.
class Curve {
 public:
  /// Of rows of one line.
  explicit Curve(const std::vector<const Row*>& rows);

  /// Between the measured times in proportion to a power of the time of rendering, and beyond them to that to
  /// the -1/2. Nothing if the tables are not built by then.
  std::optional<double> error_at(double total_seconds) const;
  /// With the most samples.
  double last_total() const;

 private:
  struct Point {
    double seconds, error;
  };
  double build_ = 0;
  std::vector<Point> points_;  ///< in ascending order of time
};

/// How `warp` does on one BRDF of a scene in the time that it takes for its most samples.
struct EqualTime {
  std::string scene = {}, brdf = {}, integrator = {};
  bool is_glossy = false;
  double seconds = 0;
  double warp = 0;
  std::string rival = {};  ///< the best of the other generic schemes; empty: none was ready
  double rival_error = 0;
  std::optional<double> own = {};

  /// Up to what the times of one run differ by from those of the next.
  static constexpr double Tolerance = 1.03;
  static constexpr double MostOverOwn = 1.3;

  bool is_best() const { return rival.empty() || warp <= Tolerance * rival_error; }
  bool is_near_own() const { return !own || warp <= MostOverOwn * *own; }
};

std::vector<EqualTime> equal_times(const Results& results);

/// Line by line whether the targets hold, and a sentence for each of the two.
std::string equal_time_section(const Results& results);

}  // namespace study
