#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "converters/gltf/gltf_file.h"
#include "converters/gltf/gltf_images.h"
#include "converters/losses.h"
#include "converters/material_rule.h"
#include "converters/materials.h"
#include "grf/diagnostics.h"

namespace convert {

/// The transform from a primitive's texture coordinates to those of its image (KHR_texture_transform).
struct TextureLookup {
  int set = 0;  ///< index of TEXCOORD
  std::array<double, 2> offset = {0, 0};
  double rotation = 0;  ///< radians
  std::array<double, 2> scale = {1, 1};

  auto operator<=>(const TextureLookup&) const = default;
};

/// The materials of a glTF file.
class GltfMaterials {
 public:
  GltfMaterials(const GltfFile& file, const GltfImages& images, DefinitionNames& names);

  /// Returns the surface of a material (-1: none) for a number of faces, and counts their losses.
  grf::Surface surface(int material, std::size_t faces, Losses& losses);
  TextureLookup lookup(int material) const;

  /// Returns whether the material exists, or the index means no material.
  bool has(int material) const { return material < static_cast<int>(lookups_.size()); }

  /// Warns about ignored material extensions, one line per extension.
  void report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const;
  std::vector<grf::Definition> definitions() const { return materials_.definitions(); }

 private:
  void add(const tinygltf::Material& source, std::size_t index);

  const GltfFile& file_;
  const GltfImages& images_;
  Materials materials_;
  std::vector<std::string> changed_;  ///< materials whose extras no longer match
  std::vector<TextureLookup> lookups_;
  std::vector<std::vector<std::string>> lost_extensions_;  ///< by material
  std::map<std::string, std::size_t> lost_;                ///< number of faces by extension
};

/// Returns the table of conversions of materials that are read.
std::span<const MaterialRule> gltf_material_rules();

}  // namespace convert
