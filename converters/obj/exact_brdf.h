#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "grf/model.h"

namespace convert {

/// Parses the BRDF of a comment `# grf:`, or returns nothing if it is invalid. Each term of a `combine` or a
/// layer must name a material, by its identifier, for which `is_known` returns true.
std::optional<grf::BrdfModel> read_exact_brdf(std::string_view text,
                                              const std::function<bool(const std::string&)>& is_known);

}  // namespace convert
