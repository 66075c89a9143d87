// Errors are compared at equal total time: building tables, sampling and tracing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samples/studies/thesis/results.h"

namespace study {

/// The error of one line of a sweep over its time.
class Curve {
 public:
  /// Makes the curve from the rows of one line.
  explicit Curve(const std::vector<const Row*>& rows);

  /// Interpolates between the measured times by a power law of render time, and extrapolates with exponent
  /// -1/2. Nothing if the tables are not built by then.
  std::optional<double> error_at(double total_seconds) const;
  /// The total time with the most samples.
  double last_total() const;

 private:
  struct Point {
    double seconds, error;
  };
  double build_ = 0;
  std::vector<Point> points_;  ///< in ascending order of time
};

/// The error of `warp` on one BRDF of a scene, against other schemes in the time of its most samples.
struct EqualTime {
  std::string scene = {}, brdf = {}, integrator = {};
  bool is_glossy = false;
  double seconds = 0;
  double warp = 0;
  std::string rival = {};  ///< the best of the other generic schemes; empty: no tables were built in time
  double rival_error = 0;
  std::optional<double> own = {};

  /// The variation of times between runs.
  static constexpr double Tolerance = 1.03;
  static constexpr double MostOverOwn = 1.3;

  bool is_best() const { return rival.empty() || warp <= Tolerance * rival_error; }
  bool is_near_own() const { return !own || warp <= MostOverOwn * *own; }
};

std::vector<EqualTime> equal_times(const Results& results);

/// Returns a table of whether the targets hold, per line, and a sentence for each target.
std::string equal_time_section(const Results& results);

}  // namespace study
