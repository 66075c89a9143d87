#include "converters/vrml/vrml1_shapes.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "converters/vrml/face_list.h"
#include "converters/vrml/geometry_readers.h"
#include "converters/vrml/primitives.h"

namespace convert::vrml {
namespace {

/// A count larger than any list: materials are repeated cyclically.
constexpr std::size_t AnyNumber = std::size_t{1} << 31U;

/// Returns how values are bound by a MaterialBinding or NormalBinding; nothing: one value for all.
struct ReadBinding {
  std::optional<Binding> binding;
  bool is_default = true;
};

ReadBinding binding_of(const Node* node, Report& report) {
  if (node == nullptr) return {};
  const NodeReader reader(*node, report.diagnostics());
  const auto words = reader.words("value");
  if (words.empty() || words[0] == "DEFAULT") return {};
  const std::string_view word = words[0];
  if (word == "OVERALL") return {std::nullopt, false};
  if (word == "PER_PART" || word == "PER_FACE") return {Binding::FacesInOrder, false};
  if (word == "PER_PART_INDEXED" || word == "PER_FACE_INDEXED") return {Binding::IndexedFaces, false};
  if (word == "PER_VERTEX") return {Binding::CornersInOrder, false};
  if (word == "PER_VERTEX_INDEXED") return {Binding::IndexedCorners, false};
  reader.error_at("value", fmt::format("'{}' is not a binding", word));
  return {};
}

Ends ends_of(const Node& node, Report& report) {
  const auto parts = NodeReader(node, report.diagnostics()).words("parts");
  const auto has = [&parts](std::string_view part) {
    const auto is_it = [part](std::string_view word) { return word == part || word == "ALL"; };
    return parts.empty() || std::any_of(parts.begin(), parts.end(), is_it);
  };
  return {has("SIDES"), has("TOP"), has("BOTTOM")};
}

Polygons vrml1_solid_of(const Node& node, Report& report) {
  const auto size = [&](std::string_view field, double fallback) {
    return read_size(node, field, fallback, report);
  };
  if (node.type == "Cube") return make_box({size("width", 2), size("height", 2), size("depth", 2)});
  note_tessellation(report);
  if (node.type == "Sphere") return make_sphere(size("radius", 1));
  const Ends ends = ends_of(node, report);
  if (node.type == "Cone") return make_cone(size("bottomRadius", 1), size("height", 2), ends);
  return make_cylinder(size("radius", 1), size("height", 2), ends);
}

class ShapeReader {
 public:
  ShapeReader(const Node& shape, const Vrml1State& state, const OpenDocument& document, World& world)
      : shape_(shape),
        reader_(shape, world.report().diagnostics()),
        state_(state),
        world_(world),
        report_(world.report()) {
    inputs_.material = state.material;
    inputs_.texture = texture_of(state.texture, document.folder, world.path(), report_);
  }

  std::optional<ShapeFaces> run() {
    if (shape_.type == "IndexedFaceSet") {
      read_faces();
    } else {
      read_solid();
    }
    if (report_.failed()) return std::nullopt;
    if (state_.texture_transform != nullptr) {
      transform_uvs(parts_.polygons.uvs, *state_.texture_transform, report_);
    }
    if (report_.failed()) return std::nullopt;
    return std::move(parts_);
  }

 private:
  void read_solid() {
    parts_.polygons = vrml1_solid_of(shape_, report_);
    if (!report_.count_generated(shape_, parts_.polygons.face_count())) return;
    if (!inputs_.texture) parts_.polygons.uvs.clear();
    std::vector<std::uint32_t> materials = std::move(parts_.polygons.face_materials);
    parts_.polygons.face_materials.clear();
    const auto binding = binding_of(state_.material_binding, report_).binding;
    const bool has_parts = binding == Binding::FacesInOrder || binding == Binding::IndexedFaces;
    if (!has_parts || shape_.type == "Sphere") return look_the_same();
    look_by_faces(std::move(materials));
  }

  void read_faces();
  void read_normals(const FaceList& faces);
  void read_texture_coordinates(const FaceList& faces);
  void read_materials(const FaceList& faces);
  void look_the_same() {
    parts_.surfaces = {world_.appearances().surface(inputs_, parts_.polygons.face_count())};
  }
  void look_by_faces(std::vector<std::uint32_t> materials);
  void look_by_corners(std::vector<std::uint32_t> materials);

  const Node& shape_;
  NodeReader reader_;
  const Vrml1State& state_;
  World& world_;
  Report& report_;
  SurfaceInputs inputs_;
  ShapeFaces parts_ = {};
};

void ShapeReader::read_faces() {
  Polygons& polygons = parts_.polygons;
  if (state_.coordinates != nullptr) {
    polygons.positions = read_vectors(*state_.coordinates, "point", report_);
  }
  if (report_.failed()) return;
  const auto faces = FaceList::read(reader_, polygons.positions.size());
  if (!faces) return;
  polygons.corners = faces->corners();
  polygons.face_ends = faces->face_ends();
  report_.losses().add(Loss::DegenerateFace, faces->degenerate_faces());
  read_normals(*faces);
  read_texture_coordinates(*faces);
  read_materials(*faces);
  if (report_.failed()) return;
  double crease_angle = 0.5;
  if (state_.shape_hints != nullptr) {
    const NodeReader hints(*state_.shape_hints, report_.diagnostics());
    const auto ordering = hints.words("vertexOrdering");
    if (!ordering.empty() && ordering[0] == "CLOCKWISE") polygons.reverse_faces();
    crease_angle = hints.number("creaseAngle", crease_angle);
  }
  if (polygons.normals.empty()) add_crease_normals(polygons, crease_angle);
}

// If the state has too few normals for the shape, they belong to other shapes: normals are computed.
void ShapeReader::read_normals(const FaceList& faces) {
  if (state_.normals == nullptr) return;
  const auto normals = read_vectors(*state_.normals, "vector", report_);
  const ReadBinding read = binding_of(state_.normal_binding, report_);
  Polygons& polygons = parts_.polygons;
  if (!read.binding && !read.is_default) {
    if (!normals.empty()) polygons.normals.assign(polygons.corners.size(), normals.front());
    return;
  }
  const Binding binding = read.binding.value_or(Binding::IndexedCorners);
  const bool has_list = !index_list(reader_, "normalIndex").empty();
  if (!has_list && !faces.has_enough(reader_, binding, "normalIndex", normals.size())) return;
  const auto bound = faces.bound(reader_, binding, "normalIndex", normals.size());
  if (!bound) return;
  polygons.normals = picked(normals, *bound);
  if (!is_of_corners(binding)) polygons.normals = spread_over_corners(polygons.normals, polygons);
}

void ShapeReader::read_texture_coordinates(const FaceList& faces) {
  constexpr std::string_view Indices = "textureCoordIndex";
  if (state_.texture_coordinates != nullptr) {
    const auto uvs = read_uvs(*state_.texture_coordinates, report_);
    const bool has_list = !index_list(reader_, Indices).empty();
    if (has_list || faces.has_enough(reader_, Binding::IndexedCorners, Indices, uvs.size())) {
      const auto bound = faces.bound(reader_, Binding::IndexedCorners, Indices, uvs.size());
      if (bound) parts_.polygons.uvs = picked(uvs, *bound);
      return;
    }
  }
  if (inputs_.texture) add_default_uvs(parts_.polygons);
}

void ShapeReader::read_materials(const FaceList& faces) {
  const auto binding = binding_of(state_.material_binding, report_).binding;
  const bool is_one = state_.material == nullptr || material_count(*state_.material, report_) == 1;
  if (!binding || is_one) return look_the_same();
  auto bound = faces.bound(reader_, *binding, "materialIndex", AnyNumber);
  if (!bound) return;
  if (is_of_corners(*binding)) return look_by_corners(std::move(*bound));
  look_by_faces(std::move(*bound));
}

/// Binds materials to faces, cyclically.
void ShapeReader::look_by_faces(std::vector<std::uint32_t> materials) {
  if (state_.material == nullptr) return look_the_same();
  const std::size_t count = material_count(*state_.material, report_);
  for (std::uint32_t& material : materials) material %= static_cast<std::uint32_t>(count);
  if (count > 1 && differs_in_diffuse_colour_alone(*state_.material, report_)) {
    parts_.polygons.face_colours = picked(diffuse_colours(*state_.material, report_), materials);
    inputs_.has_colours = true;
    return look_the_same();
  }
  std::map<std::uint32_t, std::size_t> faces_of;
  for (const std::uint32_t material : materials) ++faces_of[material];
  std::map<std::uint32_t, std::uint32_t> surface_of;
  for (const auto& [material, faces] : faces_of) {
    inputs_.index = material;
    surface_of[material] = static_cast<std::uint32_t>(parts_.surfaces.size());
    parts_.surfaces.push_back(world_.appearances().surface(inputs_, faces));
  }
  for (std::uint32_t& material : materials) material = surface_of[material];
  parts_.polygons.face_materials = std::move(materials);
  if (parts_.surfaces.empty()) look_the_same();
}

/// Binds diffuse colours of materials to corners.
void ShapeReader::look_by_corners(std::vector<std::uint32_t> materials) {
  const auto colours = diffuse_colours(*state_.material, report_);
  for (std::uint32_t& material : materials) material %= static_cast<std::uint32_t>(colours.size());
  parts_.polygons.colours = picked(colours, materials);
  if (!differs_in_diffuse_colour_alone(*state_.material, report_)) {
    report_.add("face has one material", "faces have one material",
                "only the diffuse colours of those of their corners are kept", parts_.polygons.face_count());
  }
  inputs_.has_colours = true;
  look_the_same();
}

}  // namespace

bool is_shape1(std::string_view type) {
  constexpr std::array<std::string_view, 5> Types = {"Cone", "Cube", "Cylinder", "IndexedFaceSet", "Sphere"};
  return std::find(Types.begin(), Types.end(), type) != Types.end();
}

std::vector<const Node*> parts_of_shape1(const Node& shape, const Vrml1State& state) {
  std::vector<const Node*> parts = {&shape, state.material, state.material_binding, state.texture,
                                    state.texture_transform};
  if (shape.type == "IndexedFaceSet") {
    parts.insert(parts.end(), {state.coordinates, state.normals, state.normal_binding,
                               state.texture_coordinates, state.shape_hints});
  }
  return parts;
}

std::optional<ShapeFaces> read_shape1(const Node& shape, const Vrml1State& state,
                                      const OpenDocument& document, World& world) {
  return ShapeReader(shape, state, document, world).run();
}

}  // namespace convert::vrml
