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

/// What decides the surface of faces.
struct Look {
  const Node* material = nullptr;  ///< Material; null: none
  std::size_t index = 0;           ///< which of the materials that a Material of VRML 1.0 holds
  std::string_view name;           ///< of a material that has none of its own
  std::optional<std::string> texture;
  /// True where colours of vertices or faces take the place of the diffuse one.
  bool has_colours = false;
};

/// The materials of a file and of those it inlines: a definition for each that is used.
class Appearances {
 public:
  Appearances(DefinitionNames& names, Report& report) : materials_(names), report_(report) {}

  /// The surface of so many faces.
  grf::Surface surface(const Look& look, std::size_t faces);

  const Materials& materials() const { return materials_; }

 private:
  using Key = std::tuple<const Node*, std::size_t, bool, std::optional<std::string>>;

  Materials materials_;
  std::map<Key, std::size_t> known_;
  Report& report_;
};

/// How many materials a Material of VRML 1.0 holds: as many as its longest list has values.
std::size_t material_count(const Node& material, Report& report);

/// The values of a list of colours for each of the materials; the last one holds for all behind it.
std::vector<grf::Colour> diffuse_colours(const Node& material, Report& report);

/// True if the materials have but one value of all but the diffuse colour, and no highlight.
bool differs_in_diffuse_colour_alone(const Node& material, Report& report);

/// Moves texture coordinates as a TextureTransform or a Texture2Transform says.
void transform_uvs(std::vector<grf::Vec2f>& uvs, const Node& transform, Report& report);

/// The image of an ImageTexture or a Texture2, named from the folder of `main_path`. Nothing, and a line of
/// the report, if it is none that can be kept; nothing alone if there is no texture.
std::optional<std::string> texture_of(const Node* texture, const std::string& folder,
                                      const std::string& main_path, Report& report);

/// What becomes of materials that are read.
std::span<const MaterialRule> material_rules();

}  // namespace convert::vrml
