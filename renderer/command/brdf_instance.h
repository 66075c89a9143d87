#pragma once

#include <optional>
#include <string>

#include "renderer/reflectance/reflector.h"

namespace command {

/// The BRDF that a text such as `ward sx=0.2` describes, or the file of that name holds, with its own
/// sampler. After a mistake, which is printed, nothing.
std::optional<reflectance::Reflector> read_instance(const std::string& instance);

}  // namespace command
