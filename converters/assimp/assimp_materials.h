#pragma once

#include <optional>
#include <span>

#include <assimp/material.h>

#include "converters/assimp/assimp_rules.h"
#include "converters/material_mapping.h"
#include "converters/material_rule.h"
#include "grf/math.h"

namespace convert {

/// Texture coordinates as a map takes them: moved, then scaled and turned about the image's centre.
struct UvPlacement {
  grf::Vec2f offset = grf::Vec2f(0);
  grf::Vec2f scale = grf::Vec2f(1);
  float angle = 0;  ///< counter-clockwise, in radians

  grf::Vec2f operator()(const grf::Vec2f& uv) const;
};

/// A material of Assimp's, with what faces need of it that GRF's materials have not.
struct AssimpMaterial {
  PhongMaterial phong;
  unsigned uv_set = 0;  ///< the texture coordinates that the diffuse map takes
  std::optional<UvPlacement> placement;
};

/// Reads the table of properties, all of which stand in the comment too.
AssimpMaterial read_material(const aiMaterial& material, const AssimpRules& rules);

/// True of the material that Assimp gives to faces without one.
bool is_invented(const aiMaterial& material, const AssimpRules& rules);

/// What becomes of materials that are read.
std::span<const MaterialRule> assimp_material_rules();

}  // namespace convert
