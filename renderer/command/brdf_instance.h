#pragma once

#include <optional>
#include <string>

#include "grf/model.h"
#include "renderer/reflectance/reflector.h"

namespace command {

/// The BRDF that a text such as `ward sx=0.2` describes, or the file of that name holds, with its own
/// sampler. After a mistake, which is printed, nothing.
std::optional<reflectance::Reflector> read_instance(const std::string& instance);

/// A BRDF with a scheme, and the time that its tables took to make.
struct SampledInstance {
  grf::BrdfModel model;
  reflectance::Reflector reflector;
  double build_seconds = 0;
};

/// The BRDF with the scheme that a text such as `hemisphere exp=20` describes. After a mistake in either, or
/// if the scheme refuses the BRDF, nothing; why is printed.
std::optional<SampledInstance> read_sampled_instance(const std::string& instance, const std::string& pdf);

}  // namespace command
