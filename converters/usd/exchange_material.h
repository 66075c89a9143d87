// The materials of a scene for USD and MaterialX: equal surfaces share one, and each has a name of its own.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "converters/gltf/gltf_brdf.h"
#include "converters/losses.h"
#include "converters/usd/shading_graph.h"
#include "grf/unique_names.h"

namespace convert {

struct ExchangeMaterial {
  std::string name;      ///< an identifier, unique in the file
  std::string original;  ///< the name of the BRDF's definition, or its keyword
  ShadedSurface shaded;
  GltfBrdf preview;  ///< the nearest metallic-roughness material, with the surface's colour in its base
  ShadingGraph graph;
  std::string grf;  ///< the exact text of the surface
};

/// Makes the materials of a scene, which must outlive them.
class ExchangeMaterials {
 public:
  /// Returns the index of the material of a surface that so many faces have. Counts what is lost.
  std::size_t index_of(const grf::Surface& surface, const grf::Scope& scope, bool has_vertex_colours,
                       std::size_t faces, Losses& losses);
  /// Returns the index of the material of a lamp, which reflects nothing.
  std::size_t index_of_lamp(const grf::Colour& radiance);

  const std::vector<ExchangeMaterial>& all() const { return materials_; }

 private:
  std::size_t add(ShadedSurface shaded, const std::string& original, std::string grf);

  std::vector<ExchangeMaterial> materials_;
  std::map<std::string, std::size_t> index_of_key_;
  grf::UniqueNames names_;
};

/// Returns an identifier of ASCII letters, digits and underlines, as names of prims are.
std::string to_prim_name(std::string_view name, std::string_view otherwise);

}  // namespace convert
