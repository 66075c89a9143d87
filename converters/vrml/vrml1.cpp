// The reader of VRML 1.0: nodes modify a traversal state in order, which a Separator saves and restores.

#include "converters/vrml/transforms.h"
#include "converters/vrml/vrml1_shapes.h"
#include "converters/vrml/world.h"

namespace convert::vrml {
namespace {

using grf::Matrix44d;

constexpr int AllChildren = -3;

/// Returns the member of the state for a type of property node, or null.
const Node** slot_of(std::string_view type, Vrml1State& state) {
  if (type == "Coordinate3") return &state.coordinates;
  if (type == "Material") return &state.material;
  if (type == "MaterialBinding") return &state.material_binding;
  if (type == "Normal") return &state.normals;
  if (type == "NormalBinding") return &state.normal_binding;
  if (type == "ShapeHints") return &state.shape_hints;
  if (type == "Texture2") return &state.texture;
  if (type == "Texture2Transform") return &state.texture_transform;
  if (type == "TextureCoordinate2") return &state.texture_coordinates;
  return nullptr;
}

class Vrml1Reader {
 public:
  Vrml1Reader(World& world, const OpenDocument& document)
      : world_(world), report_(world.report()), document_(document) {}

  Blocks read(const Node& node, Place place);
  Blocks read_all(std::span<const Node* const> nodes, const Place& place) {
    return read_each(*this, nodes, place);
  }

 private:
  NodeReader reader(const Node& node) { return {node, report_.diagnostics()}; }
  std::optional<Blocks> read_group(const Node& node, const Place& place);
  Blocks read_separated(const Node& node, std::span<const Node* const> nodes, const Place& place);
  Blocks read_switch(const Node& node, const Place& place);
  Blocks read_first_level(const Node& node, const Place& place);
  Blocks read_shape(const Node& node, const Place& place);
  std::optional<Matrix44d> transform_of(const Node& node);

  World& world_;
  Report& report_;
  const OpenDocument& document_;
  Vrml1State state_;
  Matrix44d matrix_;  // transform relative to the innermost Separator
};

Blocks Vrml1Reader::read(const Node& node, Place place) {
  if (!world_.enter(node, place)) return {};
  ++place.depth;
  if (!node.name.empty()) place.name = node.name;
  if (const Node** slot = slot_of(node.type, state_)) {
    *slot = &node;
    return {};
  }
  if (const auto transform = transform_of(node)) {
    matrix_ = *transform * matrix_;
    return {};
  }
  if (is_shape1(node.type)) return read_shape(node, place);
  if (auto blocks = read_group(node, place)) return std::move(*blocks);
  report_.skip(node);
  return {};
}

/// Returns the children of a grouping node, or nothing for other nodes.
std::optional<Blocks> Vrml1Reader::read_group(const Node& node, const Place& place) {
  if (node.type == "Separator") return read_separated(node, node.children, place);
  if (node.type == "Group") return read_all(node.children, place);
  if (node.type == "Switch") return read_switch(node, place);
  if (node.type == "LOD") return read_first_level(node, place);
  if (node.type == "TransformSeparator") {
    const Matrix44d matrix = matrix_;
    Blocks blocks = read_all(node.children, place);
    matrix_ = matrix;
    return blocks;
  }
  if (node.type == "WWWAnchor") {
    report_.add("link of a WWWAnchor was lost", "links of WWWAnchors were lost", "its children are kept");
    return read_separated(node, node.children, place);
  }
  if (node.type == "WWWInline") {
    const auto addresses = reader(node).strings("name");
    return world_.under(matrix_, world_.inlined(node, addresses, document_.folder, place), node);
  }
  return std::nullopt;
}

Blocks Vrml1Reader::read_separated(const Node& node, std::span<const Node* const> nodes, const Place& place) {
  const Vrml1State state = state_;
  const Matrix44d matrix = matrix_;
  matrix_.makeIdentity();
  Blocks blocks = read_all(nodes, place);
  state_ = state;
  matrix_ = matrix;
  return world_.under(matrix_, std::move(blocks), node);
}

Blocks Vrml1Reader::read_switch(const Node& node, const Place& place) {
  const int chosen = reader(node).integer("whichChild", -1);
  if (chosen == AllChildren) return read_all(node.children, place);
  const bool has_one = chosen >= 0 && static_cast<std::size_t>(chosen) < node.children.size();
  report_.add("choice of a Switch was left out", "choices of Switches were left out", "whichChild is another",
              node.children.size() - (has_one ? 1 : 0));
  return has_one ? read(*node.children[static_cast<std::size_t>(chosen)], place) : Blocks();
}

Blocks Vrml1Reader::read_first_level(const Node& node, const Place& place) {
  if (node.children.empty()) return {};
  report_.add("level of an LOD was left out", "levels of LODs were left out", "the first one is kept",
              node.children.size() - 1);
  return read_separated(node, std::span(node.children).first(1), place);
}

Blocks Vrml1Reader::read_shape(const Node& node, const Place& place) {
  Blocks blocks = world_.mesh(parts_of_shape1(node, state_), node, place.name,
                              [&] { return read_shape1(node, state_, document_, world_); });
  return world_.under(matrix_, std::move(blocks), node);
}

/// Returns the matrix of a transform node, which applies to the following shapes; nothing for other nodes.
std::optional<Matrix44d> Vrml1Reader::transform_of(const Node& node) {
  const NodeReader fields = reader(node);
  if (node.type == "Translation") {
    return Matrix44d().setTranslation(fields.triple("translation", grf::Vec3d(0)));
  }
  if (node.type == "Scale") return Matrix44d().setScale(fields.triple("scaleFactor", grf::Vec3d(1)));
  if (node.type == "Rotation") return rotation_of(fields.exactly("rotation", 4));
  if (node.type == "Transform") return matrix_of_transform(fields, "scaleFactor");
  if (node.type != "MatrixTransform") return std::nullopt;
  Matrix44d matrix;
  const auto numbers = fields.exactly("matrix", 16);
  for (std::size_t i = 0; i < numbers.size(); ++i) matrix[static_cast<int>(i / 4)][i % 4] = numbers[i];
  if (matrix[0][3] != 0 || matrix[1][3] != 0 || matrix[2][3] != 0 || matrix[3][3] != 1) {
    fields.error_at("matrix", "the last column of the matrix is 0 0 0 1: GRF has only affine transforms");
  }
  return matrix;
}

}  // namespace

std::vector<grf::Block> read_vrml1(World& world, const OpenDocument& document, const Place& place) {
  return Vrml1Reader(world, document).read_all(document.document->roots, place);
}

}  // namespace convert::vrml
