// The nodes of MaterialX that make the material of a surface, for documents of MaterialX and for USD.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grf/math.h"
#include "grf/visit.h"

namespace convert {

/// An input of a node: numbers, a text, or the output of another node.
struct ShadingInput {
  std::string name;
  std::string type;                                ///< of MaterialX: `float`, `color3`, `filename`
  std::vector<double> numbers;                     ///< of numeric types; a boolean is 0 or 1
  std::string text;                                ///< of strings and file names
  std::optional<std::size_t> node = std::nullopt;  ///< index of the node that it is connected to
};

struct ShadingNode {
  std::string category;    ///< `oren_nayar_diffuse_bsdf`
  std::string type;        ///< of the output
  std::string definition;  ///< the name of the node's definition, which USD asks for
  std::vector<ShadingInput> inputs;
};

/// Nodes, each after those that it is connected to; the last is the surface shader.
struct ShadingGraph {
  std::vector<ShadingNode> nodes;
  bool is_exact = true;  ///< whether the nodes have the BRDF's own formula and the surface's colours
};

/// The attributes of a surface that its material depends on.
struct ShadedSurface {
  grf::ResolvedSurface surface;  ///< without emission if that is black
  std::string texture;           ///< path; empty: none
  bool has_vertex_colours = false;
};

/// The primvar, or property of the geometry, with the colours of vertices as GRF has them.
inline constexpr std::string_view VertexColours = "vertexColor";

/// Makes the nodes of MaterialX 1.39 for a surface.
ShadingGraph shading_graph_of(const ShadedSurface& shaded);

/// Returns whether an image holds linear values, and not ones encoded in sRGB.
bool is_linear_image(const std::string& file);

}  // namespace convert
