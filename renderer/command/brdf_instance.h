#pragma once

#include <optional>
#include <string>

#include "grf/model.h"
#include "renderer/reflectance/reflector.h"

namespace command {

/// Reads a BRDF from a text such as `ward sx=0.2`, or from the file of that name, with its own sampler.
/// Prints errors and then returns nothing.
std::optional<reflectance::Reflector> read_instance(const std::string& instance);

/// A BRDF with a sampling scheme.
struct SampledInstance {
  grf::BrdfModel model;
  reflectance::Reflector reflector;
  double build_seconds = 0;  ///< build time of the scheme's tables
};

/// Reads a BRDF and a sampling scheme from texts such as `ward sx=0.2` and `hemisphere exp=20`. Prints errors
/// in either, or why the scheme does not support the BRDF, and then returns nothing.
std::optional<SampledInstance> read_sampled_instance(const std::string& instance, const std::string& pdf);

}  // namespace command
