// Several commands print these JSON values.
#pragma once

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "grf/math.h"
#include "grf/write.h"

namespace command {

/// Returns the number, or null where there is none or it is not finite.
inline nlohmann::ordered_json number_or_null(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

/// Returns an array of the three components, each with the fewest digits that read back to the same float.
inline nlohmann::ordered_json json_array(const grf::Vec3f& vector) {
  return {grf::shortest(vector.x), grf::shortest(vector.y), grf::shortest(vector.z)};
}

}  // namespace command
