#include "converters/obj/obj.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "converters/mesh_builder.h"
#include "converters/obj/obj_materials.h"
#include "converters/obj/obj_text.h"
#include "converters/scene_parts.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"

namespace convert {
namespace {

/// Assimp's name for the object of faces that stand before any.
constexpr std::string_view NoObject = "defaultobject";

bool sniff(std::string_view first_bytes) {
  constexpr std::array<std::string_view, 12> FirstKeywords = {"v", "vt", "vn", "vp", "f",      "l",
                                                              "p", "o",  "g",  "s",  "mtllib", "usemtl"};
  StatementReader reader(std::make_shared<const std::string>(to_utf8(first_bytes)), nullptr);
  Statement first;
  return reader.next(first) &&
         std::find(FirstKeywords.begin(), FirstKeywords.end(), first.keyword) != FirstKeywords.end();
}

/// Parses statements that were checked; null if Assimp finds a fault all the same. No step of Assimp's own
/// follows, so that polygons stay whole and no face is removed or moved.
const aiScene* parse(Assimp::Importer& importer, const std::string& statements) {
  return importer.ReadFileFromMemory(statements.data(), statements.size(), 0, "obj");
}

// -0 is 0: it tells nothing, and would keep corners apart that are at one place.
grf::Vec3f to_vector(const aiVector3D& v) { return {v.x + 0.0F, v.y + 0.0F, v.z + 0.0F}; }

bool is_finite(const grf::Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

class ObjReader {
 public:
  ObjReader(const std::string& path, const SourceText& source, const ReadOptions& options,
            grf::Diagnostics& diagnostics)
      : location_{source.file, 0, 0},
        diagnostics_(diagnostics),
        materials_(path, options.brdf.value_or(default_brdf()), diagnostics) {}

  std::optional<grf::Scene> run(const ObjText& text);

 private:
  void read_object(const aiScene& imported, const aiNode& object);
  void read_faces(const aiScene& imported, const aiMesh& faces, MeshBuilder& builder);
  Corner corner_of(const aiMesh& faces, unsigned vertex);
  grf::Surface surface_of(const aiScene& imported, const aiMesh& faces);
  void report(const ObjText& text);

  std::optional<grf::Scene> fail(const std::string& message) {
    diagnostics_.error(location_, message);
    return std::nullopt;
  }

  grf::SourceLocation location_;
  grf::Diagnostics& diagnostics_;
  ObjMaterials materials_;
  Losses losses_;
  std::vector<grf::Block> meshes_;
  std::size_t face_count_ = 0;
  bool keeps_colours_ = true;
  bool finite_ = true;
};

std::optional<grf::Scene> ObjReader::run(const ObjText& text) {
  if (text.faces == 0) {
    report(text);
    return fail("the file has no faces, and nothing else can be kept");
  }
  Assimp::Importer importer;
  const aiScene* imported = parse(importer, text.statements);
  if (imported == nullptr) return fail(importer.GetErrorString());
  keeps_colours_ = text.uncoloured_vertices == 0;
  for (const LibraryName& library : text.libraries) materials_.read(library);
  for (unsigned i = 0; i < imported->mRootNode->mNumChildren; ++i) {
    read_object(*imported, *imported->mRootNode->mChildren[i]);
  }
  if (!finite_) return fail("a vertex or a normal is too large for a float");
  if (face_count_ != text.faces) {
    return fail(fmt::format("{} of {} faces could be read", face_count_, text.faces));
  }
  report(text);
  return scene_of(materials_.definitions(), std::move(meshes_), location_);
}

// A mesh of Assimp's is what an object has of one material, in the order of the file.
void ObjReader::read_object(const aiScene& imported, const aiNode& object) {
  const std::string name = object.mName.C_Str();
  MeshBuilder builder(name == NoObject ? "" : name);
  for (unsigned i = 0; i < object.mNumMeshes; ++i) {
    read_faces(imported, *imported.mMeshes[object.mMeshes[i]], builder);
  }
  if (builder.face_count() == 0) return;
  face_count_ += builder.face_count();
  grf::Block block;
  block.content = grf::Shared<grf::Mesh>(builder.take());
  block.location = location_;
  meshes_.push_back(std::move(block));
}

void ObjReader::read_faces(const aiScene& imported, const aiMesh& faces, MeshBuilder& builder) {
  const std::uint32_t surface = builder.surface(surface_of(imported, faces));
  std::vector<Corner> corners;
  for (const aiFace& face : std::span(faces.mFaces, faces.mNumFaces)) {
    corners.clear();
    for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
      corners.push_back(corner_of(faces, vertex));
    }
    builder.add_face(corners, surface);
  }
}

Corner ObjReader::corner_of(const aiMesh& faces, unsigned vertex) {
  Corner corner;
  corner.position = to_vector(faces.mVertices[vertex]);
  finite_ = finite_ && is_finite(corner.position);
  if (faces.HasNormals()) {
    const grf::Vec3f normal = to_vector(faces.mNormals[vertex]);
    finite_ = finite_ && is_finite(normal);
    // Where one face has normals, Assimp gives normals of no length to those that have none.
    if (normal != grf::Vec3f(0)) corner.normal = normal;
  }
  if (keeps_colours_ && faces.HasVertexColors(0)) {
    const aiColor4D& colour = faces.mColors[0][vertex];
    corner.colour = grf::Colour(colour.r, colour.g, colour.b);
  }
  return corner;
}

grf::Surface ObjReader::surface_of(const aiScene& imported, const aiMesh& faces) {
  const aiString assimp_name = imported.mMaterials[faces.mMaterialIndex]->GetName();
  std::string name = assimp_name.C_Str();
  if (name == NoMaterial && !materials_.has(name)) {
    if (!materials_.has("")) return {};
    name.clear();
  }
  return materials_.surface(name, faces.mNumFaces, losses_);
}

void ObjReader::report(const ObjText& text) {
  losses_.add(Loss::TextureCoordinates, text.textured_faces);
  losses_.add(Loss::SmoothingGroup, text.smooth_faces);
  losses_.add(Loss::ShortFace, text.short_faces);
  losses_.add(Loss::Line, text.lines);
  losses_.add(Loss::Point, text.points);
  if (!keeps_colours_) losses_.add(Loss::VertexColour, text.coloured_vertices);
  materials_.report(location_);
  losses_.report(location_, diagnostics_);
  if (text.unread.empty()) return;
  std::size_t count = 0;
  std::vector<std::string> keywords;
  for (const auto& [keyword, uses] : text.unread) {
    count += uses;
    keywords.push_back(keyword);
  }
  diagnostics_.warning(
      location_,
      fmt::format("{} not read: {}", counted(count, "statement was", "statements were"), listed(keywords)));
}

std::optional<Import> read_obj(const std::string& path, const ReadOptions& options,
                               grf::Diagnostics& diagnostics) {
  const auto source = read_source_text(path, "an OBJ model", diagnostics);
  if (!source) return std::nullopt;
  const auto text = check_obj(*source, diagnostics);
  if (!text) return std::nullopt;
  auto scene = ObjReader(path, *source, options, diagnostics).run(*text);
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
  format.keeps = "polygons, shared vertices, normals, vertex colours, objects, materials, emission";
  format.loses =
      "textures and their coordinates, bump and other maps, transparency, smoothing groups, lines, points, "
      "curves, vertices without faces";
  return format;
}

}  // namespace convert
