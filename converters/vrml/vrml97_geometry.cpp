#include "converters/vrml/vrml97_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "converters/vrml/face_list.h"
#include "converters/vrml/primitives.h"

namespace convert::vrml {
namespace {

/// Binds the normals, colours and texture coordinates of an IndexedFaceSet.
class FaceSetReader {
 public:
  FaceSetReader(const Node& node, Report& report)
      : node_(node), reader_(node, report.diagnostics()), report_(report) {}

  std::optional<Polygons> run(bool is_textured) {
    const Node* coord = report_.node_of(node_, "coord", "Coordinate");
    if (coord != nullptr) polygons_.positions = read_vectors(*coord, "point", report_);
    if (report_.failed()) return std::nullopt;
    auto faces = FaceList::read(reader_, polygons_.positions.size());
    if (!faces) return std::nullopt;
    polygons_.corners = faces->corners();
    polygons_.face_ends = faces->face_ends();
    report_.losses().add(Loss::DegenerateFace, faces->degenerate_faces());
    read_normals(*faces);
    read_face_colours(*faces);
    read_texture_coordinates(*faces);
    // Normals in the file are not changed; computed ones point to the front.
    if (!reader_.flag("ccw", true)) polygons_.reverse_faces();
    if (!has_normals_) add_crease_normals(polygons_, reader_.number("creaseAngle", 0));
    if (is_textured && polygons_.uvs.empty()) add_default_uvs(polygons_);
    if (report_.failed()) return std::nullopt;
    return std::move(polygons_);
  }

 private:
  void read_normals(const FaceList& faces) {
    const Node* node = report_.node_of(node_, "normal", "Normal");
    if (node == nullptr) return;
    const auto normals = read_vectors(*node, "vector", report_);
    has_normals_ = !normals.empty();
    if (normals.empty()) return;
    const bool per_vertex = reader_.flag("normalPerVertex", true);
    const auto bound = faces.bound(reader_, per_vertex ? Binding::IndexedCorners : Binding::IndexedFaces,
                                   "normalIndex", normals.size());
    if (!bound) return;
    polygons_.normals = picked(normals, *bound);
    if (!per_vertex) polygons_.normals = spread_over_corners(polygons_.normals, polygons_);
  }

  void read_face_colours(const FaceList& faces) {
    const Node* node = report_.node_of(node_, "color", "Color");
    if (node == nullptr) return;
    const auto colours = read_colours(*node, report_);
    if (colours.empty()) return;
    const bool per_vertex = reader_.flag("colorPerVertex", true);
    const auto bound = faces.bound(reader_, per_vertex ? Binding::IndexedCorners : Binding::IndexedFaces,
                                   "colorIndex", colours.size());
    if (bound) (per_vertex ? polygons_.colours : polygons_.face_colours) = picked(colours, *bound);
  }

  void read_texture_coordinates(const FaceList& faces) {
    const Node* node = report_.node_of(node_, "texCoord", "TextureCoordinate");
    if (node == nullptr) return;
    const auto uvs = read_uvs(*node, report_);
    if (uvs.empty()) return;
    const auto bound = faces.bound(reader_, Binding::IndexedCorners, "texCoordIndex", uvs.size());
    if (bound) polygons_.uvs = picked(uvs, *bound);
  }

  const Node& node_;
  NodeReader reader_;
  Report& report_;
  Polygons polygons_ = {};
  bool has_normals_ = false;
};

Polygons solid_of(const Node& node, Report& report) {
  const NodeReader reader(node, report.diagnostics());
  if (node.type == "Box") {
    const grf::Vec3d size = reader.triple("size", grf::Vec3d(2));
    if (!(std::min({size.x, size.y, size.z}) > 0)) reader.error_at("size", "the sizes are greater than 0");
    return make_box(size);
  }
  note_tessellation(report);
  if (node.type == "Sphere") return make_sphere(read_size(node, "radius", 1, report));
  const Ends ends{reader.flag("side", true), reader.flag("top", true), reader.flag("bottom", true)};
  const double height = read_size(node, "height", 2, report);
  return node.type == "Cone" ? make_cone(read_size(node, "bottomRadius", 1, report), height, ends)
                             : make_cylinder(read_size(node, "radius", 1, report), height, ends);
}

std::optional<Polygons> read_solid(const Node& node, bool is_textured, Report& report) {
  Polygons solid = solid_of(node, report);
  if (report.failed() || !report.count_generated(node, solid.face_count())) return std::nullopt;
  solid.face_materials.clear();
  if (!is_textured) solid.uvs.clear();
  return solid;
}

}  // namespace

bool has_faces97(std::string_view type) {
  constexpr std::array<std::string_view, 7> Types = {
      "Box", "Cone", "Cylinder", "ElevationGrid", "Extrusion", "IndexedFaceSet", "Sphere"};
  return std::find(Types.begin(), Types.end(), type) != Types.end();
}

std::optional<Polygons> polygons_of97(const Node& geometry, bool is_textured, Report& report) {
  if (geometry.type == "IndexedFaceSet") return FaceSetReader(geometry, report).run(is_textured);
  const bool is_grid = geometry.type == "ElevationGrid";
  if (!is_grid && geometry.type != "Extrusion") return read_solid(geometry, is_textured, report);
  auto polygons = is_grid ? read_elevation_grid(geometry, report) : read_extrusion(geometry, report);
  // Texture coordinates of the file are kept in any case.
  const bool made_here = NodeReader(geometry, report.diagnostics()).node("texCoord") == nullptr;
  if (polygons && made_here && !is_textured) polygons->uvs.clear();
  return polygons;
}

std::vector<grf::Colour> read_colours(const Node& node, Report& report) {
  auto colours = read_vectors(node, "color", report);
  std::size_t clamped = 0;
  for (grf::Colour& colour : colours) {
    const grf::Colour given = colour;
    for (int i = 0; i < 3; ++i) colour[i] = std::clamp(colour[i], 0.0F, 1.0F);
    if (colour != given) ++clamped;
  }
  report.add("colour of a vertex or face was clamped", "colours of vertices or faces were clamped",
             "components are from 0 to 1", clamped);
  return colours;
}

}  // namespace convert::vrml
