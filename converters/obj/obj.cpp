#include "converters/obj/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <span>
#include <utility>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "converters/mesh_builder.h"
#include "converters/obj/mtl.h"
#include "converters/obj/mtl_writer.h"
#include "converters/obj/obj_materials.h"
#include "converters/obj/obj_text.h"
#include "converters/obj/obj_writer.h"
#include "converters/scene_parts.h"
#include "converters/smooth_normals.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"

namespace convert {
namespace {

// Elements come behind vertices, so that none is first. NFF files begin with the same letters: a `v` without
// numbers, an `s` with four.
bool sniff(std::string_view first_bytes) {
  constexpr std::array<std::string_view, 7> FirstKeywords = {"vt", "vn", "vp", "o", "g", "mtllib", "usemtl"};
  StatementReader reader(std::make_shared<const std::string>(to_utf8(first_bytes)), nullptr);
  Statement first;
  if (!reader.next(first)) return false;
  if (first.keyword == "v") return !first.arguments.empty();
  if (first.keyword == "s") return first.arguments.size() <= 1;
  return std::find(FirstKeywords.begin(), FirstKeywords.end(), first.keyword) != FirstKeywords.end();
}

/// Parses statements that were checked; null if Assimp finds a fault all the same. No step of Assimp's own
/// follows, so that polygons stay whole and no face is removed or moved.
const aiScene* parse(Assimp::Importer& importer, const std::string& statements) {
  return importer.ReadFileFromMemory(statements.data(), statements.size(), 0, "obj");
}

/// The index that the statements call a group or a material by.
std::size_t index_of(const aiString& name) {
  std::size_t index = std::numeric_limits<std::size_t>::max();
  std::from_chars(name.data, name.data + name.length, index);
  return index;
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
  void smooth(const aiScene& imported);
  void read_object(const aiScene& imported, const aiNode& object);
  void read_mesh(const aiMesh& mesh, MeshBuilder& builder);
  void read_faces(const aiMesh& mesh, std::span<const aiFace> faces, std::uint32_t index,
                  MeshBuilder& builder);
  void read_corners(const aiMesh& faces, const aiFace& face);
  std::uint32_t vertex(std::uint32_t corner, const UvTransform& uv, std::uint32_t group,
                       MeshBuilder& builder);
  Corner corner_of(const ObjCorner& indices, const UvTransform& uv, std::uint32_t group) const;
  ObjSurface surface_of(std::uint32_t material, std::size_t faces);
  std::uint32_t number_at_face(const std::vector<FaceRun>& runs, std::size_t& begun) const;
  std::uint32_t next_group();
  void report();

  std::optional<grf::Scene> fail(const std::string& message) {
    diagnostics_.error(location_, message);
    return std::nullopt;
  }

  grf::SourceLocation location_;
  grf::Diagnostics& diagnostics_;
  ObjMaterials materials_;
  ObjText text_;
  SmoothNormals smooth_normals_;
  Losses losses_;
  std::vector<grf::Block> meshes_;
  std::vector<std::uint32_t> corners_;           // of the face being read
  std::vector<std::uint32_t> vertices_;          // the same in the mesh
  std::vector<std::uint32_t> vertex_of_corner_;  // in the mesh being built
  std::vector<std::uint32_t> corners_with_vertex_;
  std::size_t face_ = 0;  // how many were read
  // How many runs have begun.
  std::size_t smoothing_run_ = 0;
  std::size_t material_run_ = 0;
  bool is_sound_ = true;
};

std::optional<grf::Scene> ObjReader::run(ObjText text) {
  text_ = std::move(text);
  if (text_.faces == 0) {
    report();
    return fail("the file has no faces, and nothing else can be kept");
  }
  Assimp::Importer importer;
  const aiScene* imported = parse(importer, text_.statements);
  if (imported == nullptr) return fail(importer.GetErrorString());
  std::string().swap(text_.statements);
  if (!text_.smoothing.empty()) smooth(*imported);
  vertex_of_corner_.assign(text_.corners.size(), ObjCorner::None);
  face_ = 0;
  smoothing_run_ = 0;
  for (unsigned i = 0; i < imported->mRootNode->mNumChildren; ++i) {
    read_object(*imported, *imported->mRootNode->mChildren[i]);
  }
  if (face_ != text_.faces || !is_sound_) {
    return fail(fmt::format("{} of {} faces could be read", face_, text_.faces));
  }
  report();
  return scene_of(materials_.definitions(), std::move(meshes_), location_);
}

// The faces of a group may be in several objects.
void ObjReader::smooth(const aiScene& imported) {
  const auto add = [this](const aiMesh& mesh) {
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
      const std::uint32_t group = next_group();
      if (group == 0) continue;
      read_corners(mesh, face);
      for (std::uint32_t& corner : corners_) corner = text_.corners[corner].vertex;
      smooth_normals_.add_face(group, corners_, text_.positions);
    }
  };
  for (const aiNode* object : std::span(imported.mRootNode->mChildren, imported.mRootNode->mNumChildren)) {
    for (const unsigned mesh : std::span(object->mMeshes, object->mNumMeshes)) add(*imported.mMeshes[mesh]);
  }
}

// The faces of an object are in the order of the file.
void ObjReader::read_object(const aiScene& imported, const aiNode& object) {
  const std::size_t index = index_of(object.mName);
  is_sound_ = is_sound_ && index < text_.meshes.size();
  if (!is_sound_) return;
  MeshBuilder builder(text_.meshes[index]);
  for (unsigned i = 0; i < object.mNumMeshes; ++i) {
    read_mesh(*imported.mMeshes[object.mMeshes[i]], builder);
  }
  for (const std::uint32_t corner : corners_with_vertex_) vertex_of_corner_[corner] = ObjCorner::None;
  corners_with_vertex_.clear();
  if (builder.face_count() == 0) return;
  grf::Block block;
  block.content = grf::Shared<grf::Mesh>(builder.take());
  block.location = location_;
  meshes_.push_back(std::move(block));
}

void ObjReader::read_mesh(const aiMesh& mesh, MeshBuilder& builder) {
  for (unsigned first = 0; first < mesh.mNumFaces;) {
    is_sound_ = is_sound_ && face_ < text_.faces;
    if (!is_sound_) return;
    const std::uint32_t material = number_at_face(text_.material_runs, material_run_);
    const std::size_t end = material_run_ < text_.material_runs.size()
                                ? text_.material_runs[material_run_].first_face
                                : text_.faces;
    const auto count = static_cast<unsigned>(std::min<std::size_t>(mesh.mNumFaces - first, end - face_));
    read_faces(mesh, std::span(mesh.mFaces + first, count), material, builder);
    first += count;
  }
}

void ObjReader::read_faces(const aiMesh& mesh, std::span<const aiFace> faces, std::uint32_t index,
                           MeshBuilder& builder) {
  const ObjSurface material = surface_of(index, faces.size());
  const std::uint32_t surface = builder.surface(material.surface);
  for (const aiFace& face : faces) {
    const std::uint32_t group = next_group();
    read_corners(mesh, face);
    vertices_.clear();
    for (const std::uint32_t corner : corners_) {
      vertices_.push_back(vertex(corner, material.uv, group, builder));
    }
    builder.add_face(vertices_, surface);
  }
}

void ObjReader::read_corners(const aiMesh& faces, const aiFace& face) {
  corners_.clear();
  for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
    const aiVector3D& coordinates = faces.mVertices[vertex];
    const std::uint32_t corner = corner_at({coordinates.x, coordinates.y, coordinates.z});
    is_sound_ = is_sound_ && corner < text_.corners.size();
    corners_.push_back(is_sound_ ? corner : 0);
  }
}

// Most corners stand for the same vertex each time.
std::uint32_t ObjReader::vertex(std::uint32_t corner, const UvTransform& uv, std::uint32_t group,
                                MeshBuilder& builder) {
  const ObjCorner& indices = text_.corners[corner];
  if (group != 0 || !uv.is_identity()) return builder.vertex(corner_of(indices, uv, group));
  std::uint32_t& known = vertex_of_corner_[corner];
  if (known == ObjCorner::None) {
    known = builder.vertex(corner_of(indices, uv, group));
    corners_with_vertex_.push_back(corner);
  }
  return known;
}

Corner ObjReader::corner_of(const ObjCorner& indices, const UvTransform& uv, std::uint32_t group) const {
  Corner corner;
  corner.position = text_.positions[indices.vertex];
  if (text_.colours.has(indices.vertex)) corner.colour = text_.colours[indices.vertex];
  if (indices.texture_coordinate != ObjCorner::None) {
    const grf::Vec2f& written = text_.texture_coordinates[indices.texture_coordinate];
    corner.uv = uv.is_identity() ? written : uv.apply(written);
  }
  if (indices.normal != ObjCorner::None) {
    corner.normal = text_.normals[indices.normal];
  } else if (group != 0) {
    corner.normal = smooth_normals_.normal(group, indices.vertex);
  }
  return corner;
}

/// What the run of the next face has in common; 0 before the first. Faces come in the order of the file.
std::uint32_t ObjReader::number_at_face(const std::vector<FaceRun>& runs, std::size_t& begun) const {
  while (begun < runs.size() && runs[begun].first_face <= face_) ++begun;
  return begun == 0 ? 0 : runs[begun - 1].number;
}

std::uint32_t ObjReader::next_group() {
  const std::uint32_t group = number_at_face(text_.smoothing, smoothing_run_);
  ++face_;
  return group;
}

ObjSurface ObjReader::surface_of(std::uint32_t material, std::size_t faces) {
  if (material == 0) return {};
  const std::string& name = text_.materials[material];
  if (name.empty() && !materials_.has(name)) return {};
  return materials_.surface(name, faces, losses_);
}

void ObjReader::report() {
  losses_.add(Loss::ShortFace, text_.short_faces);
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
  auto text = check_obj(*source, diagnostics);
  if (!text) return std::nullopt;
  ObjReader reader(path, *source, options, diagnostics);
  reader.read_libraries(*text);
  source->text.reset();  // Assimp needs the memory
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
  format.sniff = sniff;
  format.read = read_obj;
  format.write = write_obj;
  format.keeps =
      "polygons, shared vertices, normals or smoothing groups, texture coordinates, vertex colours, objects, "
      "materials, textures, emission";
  format.loses =
      "transforms and instances (applied), irradiance, sampling schemes, comments; when read: bump and other "
      "maps, transparency, lines, points, curves, vertices without faces";
  format.read_materials = mtl_rules();
  format.written_materials = mtl_writer_rules();
  return format;
}

}  // namespace convert
