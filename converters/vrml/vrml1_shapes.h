#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/vrml/world.h"

namespace convert::vrml {

/// The traversal state of VRML 1.0: the property nodes that apply to the following shapes; null: none so far.
struct Vrml1State {
  const Node* coordinates = nullptr;
  const Node* normals = nullptr;
  const Node* normal_binding = nullptr;
  const Node* material = nullptr;
  const Node* material_binding = nullptr;
  const Node* texture = nullptr;
  const Node* texture_transform = nullptr;
  const Node* texture_coordinates = nullptr;
  const Node* shape_hints = nullptr;
};

/// Returns whether a node type is a VRML 1.0 shape with faces.
bool is_shape1(std::string_view type);

/// Returns the nodes that determine the mesh of a shape: itself and the property nodes that it uses.
std::vector<const Node*> parts_of_shape1(const Node& shape, const Vrml1State& state);

/// Reads the faces of a shape and their surfaces; returns nothing after an error.
std::optional<ShapeFaces> read_shape1(const Node& shape, const Vrml1State& state,
                                      const OpenDocument& document, World& world);

}  // namespace convert::vrml
