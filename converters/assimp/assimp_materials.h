#pragma once

#include <optional>
#include <span>

#include <assimp/material.h>

#include "converters/assimp/assimp_rules.h"
#include "converters/material_mapping.h"
#include "converters/material_rule.h"
#include "grf/math.h"

namespace convert {

/// A transform of texture coordinates: translation, then scale and rotation about the image's centre.
struct UvPlacement {
  grf::Vec2f offset = grf::Vec2f(0);
  grf::Vec2f scale = grf::Vec2f(1);
  float angle = 0;  ///< counter-clockwise, in radians

  grf::Vec2f operator()(const grf::Vec2f& uv) const;
};

/// A material of Assimp, with the texture mapping that its faces need.
struct AssimpMaterial {
  PhongMaterial phong;
  unsigned uv_set = 0;  ///< index of the diffuse map's texture coordinates
  std::optional<UvPlacement> placement;
};

/// Reads the table of properties; all of them are kept in the comment too.
AssimpMaterial read_material(const aiMaterial& material, const AssimpRules& rules);

/// Returns whether this is the default material that Assimp gives to faces without one.
bool is_invented(const aiMaterial& material, const AssimpRules& rules);

/// Returns the table of conversions of materials that are read.
std::span<const MaterialRule> assimp_material_rules();

}  // namespace convert
