// A whole scene is rotated, scaled and translated.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grf/scene.h"

namespace convert {

/// Parses transform steps of a command line: `rotation 0 90 0 translation 1 0 0`. Keywords and order are
/// those of GRF, whose parentheses and commas are optional, but angles are in degrees. Returns nothing for an
/// invalid text, with the reason in `problem`.
std::optional<std::vector<grf::TransformStep>> read_transform_steps(std::string_view text,
                                                                    std::string& problem);

/// A unit of length of models.
struct LengthUnit {
  std::string_view name;  ///< for options: `mm`
  double metres = 1;
};

/// Returns the units of length, from small to large.
std::span<const LengthUnit> length_units();

/// Returns the rotation from z up to y up, as in GRF.
grf::TransformStep z_up_to_y_up();

/// Transforms the whole scene by the steps, if there are any. Definitions stay inside.
void place(grf::Scene& scene, const std::vector<grf::TransformStep>& steps,
           const grf::SourceLocation& location);

}  // namespace convert
