#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/benchmarks/render/measurement.h"

namespace benchmark {

/// Numbers that are not known are null.
nlohmann::json to_json(const std::vector<Measurement>& measurements);

/// A heading line, then a line for each measurement; what is not known is empty.
std::string to_csv(const std::vector<Measurement>& measurements);

/// A table of all measurements, and, where there are two renderers, one of bpt's efficiency over the other's
/// and of the largest difference between the means of the images' channels.
std::string to_markdown(const std::vector<Measurement>& measurements);

/// |a/b - 1| in the channel where it is largest.
double largest_difference(const reflectance::Rgb& a, const reflectance::Rgb& b);

}  // namespace benchmark
