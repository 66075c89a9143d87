#pragma once

#include <string>
#include <vector>

#include "grf/wording.h"

namespace convert {

using grf::counted;

/// Formats a list of names for a message: "'a', 'b', 'c' and 4 more".
std::string listed(const std::vector<std::string>& names);

}  // namespace convert
