// The mappings of all families of materials share these functions.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "converters/material_mapping.h"
#include "grf/model.h"

namespace convert {

/// Converts a colour to a parameter's value: one number if the components are equal.
grf::Value to_value(const grf::Vec3d& v);

/// Makes a BRDF of a keyword and named values.
grf::BrdfModel make_brdf(std::string keyword, const std::vector<std::pair<std::string, grf::Value>>& values);

/// Makes a material without a BRDF yet: its name, and a comment with the original name and values.
MappedMaterial named_material(const std::string& name, std::string_view source,
                              const std::vector<std::string>& source_values);

/// Clamps a value to 0..maximum, and marks the material if it was outside.
double clamped(double value, double maximum, MappedMaterial& material);
grf::Vec3d clamped(const grf::Vec3d& value, double maximum, MappedMaterial& material);

/// Finishes a mapping: adds a comment if values were clamped, and the emission if it is above 0.
void finish(const grf::Vec3d& emission, MappedMaterial& material);

}  // namespace convert
