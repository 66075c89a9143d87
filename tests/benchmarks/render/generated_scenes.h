// Scenes of the benchmark that are too large to be written by hand, as texts in GRF. Each is the same on
// every machine.
#pragma once

#include <string>

namespace benchmark {

/// A hall of 16 m with this many rectangular lamps under its ceiling, a square number: of different sizes,
/// colours and radiances, some of them tilted, and about the same power in total for any number. Partitions,
/// tables and columns hide most lamps from most points. The text includes sphere.grf and knot.grf, with the
/// BRDFs `metal` and `coated`.
std::string hall_of_lamps(int lamps);

}  // namespace benchmark
