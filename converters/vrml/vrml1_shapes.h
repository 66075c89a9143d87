#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/vrml/world.h"

namespace convert::vrml {

/// The property nodes that hold for the shapes behind them; null: none came before.
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

/// True of the shapes of VRML 1.0 that have faces.
bool is_shape1(std::string_view type);

/// The nodes that make the mesh of a shape: itself and those of the state that it looks at.
std::vector<const Node*> parts_of_shape1(const Node& shape, const Vrml1State& state);

/// The faces of a shape and what they look like. Nothing after an error.
std::optional<ShapeParts> read_shape1(const Node& shape, const Vrml1State& state,
                                      const OpenDocument& document, World& world);

}  // namespace convert::vrml
