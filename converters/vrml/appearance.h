#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "converters/material_rule.h"
#include "converters/materials.h"
#include "converters/vrml/node.h"
#include "converters/vrml/report.h"

namespace convert::vrml {

/// The inputs that determine the surface of faces.
struct SurfaceInputs {
  const Node* material = nullptr;  ///< Material; null: none
  std::size_t index = 0;           ///< index of the material within a VRML 1.0 Material
  std::string_view name;           ///< name for a material without one
  std::optional<std::string> texture;
  /// Whether colours of vertices or faces replace the diffuse colour.
  bool has_colours = false;
};

/// The materials of a file and of those it inlines: a definition per used material.
class Appearances {
 public:
  Appearances(DefinitionNames& names, Report& report) : materials_(names), report_(report) {}

  /// Returns the surface for a number of faces, and counts their losses.
  grf::Surface surface(const SurfaceInputs& inputs, std::size_t faces);

  const Materials& materials() const { return materials_; }

 private:
  using Key = std::tuple<const Node*, std::size_t, bool, std::optional<std::string>>;

  Materials materials_;
  std::map<Key, std::size_t> known_;
  Report& report_;
};

/// Returns the number of materials in a VRML 1.0 Material: the length of its longest list.
std::size_t material_count(const Node& material, Report& report);

/// Returns the diffuse colour per material; the last value of a shorter list is repeated.
std::vector<grf::Colour> diffuse_colours(const Node& material, Report& report);

/// Returns whether materials only differ in the diffuse colour, and have no specular highlight.
bool differs_in_diffuse_colour_alone(const Node& material, Report& report);

/// Applies a TextureTransform or a Texture2Transform to texture coordinates.
void transform_uvs(std::vector<grf::Vec2f>& uvs, const Node& transform, Report& report);

/// Returns the image of an ImageTexture or a Texture2, relative to the folder of `main_path`. Returns nothing
/// if there is no texture, or it is not supported, which is reported.
std::optional<std::string> texture_of(const Node* texture, const std::string& folder,
                                      const std::string& main_path, Report& report);

/// Returns the table of conversions of materials that are read.
std::span<const MaterialRule> material_rules();

}  // namespace convert::vrml
