#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/benchmarks/render/measurement.h"

namespace benchmark {

/// The results as JSON. Unknown numbers are null.
nlohmann::json to_json(const std::vector<Measurement>& measurements);

/// The results as CSV: a heading line, then a line per measurement; unknown values are empty.
std::string to_csv(const std::vector<Measurement>& measurements);

/// A table of all measurements, one of bpt's rays by kind beside Embree's if they are known, and, with two
/// renderers, one of bpt's efficiency relative to the other's and of the largest difference between the means
/// of the images' channels.
std::string to_markdown(const std::vector<Measurement>& measurements);

/// Returns the largest |a/b - 1| of the channels.
double largest_difference(const grf::Colour& a, const grf::Colour& b);

}  // namespace benchmark
