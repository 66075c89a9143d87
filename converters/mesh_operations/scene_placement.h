// Turning, scaling and moving a scene as a whole.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/scene.h"

namespace convert {

/// Steps as a command line says them: `rotation 0 90 0 translation 1 0 0`. Words and order are those of GRF,
/// and the parentheses and commas of GRF may be there too, but angles are in degrees. Nothing where the text
/// is none, with the reason in `problem`.
std::optional<std::vector<grf::TransformStep>> read_transform_steps(std::string_view text,
                                                                    std::string& problem);

/// The turn that makes the z axis point where y did: up, in GRF.
grf::TransformStep z_up_to_y_up();

/// Puts all of the scene under the steps, if there are any. Definitions stay inside.
void place(grf::Scene& scene, const std::vector<grf::TransformStep>& steps,
           const grf::SourceLocation& location);

}  // namespace convert
