#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "grf/model.h"

namespace convert {

/// The BRDF of a comment `# grf:`, or nothing if it is none. Of a `combine`, each term names a material for
/// which `is_known` is true, by its identifier.
std::optional<grf::BrdfModel> read_exact_brdf(std::string_view text,
                                              const std::function<bool(const std::string&)>& is_known);

}  // namespace convert
