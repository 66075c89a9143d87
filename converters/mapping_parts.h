// What the mappings of all families of materials have in common.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "converters/material_mapping.h"
#include "grf/model.h"

namespace convert {

/// One number where the components are equal.
grf::Value to_value(const grf::Vec3d& v);

grf::BrdfModel make_brdf(std::string keyword, const std::vector<std::pair<std::string, grf::Value>>& values);

/// A material without a body yet: its name, and a comment with its own spelling and the original values.
MappedMaterial named_material(const std::string& name, std::string_view source,
                              const std::vector<std::string>& source_values);

/// The value in 0..maximum; the material is marked where it was outside.
double clamped(double value, double maximum, MappedMaterial& material);
grf::Vec3d clamped(const grf::Vec3d& value, double maximum, MappedMaterial& material);

/// Ends a mapping: says that values were clamped, and makes faces emit what is over 0.
void finish(const grf::Vec3d& emission, MappedMaterial& material);

}  // namespace convert
