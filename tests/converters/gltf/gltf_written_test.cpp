// What a written glTF file says without the extras, which only Granada reads: to Assimp, and to our own
// reader.
#include <algorithm>
#include <array>
#include <span>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "grf/visit.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::UnorderedElementsAre;

// A tetrahedron of outward faces, once stretched, and once mirrored by the inner one of two transforms.
const std::string Tents = R"(
def gold = brdf specular ks=(0.75, 0.5, 0.25)
def plaster = brdf diffuse kd=(0.25, 0.5, 0.75)
def coat = brdf ashikhmin ex=30 Rs=0.04 Rd=0.5
def tent = begin mesh "tent" brdf plaster
  begin vertexs
    normal (0, 0, -1) uv (0.125, 0.25) (0, 0, 0)
    normal (0.6, 0, 0.8) uv (1, 0.5) (1, 0, 0)
    normal (0, 1, 0) uv (0.5, 0.75) (0, 1, 0)
    normal (0.48, 0.6, 0.64) uv (0, 2) (0, 0, 1)
  end vertexs
  begin faces
    (0, 2, 1) brdf gold (0, 1, 3) brdf coat texture "wood.png" (0, 3, 2) light rgb (4, 2, 1) (1, 2, 3)
  end faces
end mesh
begin
  transform scale (2, 3, 4) translation (10, 20, 30) begin use tent end
  transform translation (0, 0, -50) begin transform scale (-1, 1, 1) begin use tent end end
end
)";

struct TentCorner {
  grf::Vec3d position;
  grf::Vec3d normal;
  grf::Vec2d uv;
};

/// A face of three corners in the world, and the text of what it is made of.
struct TentFace {
  std::vector<TentCorner> corners;
  std::string material;
};

/// The corners that the text above has, where its transforms put them.
std::array<TentCorner, 4> stretched_corners() {
  return {{{{10, 20, 30}, {0, 0, -1}, {0.125, 0.25}},
           {{12, 20, 30}, grf::Vec3d(0.6 / 2, 0, 0.8 / 4).normalized(), {1, 0.5}},
           {{10, 23, 30}, {0, 1, 0}, {0.5, 0.75}},
           {{10, 20, 34}, grf::Vec3d(0.48 / 2, 0.6 / 3, 0.64 / 4).normalized(), {0, 2}}}};
}
std::array<TentCorner, 4> mirrored_corners() {
  return {{{{0, 0, -50}, {0, 0, -1}, {0.125, 0.25}},
           {{-1, 0, -50}, {-0.6, 0, 0.8}, {1, 0.5}},
           {{0, 1, -50}, {0, 1, 0}, {0.5, 0.75}},
           {{0, 0, -49}, {-0.48, 0.6, 0.64}, {0, 2}}}};
}

/// Each face of these corners as their numbers from the least on, and its material, so that a face that is
/// turned over is another one. Faces of a mirrored mesh keep their order of corners, since its transform
/// turns them over.
std::vector<std::string> faces_at(const std::array<TentCorner, 4>& expected,
                                  const std::vector<TentFace>& faces) {
  std::vector<std::string> texts;
  for (const TentFace& face : faces) {
    std::vector<std::size_t> numbers;
    for (const TentCorner& corner : face.corners) {
      const auto found = std::find_if(expected.begin(), expected.end(), [&](const TentCorner& e) {
        return (e.position - corner.position).length() < 1e-5;
      });
      if (found == expected.end()) continue;
      EXPECT_LT((found->normal - corner.normal).length(), 1e-6) << "at corner " << numbers.size();
      EXPECT_LT((found->uv - corner.uv).length(), 1e-6) << "at corner " << numbers.size();
      numbers.push_back(static_cast<std::size_t>(found - expected.begin()));
    }
    if (numbers.empty()) continue;
    std::rotate(numbers.begin(), std::min_element(numbers.begin(), numbers.end()), numbers.end());
    texts.push_back(fmt::format("{} {}", fmt::join(numbers, ""), face.material));
  }
  return texts;
}

void erase_tent_extras(nlohmann::json& value) {
  if (value.is_object()) value.erase("extras");
  for (nlohmann::json& part : value) {
    if (part.is_structured()) erase_tent_extras(part);
  }
}

/// The tents as glTF in the folder, all extras erased.
std::string write_bare_tents(const test::TemporaryFolder& folder) {
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(find_format("gltf")->write(scene_of_grf(Tents), folder.path("tents.gltf"), diagnostics))
      << diagnostics.to_text();
  nlohmann::json file = nlohmann::json::parse(test::bytes_of(folder.path("tents.gltf")));
  erase_tent_extras(file);
  return folder.add("bare.gltf", file.dump());
}

std::string rounded_text(const aiColor3D& c) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", c.r, c.g, c.b);
}

std::string tent_text(const aiMaterial& material) {
  aiColor4D base;
  aiColor3D emissive(0, 0, 0);
  ai_real metallic = -1;
  ai_real roughness = -1;
  aiString texture;
  material.Get(AI_MATKEY_BASE_COLOR, base);
  material.Get(AI_MATKEY_METALLIC_FACTOR, metallic);
  material.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness);
  material.Get(AI_MATKEY_COLOR_EMISSIVE, emissive);
  material.GetTexture(aiTextureType_BASE_COLOR, 0, &texture);
  std::string text = fmt::format("{} {} metallic {:.4g} rough {:.4g}", material.GetName().C_Str(),
                                 rounded_text({base.r, base.g, base.b}), metallic, roughness);
  if (texture.length > 0) text += fmt::format(" {}", texture.C_Str());
  if (!emissive.IsBlack()) text += " emits " + rounded_text(emissive);
  return text;
}

void add_tent_faces(const aiScene& scene, const aiNode& node, const aiMatrix4x4& around,
                    std::vector<TentFace>& faces) {
  const aiMatrix4x4 matrix = around * node.mTransformation;
  aiMatrix3x3 of_normals(matrix);
  of_normals.Inverse().Transpose();
  for (const unsigned index : std::span(node.mMeshes, node.mNumMeshes)) {
    const aiMesh& mesh = *scene.mMeshes[index];
    ASSERT_TRUE(mesh.HasNormals() && mesh.HasTextureCoords(0));
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
      TentFace& seen = faces.emplace_back();
      seen.material = tent_text(*scene.mMaterials[mesh.mMaterialIndex]);
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
        const aiVector3D p = matrix * mesh.mVertices[vertex];
        const aiVector3D n = of_normals * mesh.mNormals[vertex];
        const aiVector3D& uv = mesh.mTextureCoords[0][vertex];
        seen.corners.push_back({{p.x, p.y, p.z}, grf::Vec3d(n.x, n.y, n.z).normalized(), {uv.x, uv.y}});
      }
    }
  }
  for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) {
    add_tent_faces(scene, *child, matrix, faces);
  }
}

TEST(GltfWritten, AssimpSeesShapesAndMaterials) {
  const test::TemporaryFolder folder;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(write_bare_tents(folder), 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  std::vector<TentFace> faces;
  add_tent_faces(*scene, *scene->mRootNode, {}, faces);
  EXPECT_EQ(faces.size(), 8U);
  // The coat's exponent of 30 is a slope of sqrt(2/32) = 0.25, whose root is the roughness.
  for (const auto& corners : {stretched_corners(), mirrored_corners()}) {
    EXPECT_THAT(
        faces_at(corners, faces),
        UnorderedElementsAre("021 plaster (0.25, 0.5, 0.75) metallic 0 rough 1",
                             "013 gold (0.75, 0.5, 0.25) metallic 1 rough 0",
                             "032 coat (0.5, 0.5, 0.5) metallic 0 rough 0.5 wood.png",
                             "123 coat (0.5, 0.5, 0.5) metallic 0 rough 0.5 wood.png emits (1, 0.5, 0.25)"));
  }
}

TEST(GltfWritten, AssimpSeesTheTreeOfNodes) {
  const test::TemporaryFolder folder;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(write_bare_tents(folder), 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  std::vector<std::string> with_meshes;
  std::vector<const aiNode*> open = {scene->mRootNode};
  while (!open.empty()) {
    const aiNode* node = open.back();
    open.pop_back();
    if (node->mNumMeshes > 0) with_meshes.emplace_back(node->mName.C_Str());
    for (const aiNode* child : std::span(node->mChildren, node->mNumChildren)) open.push_back(child);
  }
  ASSERT_EQ(with_meshes.size(), 2U) << "one for each use";
  for (const std::string& name : with_meshes) EXPECT_THAT(name, testing::StartsWith("tent"));
  EXPECT_EQ(scene->mNumMeshes, 4U) << "of one definition, a primitive for each surface";
}

std::string tent_text(const grf::Surface& surface, const std::vector<grf::Definition>& definitions) {
  std::string text;
  for (const grf::Definition& definition : definitions) {
    if (surface.brdf && definition.name == std::get<grf::Reference>(*surface.brdf).name) {
      text = definition.name + " " + brdf_text(definition);
    }
  }
  if (surface.texture) text += fmt::format(" {}", std::get<grf::Texture>(*surface.texture).file);
  if (surface.emission) {
    text += fmt::format(" emits ({}, {}, {})", surface.emission->x, surface.emission->y, surface.emission->z);
  }
  return text;
}

TEST(GltfWritten, OurReaderSeesTheSameWithoutExtras) {
  const test::TemporaryFolder folder;
  const Reading reading = read_path(write_bare_tents(folder));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const auto definitions = definitions_of(*reading.scene);
  std::vector<TentFace> faces;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const grf::Matrix44d of_normals = placement.to_world.inverse().transposed();
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      TentFace& face = faces.emplace_back();
      face.material = tent_text(mesh.surface(i), definitions);
      for (const std::uint32_t vertex : mesh.face(i)) {
        TentCorner& corner = face.corners.emplace_back();
        placement.to_world.multVecMatrix(grf::Vec3d(mesh.geometry->positions[vertex]), corner.position);
        of_normals.multDirMatrix(grf::Vec3d(mesh.geometry->normals[vertex]), corner.normal);
        corner.normal.normalize();
        corner.uv = grf::Vec2d(mesh.geometry->uvs[vertex]);
      }
    }
  };
  grf::visit(*reading.scene, visitor);
  EXPECT_EQ(faces.size(), 8U);
  for (const auto& corners : {stretched_corners(), mirrored_corners()}) {
    EXPECT_THAT(faces_at(corners, faces),
                UnorderedElementsAre(
                    "021 plaster diffuse kd=(0.25, 0.5, 0.75)",
                    "013 gold gltf baseColor=(0.75, 0.5, 0.25) metallic=1 roughness=0",
                    "032 coat gltf baseColor=0.5 wood.png",
                    testing::AllOf(testing::StartsWith("123 coat"),
                                   testing::HasSubstr("gltf baseColor=0.5 wood.png emits (4, 2, 1)"))));
  }
}

}  // namespace
}  // namespace convert
