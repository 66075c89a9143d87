#include "converters/obj/obj.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "converters/mesh_builder.h"
#include "converters/obj/mtl.h"
#include "converters/obj/mtl_writer.h"
#include "converters/obj/obj_materials.h"
#include "converters/obj/obj_text.h"
#include "converters/obj/obj_writer.h"
#include "converters/scene_building.h"
#include "converters/smoothing_groups.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"

namespace convert {
namespace {

// Faces follow vertices, so that no file begins with them. NFF files begin with the same letters: a `v`
// without numbers, an `s` with four.
bool sniff_obj(std::string_view first_bytes) {
  constexpr std::array<std::string_view, 7> FirstKeywords = {"vt", "vn", "vp", "o", "g", "mtllib", "usemtl"};
  StatementReader reader(std::make_shared<const std::string>(to_utf8(first_bytes)), nullptr);
  Statement first;
  if (!reader.next(first)) return false;
  if (first.keyword == "v") return !first.arguments.empty();
  if (first.keyword == "s") return first.arguments.size() <= 1;
  return std::find(FirstKeywords.begin(), FirstKeywords.end(), first.keyword) != FirstKeywords.end();
}

class ObjReader {
 public:
  ObjReader(const std::string& path, const SourceText& source, const ReadOptions& options,
            grf::Diagnostics& diagnostics)
      : location_{source.file, 0, 0},
        diagnostics_(diagnostics),
        materials_(path, options.brdf.value_or(default_brdf()), diagnostics) {}

  void read_libraries(const ObjText& text) {
    for (const LibraryName& library : text.libraries) materials_.read(library);
  }
  std::optional<grf::Scene> run(ObjText text);

 private:
  void smooth();
  void read_faces(std::size_t first, std::size_t end, std::uint32_t index, FaceRuns::Cursor& groups,
                  MeshBuilder& builder);
  void add_mesh(MeshBuilder& builder);
  std::uint32_t vertex(std::uint32_t corner, const UvTransform& uv, std::uint32_t group,
                       MeshBuilder& builder);
  Corner corner_of(const ObjCorner& indices, const UvTransform& uv, std::uint32_t group) const;
  ObjSurface surface_of(std::uint32_t material, std::size_t faces);
  void report();

  grf::SourceLocation location_;
  grf::Diagnostics& diagnostics_;
  ObjMaterials materials_;
  ObjText text_;
  SmoothingGroups smoothing_groups_;
  Losses losses_;
  std::vector<grf::Block> meshes_;
  std::vector<std::uint32_t> vertices_;          // vertices of the current face
  std::vector<std::uint32_t> vertex_of_corner_;  // vertex index in the current mesh
  std::vector<std::uint32_t> corners_with_vertex_;
};

std::optional<grf::Scene> ObjReader::run(ObjText text) {
  text_ = std::move(text);
  const std::size_t faces = text_.face_count();
  if (faces == 0) {
    report();
    diagnostics_.error(location_, "the file has no faces, and only faces can be imported");
    return std::nullopt;
  }
  if (!text_.smoothing.empty()) smooth();
  vertex_of_corner_.assign(text_.corners.size(), ObjCorner::InvalidIndex);
  FaceRuns::Cursor meshes(text_.mesh_of_face);
  FaceRuns::Cursor materials(text_.material_of_face);
  FaceRuns::Cursor groups(text_.smoothing);
  for (std::size_t first = 0; first < faces;) {
    MeshBuilder builder(text_.meshes[meshes.number_of(first)]);
    for (const std::size_t end = meshes.end_of_run(faces); first < end;) {
      const std::uint32_t material = materials.number_of(first);
      const std::size_t end_of_run = std::min(end, materials.end_of_run(faces));
      read_faces(first, end_of_run, material, groups, builder);
      first = end_of_run;
    }
    add_mesh(builder);
  }
  report();
  return scene_of(materials_.definitions(), std::move(meshes_), location_);
}

// The faces of a group may be in several meshes.
void ObjReader::smooth() {
  FaceRuns::Cursor groups(text_.smoothing);
  for (std::size_t face = 0; face < text_.face_count(); ++face) {
    const std::uint32_t group = groups.number_of(face);
    if (group == 0) continue;
    vertices_.clear();
    for (const std::uint32_t corner : text_.face(face)) vertices_.push_back(text_.corners[corner].vertex);
    smoothing_groups_.add_face(group, vertices_, text_.positions);
  }
}

/// Reads faces of one mesh and one material.
void ObjReader::read_faces(std::size_t first, std::size_t end, std::uint32_t index, FaceRuns::Cursor& groups,
                           MeshBuilder& builder) {
  const ObjSurface material = surface_of(index, end - first);
  const std::uint32_t surface = builder.surface(material.surface);
  for (std::size_t face = first; face < end; ++face) {
    const std::uint32_t group = groups.number_of(face);
    vertices_.clear();
    for (const std::uint32_t corner : text_.face(face)) {
      vertices_.push_back(vertex(corner, material.uv, group, builder));
    }
    builder.add_face(vertices_, surface);
  }
}

void ObjReader::add_mesh(MeshBuilder& builder) {
  for (const std::uint32_t corner : corners_with_vertex_) vertex_of_corner_[corner] = ObjCorner::InvalidIndex;
  corners_with_vertex_.clear();
  grf::Block block;
  block.content = grf::Shared<grf::Mesh>(builder.take());
  block.location = location_;
  meshes_.push_back(std::move(block));
}

// Most corners give the same vertex each time.
std::uint32_t ObjReader::vertex(std::uint32_t corner, const UvTransform& uv, std::uint32_t group,
                                MeshBuilder& builder) {
  const ObjCorner& indices = text_.corners[corner];
  if (group != 0 || !uv.is_identity()) return builder.vertex(corner_of(indices, uv, group));
  std::uint32_t& known = vertex_of_corner_[corner];
  if (known == ObjCorner::InvalidIndex) {
    known = builder.vertex(corner_of(indices, uv, group));
    corners_with_vertex_.push_back(corner);
  }
  return known;
}

Corner ObjReader::corner_of(const ObjCorner& indices, const UvTransform& uv, std::uint32_t group) const {
  Corner corner;
  corner.position = text_.positions[indices.vertex];
  if (text_.colours.has(indices.vertex)) corner.colour = text_.colours[indices.vertex];
  if (indices.texture_coordinate != ObjCorner::InvalidIndex) {
    const grf::Vec2f& written = text_.texture_coordinates[indices.texture_coordinate];
    corner.uv = uv.is_identity() ? written : uv.apply(written);
  }
  if (indices.normal != ObjCorner::InvalidIndex) {
    corner.normal = text_.normals[indices.normal];
  } else if (group != 0) {
    corner.normal = smoothing_groups_.normal(group, indices.vertex);
  }
  return corner;
}

ObjSurface ObjReader::surface_of(std::uint32_t material, std::size_t faces) {
  if (material == 0) return {};
  const std::string& name = text_.materials[material];
  if (name.empty() && !materials_.has(name)) return {};
  return materials_.surface(name, faces, losses_);
}

void ObjReader::report() {
  losses_.add(Loss::DegenerateFace, text_.degenerate_faces);
  losses_.add(Loss::Line, text_.lines);
  losses_.add(Loss::Point, text_.points);
  losses_.add(Loss::LooseVertex, text_.loose_vertices);
  losses_.add(Loss::DeepTextureCoordinate, text_.deep_texture_coordinates);
  materials_.report(location_);
  losses_.report(location_, diagnostics_);
  if (text_.unread.empty()) return;
  std::size_t count = 0;
  std::vector<std::string> keywords;
  for (const auto& [keyword, uses] : text_.unread) {
    count += uses;
    keywords.push_back(keyword);
  }
  diagnostics_.warning(
      location_,
      fmt::format("{} not read: {}", counted(count, "statement was", "statements were"), listed(keywords)));
}

std::optional<Import> read_obj(const std::string& path, const ReadOptions& options,
                               grf::Diagnostics& diagnostics) {
  auto source = read_source_text(path, "an OBJ model", diagnostics);
  if (!source) return std::nullopt;
  auto text = parse_obj(*source, diagnostics);
  if (!text) return std::nullopt;
  ObjReader reader(path, *source, options, diagnostics);
  reader.read_libraries(*text);
  source->text.reset();  // frees memory for the meshes
  auto scene = reader.run(std::move(*text));
  if (!scene) return std::nullopt;
  return Import{std::move(*scene), {}};
}

}  // namespace

Format obj_format() {
  Format format;
  format.name = "obj";
  format.title = "Wavefront OBJ with MTL materials";
  format.extensions = {"obj"};
  format.sniff = sniff_obj;
  format.read = read_obj;
  format.write = write_obj;
  format.keeps =
      "polygons, shared vertices, normals or smoothing groups, texture coordinates, vertex colours, objects, "
      "materials, textures, emission, opacity";
  format.loses =
      "transforms and instances (applied), irradiance, sampling schemes, comments; when read: bump and other "
      "maps, refraction, lines, points, curves, vertices without faces";
  format.read_materials = mtl_rules();
  format.written_materials = mtl_writer_rules();
  return format;
}

}  // namespace convert
