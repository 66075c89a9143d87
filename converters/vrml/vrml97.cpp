// The reader of VRML97: a scene graph of grouping nodes with shapes as its leaves.

#include "converters/vrml/transforms.h"
#include "converters/vrml/vrml97_geometry.h"
#include "converters/vrml/world.h"

namespace convert::vrml {
namespace {

class Vrml97Reader {
 public:
  Vrml97Reader(World& world, const OpenDocument& document)
      : world_(world), report_(world.report()), document_(document) {}

  Blocks read(const Node& node, Place place);
  Blocks read_all(std::span<const Node* const> nodes, const Place& place) {
    return read_each(*this, nodes, place);
  }

 private:
  NodeReader reader(const Node& node) { return {node, report_.diagnostics()}; }
  Blocks read_children(const Node& node, const Place& place) {
    return read_all(reader(node).nodes("children"), place);
  }
  Blocks read_switch(const Node& node, const Place& place);
  Blocks read_first_level(const Node& node, const Place& place);
  Blocks read_shape(const Node& node, const Place& place);
  std::optional<ShapeFaces> shape_parts(const Node& geometry, const Node* appearance);

  World& world_;
  Report& report_;
  const OpenDocument& document_;
};

Blocks Vrml97Reader::read(const Node& node, Place place) {
  if (!world_.enter(node, place)) return {};
  ++place.depth;
  if (!node.name.empty()) place.name = node.name;
  if (node.type == "Shape") return read_shape(node, place);
  if (node.type == "Transform") {
    return world_.under(matrix_of_transform(reader(node), "scale"), read_children(node, place), node);
  }
  if (node.type == "Group") return read_children(node, place);
  if (node.type == "Switch") return read_switch(node, place);
  if (node.type == "LOD") return read_first_level(node, place);
  if (node.type == "Inline") {
    return world_.inlined(node, reader(node).strings("url"), document_.folder, place);
  }
  if (node.type == "Anchor") {
    report_.add("link of an Anchor was lost", "links of Anchors were lost", "its children are kept");
    return read_children(node, place);
  }
  if (node.type == "Billboard") {
    report_.add("Billboard is static", "Billboards are static", "in VRML it faces the viewer");
    return read_children(node, place);
  }
  // The proxy of a Collision is invisible.
  if (node.type == "Collision") return read_children(node, place);
  report_.skip(node);
  return {};
}

Blocks Vrml97Reader::read_switch(const Node& node, const Place& place) {
  const auto choices = reader(node).nodes("choice");
  const int chosen = reader(node).integer("whichChoice", -1);
  const bool has_one = chosen >= 0 && static_cast<std::size_t>(chosen) < choices.size();
  report_.add("choice of a Switch was left out", "choices of Switches were left out",
              "whichChoice is another", choices.size() - (has_one ? 1 : 0));
  return has_one ? read(*choices[static_cast<std::size_t>(chosen)], place) : Blocks();
}

Blocks Vrml97Reader::read_first_level(const Node& node, const Place& place) {
  const auto levels = reader(node).nodes("level");
  if (levels.empty()) return {};
  report_.add("level of an LOD was left out", "levels of LODs were left out", "the first one is kept",
              levels.size() - 1);
  return read(*levels.front(), place);
}

Blocks Vrml97Reader::read_shape(const Node& node, const Place& place) {
  const Node* geometry = reader(node).node("geometry");
  if (geometry == nullptr) return {};
  if (!has_faces97(geometry->type)) {
    report_.skip(*geometry);
    return {};
  }
  const Node* appearance = report_.node_of(node, "appearance", "Appearance");
  const std::string_view own_name = node.name.empty() ? geometry->name : node.name;
  return world_.mesh({geometry, appearance}, node, own_name.empty() ? place.name : own_name,
                     [&] { return shape_parts(*geometry, appearance); });
}

std::optional<ShapeFaces> Vrml97Reader::shape_parts(const Node& geometry, const Node* appearance) {
  SurfaceInputs inputs;
  const Node* texture_transform = nullptr;
  if (appearance != nullptr) {
    inputs.name = appearance->name;
    inputs.material = report_.node_of(*appearance, "material", "Material");
    inputs.texture =
        texture_of(reader(*appearance).node("texture"), document_.folder, world_.path(), report_);
    texture_transform = report_.node_of(*appearance, "textureTransform", "TextureTransform");
  }
  auto polygons = polygons_of97(geometry, inputs.texture.has_value(), report_);
  if (!polygons) return std::nullopt;
  if (texture_transform != nullptr) transform_uvs(polygons->uvs, *texture_transform, report_);
  inputs.has_colours = !polygons->colours.empty() || !polygons->face_colours.empty();
  if (inputs.texture && inputs.has_colours) {
    report_.add("face lost its colours", "faces lost their colours", "its texture replaces them",
                polygons->face_count());
    polygons->colours.clear();
    polygons->face_colours.clear();
    inputs.has_colours = false;
  }
  const grf::Surface surface = world_.appearances().surface(inputs, polygons->face_count());
  if (surface.emission && !reader(geometry).flag("solid", true)) {
    report_.add("face emits only from its front", "faces emit only from their fronts",
                "emission in GRF is one-sided", polygons->face_count());
  }
  return ShapeFaces{std::move(*polygons), {surface}};
}

}  // namespace

std::vector<grf::Block> read_vrml97(World& world, const OpenDocument& document, const Place& place) {
  return Vrml97Reader(world, document).read_all(document.document->roots, place);
}

}  // namespace convert::vrml
