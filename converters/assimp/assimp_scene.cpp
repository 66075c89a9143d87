#include "converters/assimp/assimp_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "converters/assimp/assimp_import.h"
#include "converters/assimp/assimp_materials.h"
#include "converters/assimp/assimp_nodes.h"
#include "converters/assimp/assimp_textures.h"
#include "converters/materials.h"
#include "converters/mesh_builder.h"
#include "converters/scene_building.h"
#include "converters/wording.h"

namespace convert {
namespace {

// Normalises -0 to 0, so that equal corners share a vertex.
grf::Vec3f to_vector(const aiVector3D& v) { return {v.x + 0.0F, v.y + 0.0F, v.z + 0.0F}; }

bool is_finite(const grf::Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

class SceneMaker {
 public:
  SceneMaker(const aiScene& imported, const AssimpRules& rules, Losses losses, grf::SourceLocation location,
             grf::Diagnostics& diagnostics)
      : imported_(imported),
        rules_(rules),
        losses_(losses),
        location_(std::move(location)),
        diagnostics_(diagnostics),
        textures_(imported) {}

  std::optional<Import> run();

 private:
  /// Returns a material of the file, or none if Assimp invented it.
  struct Material {
    AssimpMaterial read;
    std::optional<std::size_t> index;
  };

  void read_materials();
  std::vector<grf::Block> blocks_of(const aiNode& node);
  std::vector<grf::Block> contents_of(const aiNode& node);
  std::vector<grf::Block> unplaced_meshes();
  std::optional<grf::Block> block_of(const MeshGroup& group, const std::string& node_name);
  grf::Mesh build(const MeshGroup& group, const std::string& name);
  void add_faces(const aiMesh& mesh, MeshBuilder& builder);
  void count_losses(const aiMesh& mesh, std::size_t faces);
  Corner corner_of(const aiMesh& mesh, const AssimpMaterial& material, unsigned vertex);
  void report();

  const aiScene& imported_;
  const AssimpRules& rules_;
  Losses losses_;
  grf::SourceLocation location_;
  grf::Diagnostics& diagnostics_;
  EmbeddedTextures textures_;
  DefinitionNames names_;
  Materials materials_{names_};
  std::vector<Material> material_of_index_;
  GroupUses uses_;
  std::map<MeshGroup, std::optional<std::string>> defined_;  // empty: a group without faces
  std::vector<grf::Definition> mesh_definitions_;
  std::size_t face_count_ = 0;
  std::size_t unplaced_ = 0;
  std::size_t odd_normals_ = 0;
  bool finite_ = true;
};

std::optional<Import> SceneMaker::run() {
  const auto fail = [&](const std::string& message) {
    diagnostics_.error(location_, message);
    return std::nullopt;
  };
  if (const std::string fault = fault_of(imported_); !fault.empty()) return fail(fault);
  uses_ = count_uses(*imported_.mRootNode);
  read_materials();
  std::vector<grf::Block> blocks =
      rules_.root_is_conversion ? contents_of(*imported_.mRootNode) : blocks_of(*imported_.mRootNode);
  for (grf::Block& block : unplaced_meshes()) blocks.push_back(std::move(block));
  if (!finite_) return fail("a vertex is not finite, or too large for a float");
  report();
  if (face_count_ == 0) return fail("the file has no faces, and only faces can be imported");
  std::vector<grf::Definition> definitions = materials_.definitions();
  std::move(mesh_definitions_.begin(), mesh_definitions_.end(), std::back_inserter(definitions));
  return Import{scene_of(std::move(definitions), std::move(blocks), location_), textures_.take()};
}

void SceneMaker::read_materials() {
  for (const aiMaterial* material : std::span(imported_.mMaterials, imported_.mNumMaterials)) {
    Material result = {read_material(*material, rules_), {}};
    if (!is_invented(*material, rules_)) {
      PhongMaterial& phong = result.read.phong;
      phong.location = location_;
      if (phong.diffuse_map) {
        phong.diffuse_map = grf::Texture{textures_.file_of(phong.diffuse_map->file), location_};
      }
      result.index = materials_.add(map_material(phong));
    }
    material_of_index_.push_back(std::move(result));
  }
}

std::vector<grf::Block> SceneMaker::blocks_of(const aiNode& node) {
  grf::Matrix44d matrix;
  const aiNode* inner = &node;
  for (;;) {
    const auto step = invertible_transform(*inner);
    if (!step) {
      losses_.add(Loss::SingularTransform, placed_groups(*inner));
      return {};
    }
    matrix = *step * matrix;
    // A node that only transforms a single child is merged with it.
    const std::vector<const aiNode*> children = children_of(*inner);
    if (inner->mNumMeshes > 0 || children.size() != 1) break;
    inner = children[0];
  }
  return placed(contents_of(*inner), matrix, location_);
}

std::vector<grf::Block> SceneMaker::contents_of(const aiNode& node) {
  std::vector<grf::Block> blocks;
  if (node.mNumMeshes > 0) {
    if (auto block = block_of(group_of(node), name_of(node))) blocks.push_back(std::move(*block));
  }
  for (const aiNode* child : children_of(node)) {
    for (grf::Block& block : blocks_of(*child)) blocks.push_back(std::move(block));
  }
  return blocks;
}

std::vector<grf::Block> SceneMaker::unplaced_meshes() {
  std::vector<bool> is_placed(imported_.mNumMeshes);
  for (const auto& [group, count] : uses_) {
    for (const unsigned mesh : group) is_placed[mesh] = true;
  }
  // Meshes of one name are parts of one object.
  std::map<std::string, MeshGroup> groups;
  for (unsigned i = 0; i < imported_.mNumMeshes; ++i) {
    if (is_placed[i]) continue;
    if (!rules_.places_all_meshes) ++unplaced_;
    if (rules_.places_all_meshes) groups[text_of(imported_.mMeshes[i]->mName)].push_back(i);
  }
  std::vector<grf::Block> blocks;
  for (const auto& [name, group] : groups) {
    uses_[group] = 1;
    if (auto block = block_of(group, name)) blocks.push_back(std::move(*block));
  }
  return blocks;
}

std::optional<grf::Block> SceneMaker::block_of(const MeshGroup& group, const std::string& node_name) {
  const std::string mesh_name = text_of(imported_.mMeshes[group.front()]->mName);
  grf::Block block;
  block.location = location_;
  if (uses_[group] == 1) {
    grf::Mesh mesh = build(group, node_name.empty() ? mesh_name : node_name);
    if (mesh.face_count() == 0) return {};
    face_count_ += mesh.face_count();
    block.content = grf::Shared<grf::Mesh>(std::move(mesh));
    return block;
  }
  const auto [known, is_new] = defined_.emplace(group, std::nullopt);
  if (is_new) {
    const std::string name = mesh_name.empty() ? node_name : mesh_name;
    grf::Mesh mesh = build(group, name);
    if (mesh.face_count() > 0) {
      face_count_ += mesh.face_count();
      known->second = names_.take(name.empty() ? name_of_file(location_.file->path) : name);
      mesh_definitions_.push_back({*known->second, grf::Shared<grf::Mesh>(std::move(mesh)), {}, location_});
    }
  }
  if (!known->second) return {};
  block.content = grf::Use{{*known->second, location_}};
  return block;
}

grf::Mesh SceneMaker::build(const MeshGroup& group, const std::string& name) {
  MeshBuilder builder(name);
  for (const unsigned mesh : group) add_faces(*imported_.mMeshes[mesh], builder);
  return builder.take();
}

void SceneMaker::add_faces(const aiMesh& mesh, MeshBuilder& builder) {
  const std::span faces(mesh.mFaces, mesh.mNumFaces);
  const auto kept = static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](const aiFace& face) { return face.mNumIndices > 2; }));
  count_losses(mesh, kept);
  if (kept == 0) return;
  const Material& material = material_of_index_[mesh.mMaterialIndex];
  const std::uint32_t surface =
      builder.surface(material.index ? materials_.surface(*material.index, kept, losses_) : grf::Surface());
  std::vector<Corner> corners;
  for (const aiFace& face : faces) {
    if (face.mNumIndices < 3) continue;
    corners.clear();
    for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
      corners.push_back(corner_of(mesh, material.read, vertex));
    }
    builder.add_face(corners, surface);
  }
}

void SceneMaker::count_losses(const aiMesh& mesh, std::size_t faces) {
  for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
    if (face.mNumIndices == 0) losses_.add(Loss::DegenerateFace);
    if (face.mNumIndices == 1) losses_.add(Loss::Point);
    if (face.mNumIndices == 2) losses_.add(Loss::Line);
  }
  if (mesh.GetNumUVChannels() > 1) losses_.add(Loss::SecondTextureCoordinates, faces);
  if (mesh.HasVertexColors(0) && !rules_.has_colours) losses_.add(Loss::NumberedColour, faces);
  if (mesh.GetNumColorChannels() > 1) losses_.add(Loss::SecondColour, faces);
  if (mesh.HasBones()) losses_.add(Loss::Skin, faces);
  if (mesh.mNumAnimMeshes > 0) losses_.add(Loss::MorphTarget, faces);
}

Corner SceneMaker::corner_of(const aiMesh& mesh, const AssimpMaterial& material, unsigned vertex) {
  Corner corner;
  corner.position = to_vector(mesh.mVertices[vertex]);
  finite_ = finite_ && is_finite(corner.position);
  if (rules_.has_normals && mesh.HasNormals()) {
    const grf::Vec3f normal = to_vector(mesh.mNormals[vertex]);
    if (!is_finite(normal)) ++odd_normals_;
    // Assimp gives zero normals to corners without one.
    if (is_finite(normal) && normal != grf::Vec3f(0)) corner.normal = normal;
  }
  if (rules_.has_colours && mesh.HasVertexColors(0)) {
    const aiColor4D& c = mesh.mColors[0][vertex];
    const grf::Colour colour(std::max(c.r, 0.0F), std::max(c.g, 0.0F), std::max(c.b, 0.0F));
    // Importers of STL and others set this colour if there is none.
    const bool is_made_up = c == aiColor4D(0.6F, 0.6F, 0.6F, 0.6F);
    if (is_finite(colour) && !is_made_up) corner.colour = colour;
  }
  const unsigned set = mesh.HasTextureCoords(material.uv_set) ? material.uv_set : 0;
  if (mesh.HasTextureCoords(set)) {
    const aiVector3D& t = mesh.mTextureCoords[set][vertex];
    const grf::Vec2f uv(t.x, t.y);
    const grf::Vec2f placed_uv = material.placement ? (*material.placement)(uv) : uv;
    if (std::isfinite(placed_uv.x) && std::isfinite(placed_uv.y)) corner.uv = placed_uv;
  }
  return corner;
}

void SceneMaker::report() {
  losses_.add(Loss::Camera, imported_.mNumCameras);
  losses_.add(Loss::LightSource, imported_.mNumLights);
  losses_.add(Loss::Animation, imported_.mNumAnimations);
  losses_.add(Loss::UnplacedMesh, unplaced_);
  losses_.add(Loss::BadNormal, odd_normals_);
  losses_.add(Loss::EmbeddedFile, textures_.unused());
  materials_.report(location_, diagnostics_);
  losses_.report(location_, diagnostics_);
}

}  // namespace

std::optional<Import> make_scene(const aiScene& imported, const AssimpRules& rules, Losses losses,
                                 const grf::SourceLocation& location, grf::Diagnostics& diagnostics) {
  return SceneMaker(imported, rules, losses, location, diagnostics).run();
}

}  // namespace convert
