// Tests of the common features of all formats imported by Assimp, by the example of COLLADA.
#include "converters/assimp/assimp_scene.h"

#include <cmath>
#include <cstring>
#include <set>
#include <sstream>

#include <assimp/Importer.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/summary.h"
#include "grf/write.h"
#include "tests/converters/assimp/collada_file.h"
#include "tests/converters/reading.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

using testing::HasSubstr;

Reading read_collada(const ColladaParts& parts) { return read_bytes("model.dae", collada_file(parts)); }

grf::Scene scene_of(const Reading& reading) {
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  return reading.scene.value_or(grf::Scene());
}

std::string brdf_of(const std::string& technique) {
  ColladaParts parts;
  parts.technique = technique;
  return brdf_text(definitions_of(scene_of(read_collada(parts))).at(0));
}

TEST(AssimpScene, KeepsPolygonsNamesAndMaterials) {
  const Reading reading = read_collada({});
  const grf::Mesh mesh = only_mesh(reading);
  EXPECT_EQ(mesh.name, "Square");
  ASSERT_EQ(mesh.face_count(), 1U);
  EXPECT_EQ(mesh.face(0).size(), 4U);
  EXPECT_EQ(mesh.geometry->positions.size(), 4U);
  EXPECT_TRUE(mesh.geometry->normals.empty());
  EXPECT_TRUE(mesh.geometry->uvs.empty());
  const auto definitions = definitions_of(*reading.scene);
  ASSERT_EQ(definitions.size(), 1U);
  EXPECT_EQ(definitions[0].name, "Red$20$paint");
  EXPECT_EQ(brdf_text(definitions[0]), "diffuse kd=(0.5, 0.25, 0)");
  EXPECT_EQ(material_of(mesh, 0), "Red$20$paint");
  EXPECT_EQ(reading.diagnostics.warning_count(), 0U) << reading.text();
}

TEST(AssimpScene, HasTheAxesAndUnitsOfTheFile) {
  for (const char* asset : {"<unit meter='0.01'/><up_axis>Z_UP</up_axis>", "<up_axis>X_UP</up_axis>"}) {
    ColladaParts parts;
    parts.asset = asset;
    const grf::Summary summary = grf::summarize(scene_of(read_collada(parts)));
    EXPECT_EQ(summary.bounds.max, grf::Vec3f(1, 0, 2));
    EXPECT_DOUBLE_EQ(summary.area, 2);
  }
}

TEST(AssimpScene, WhatSeveralNodesPlaceIsDefinedOnce) {
  ColladaParts parts;
  parts.nodes =
      "<node name='A'>{}</node><node name='B'><translate>3 0 0</translate>{}</node>"
      "<node name='C'><scale>2 2 2</scale><node name='D'><rotate>0 1 0 90</rotate>{}</node></node>";
  const Reading reading = read_collada(parts);
  const grf::Scene scene = scene_of(reading);
  const grf::Summary summary = grf::summarize(scene);
  EXPECT_EQ(summary.instances, 3U);
  EXPECT_EQ(summary.faces, 3U);
  EXPECT_DOUBLE_EQ(summary.area, 2 + 2 + 8);
  const auto definitions = definitions_of(scene);
  ASSERT_EQ(definitions.size(), 2U);
  EXPECT_EQ(definitions[1].name, "Quad");
  EXPECT_EQ(std::get<grf::Shared<grf::Mesh>>(definitions[1].body)->name, "Quad");
  EXPECT_NEAR(summary.bounds.max.x, 4, 1e-6);
  EXPECT_NEAR(summary.bounds.max.z, 2, 1e-6);
  EXPECT_NEAR(summary.bounds.min.z, -2, 1e-6);
}

TEST(AssimpScene, CanBeWrittenAndRead) {
  ColladaParts parts;
  parts.nodes = "<node name='a &quot;b&quot;'>{}</node><node><translate>3 0 0</translate>{}</node>";
  const grf::Scene scene = scene_of(read_collada(parts));
  grf::Diagnostics diagnostics;
  const test::TemporaryFolder folder;
  ASSERT_TRUE(grf::write(scene, folder.path("a.grf"), diagnostics));
  EXPECT_EQ(grf::read(folder.path("a.grf"), diagnostics), scene) << diagnostics.to_text();
}

TEST(AssimpScene, ASingularTransformLeavesOutWhatIsUnderIt) {
  ColladaParts parts;
  parts.nodes = "<node>{}</node><node><scale>1 0 1</scale><node>{}</node><node>{}</node></node>";
  const Reading reading = read_collada(parts);
  EXPECT_EQ(grf::summarize(scene_of(reading)).faces, 1U);
  EXPECT_THAT(reading.text(), HasSubstr("warning: 2 meshes were left out: its transform is"));
}

TEST(AssimpScene, AMirroredObjectIsPlacedSo) {
  ColladaParts parts;
  parts.nodes = "<node><matrix>-1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix>{}</node>";
  const grf::Summary summary = grf::summarize(scene_of(read_collada(parts)));
  EXPECT_EQ(summary.bounds.min, grf::Vec3f(4, 0, 0));
  EXPECT_EQ(summary.bounds.max, grf::Vec3f(5, 0, 2));
}

TEST(AssimpScene, AMaterialHasTheLobeOfItsShadingModel) {
  const std::string rest =
      "<diffuse><color>0.5 0.5 0.5 1</color></diffuse><specular><color>0.25 0.25 0.25 1</color></specular>"
      "<shininess><float>20</float></shininess>";
  EXPECT_EQ(brdf_of("<phong>" + rest + "</phong>"), "lewis n=20 ks=0.25 kd=0.5");
  EXPECT_EQ(brdf_of("<blinn>" + rest + "</blinn>"), "lewis n=5 ks=0.25 kd=0.5")
      << "a power of the half vector";
  EXPECT_EQ(brdf_of("<lambert>" + rest + "</lambert>"), "diffuse kd=0.5")
      << "Assimp makes up a specular colour for these";
}

TEST(AssimpScene, EmissionIsOfTheFaces) {
  ColladaParts parts;
  parts.technique = "<constant><emission><color>3 2 1 1</color></emission></constant>";
  const Reading reading = read_collada(parts);
  EXPECT_EQ(only_mesh(reading).surface(0).emission, grf::Colour(3, 2, 1));
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene).at(0)), "diffuse kd=0");
}

TEST(AssimpScene, TheOriginalValuesStandInTheComment) {
  const auto definitions = definitions_of(scene_of(read_collada({})));
  std::string comment;
  for (const std::string& line : definitions.at(0).comments.before) comment += line + "\n";
  EXPECT_THAT(comment, HasSubstr("COLLADA:"));
  EXPECT_THAT(comment, HasSubstr("diffuse 0.5 0.25 0"));
}

ColladaParts textured() {
  ColladaParts parts;
  parts.libraries =
      "<library_images><image id='i'><init_from>images/red%20brick.png</init_from></image></library_images>";
  parts.images =
      "<newparam sid='f'><surface type='2D'><init_from>i</init_from></surface></newparam>"
      "<newparam sid='r'><sampler2D><source>f</source></sampler2D></newparam>";
  parts.technique = "<lambert><diffuse><texture texture='r' texcoord='UV'/></diffuse></lambert>";
  parts.primitives =
      "<polylist count='1' material='paint'><input semantic='VERTEX' source='#v' offset='0'/>"
      "<input semantic='TEXCOORD' source='#t' offset='0' set='0'/>"
      "<vcount>4</vcount><p>0 1 2 3</p></polylist>";
  return parts;
}

TEST(AssimpScene, TexturesStandInThePlaceOfTheDiffuseColour) {
  const Reading reading = read_collada(textured());
  const grf::Mesh mesh = only_mesh(reading);
  ASSERT_TRUE(mesh.surface(0).texture.has_value());
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(0).texture).file, "images/red brick.png");
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene).at(0)), "diffuse kd=1");
  EXPECT_EQ(mesh.geometry->uvs[mesh.face(0)[2]], grf::Vec2f(1, 1));
  EXPECT_TRUE(reading.files.empty());
}

TEST(AssimpScene, WhatAFaceLosesIsCounted) {
  ColladaParts parts;
  parts.technique =
      "<lambert><diffuse><color>1 1 1 1</color></diffuse>"
      "<transparent opaque='A_ONE'><color>1 1 1 0.5</color></transparent></lambert>";
  parts.primitives =
      "<polylist count='1' material='paint'><input semantic='VERTEX' source='#v' offset='0'/>"
      "<input semantic='TEXCOORD' source='#t' offset='0' set='0'/>"
      "<input semantic='TEXCOORD' source='#t' offset='0' set='1'/><vcount>4</vcount><p>0 1 2 3</p></polylist>"
      "<lines count='2' material='paint'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 1 "
      "2</p></lines>";
  parts.libraries =
      "<library_lights><light id='l'><technique_common><point><color>1 1 1</color></point></technique_common>"
      "</light></library_lights><library_cameras><camera id='c'><optics><technique_common><perspective>"
      "<xfov>40</xfov></perspective></technique_common></optics></camera></library_cameras>";
  parts.nodes =
      "<node>{}</node><node><instance_light url='#l'/></node><node><instance_camera url='#c'/></node>";
  const Reading reading = read_collada(parts);
  EXPECT_EQ(only_mesh(reading).face_count(), 1U);
  EXPECT_THAT(reading.text(), HasSubstr("1 face lost its transparency"));
  EXPECT_THAT(reading.text(), HasSubstr("1 face lost its additional sets of texture coordinates"));
  EXPECT_THAT(reading.text(), HasSubstr("2 lines were left out"));
  EXPECT_THAT(reading.text(), HasSubstr("1 light was left out"));
  EXPECT_THAT(reading.text(), HasSubstr("1 camera was left out"));
}

TEST(AssimpScene, AFileWithoutFacesIsAnError) {
  ColladaParts parts;
  parts.nodes = "<node/>";
  const Reading reading = read_collada(parts);
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), HasSubstr("error: the file has no faces, and only faces can be imported"));
}

TEST(AssimpFormats, AreAllThatMakeSurfaces) {
  // Skeletons and their movements alone, and what has a reader of its own.
  const std::set<std::string> others = {"bvh", "csm", "md5anim", "md5camera", "mot"};
  const std::set<std::string> own = {"gltf", "glb", "ply"};
  aiString extensions;
  Assimp::Importer().GetExtensionList(extensions);
  std::istringstream list(extensions.C_Str());
  for (std::string pattern; std::getline(list, pattern, ';');) {
    const std::string extension = pattern.substr(2);
    if (own.contains(extension)) continue;
    EXPECT_NE(format_of_name("a." + extension) != nullptr, others.contains(extension)) << extension;
  }
}

TEST(AssimpScene, AssimpsOwnErrorsAreErrors) {
  const Reading reading = read_bytes("model.dae", "<COLLADA");
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_EQ(reading.diagnostics.error_count(), 1U) << reading.text();
}

// Scenes that no reader should make, given to the maker of scenes as they are.
class BrokenScene : public testing::Test {
 protected:
  BrokenScene() {
    auto* mesh = new aiMesh();
    mesh->mVertices = new aiVector3D[3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->mNumVertices = 3;
    mesh->mFaces = new aiFace[1];
    mesh->mNumFaces = 1;
    mesh->mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
    mesh->mFaces[0].mNumIndices = 3;
    scene_.mMeshes = new aiMesh* [1] { mesh };
    scene_.mNumMeshes = 1;
    scene_.mMaterials = new aiMaterial* [1] { new aiMaterial() };
    scene_.mNumMaterials = 1;
    scene_.mRootNode = new aiNode();
    scene_.mRootNode->mMeshes = new unsigned[1]{0};
    scene_.mRootNode->mNumMeshes = 1;
  }

  std::optional<Import> make(const AssimpRules& rules = {}) {
    diagnostics_ = {};
    return make_scene(scene_, rules, {}, grf::whole_file("model"), diagnostics_);
  }

  aiScene scene_;
  grf::Diagnostics diagnostics_;
};

TEST_F(BrokenScene, IsNotBrokenYet) {
  EXPECT_TRUE(make().has_value()) << diagnostics_.to_text();
  EXPECT_EQ(diagnostics_.warning_count(), 0U) << diagnostics_.to_text();
}

TEST_F(BrokenScene, IndicesOutOfRangeAreErrors) {
  scene_.mMeshes[0]->mFaces[0].mIndices[1] = 3;
  EXPECT_FALSE(make().has_value());
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("model: error: an index is out of range: vertex 3 of 3"));
  scene_.mMeshes[0]->mFaces[0].mIndices[1] = 1;
  scene_.mMeshes[0]->mMaterialIndex = 1;
  EXPECT_FALSE(make().has_value());
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("material 1 of 1"));
  scene_.mMeshes[0]->mMaterialIndex = 0;
  scene_.mRootNode->mMeshes[0] = 1;
  EXPECT_FALSE(make().has_value());
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("mesh 1 of 1"));
}

TEST_F(BrokenScene, NumbersThatAreNoneAreErrorsOrLost) {
  scene_.mMeshes[0]->mNormals = new aiVector3D[3]{{NAN, 0, 0}, {0, 0, 1}, {0, 0, 0}};
  const auto import = make();
  ASSERT_TRUE(import.has_value());
  const grf::Mesh mesh = meshes_of(import->scene).at(0);
  EXPECT_FALSE(mesh.geometry->normals.has(0));
  EXPECT_TRUE(mesh.geometry->normals.has(1));
  EXPECT_FALSE(mesh.geometry->normals.has(2));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("1 vertex lost its normal: it has no direction"));
  scene_.mMeshes[0]->mVertices[2].z = INFINITY;
  EXPECT_FALSE(make().has_value());
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("error: a vertex is not finite"));
}

TEST_F(BrokenScene, AMeshThatNoNodePlacesIsLostOrPlaced) {
  delete[] scene_.mRootNode->mMeshes;
  scene_.mRootNode->mMeshes = nullptr;
  scene_.mRootNode->mNumMeshes = 0;
  EXPECT_FALSE(make().has_value());
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("1 mesh was left out: no node of the file uses it"));
  AssimpRules rules;
  rules.places_all_meshes = true;
  EXPECT_TRUE(make(rules).has_value());
}

TEST_F(BrokenScene, EmbeddedImagesAreFiles) {
  auto* png = new aiTexture();
  png->pcData = new aiTexel[2];
  std::memcpy(png->pcData, "PNG\0\1\2\3\4", 8);
  png->mWidth = 7;
  std::copy_n("png", 4, png->achFormatHint);
  png->mFilename = aiString(std::string("C:\\x\\wood.png"));
  auto* pixels = new aiTexture();
  pixels->mWidth = 2;
  pixels->mHeight = 1;
  pixels->pcData = new aiTexel[2]{{1, 2, 3, 4}, {5, 6, 7, 8}};
  scene_.mTextures = new aiTexture* [2] { png, pixels };
  scene_.mNumTextures = 2;
  const aiString name("*1");
  scene_.mMaterials[0]->AddProperty(&name, AI_MATKEY_TEXTURE_DIFFUSE(0));
  auto import = make();
  ASSERT_TRUE(import.has_value()) << diagnostics_.to_text();
  ASSERT_EQ(import->files.size(), 1U);
  EXPECT_EQ(import->files[0].name, "texture1.tga");
  EXPECT_EQ(import->files[0].bytes.substr(18), std::string("\1\2\3\4\5\6\7\x8"));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("1 embedded image was left out"));
  const aiString other("wood.png");
  scene_.mMaterials[0]->AddProperty(&other, AI_MATKEY_TEXTURE_DIFFUSE(0));
  import = make();
  ASSERT_EQ(import->files.size(), 1U);
  EXPECT_EQ(import->files[0].name, "wood.png");
  EXPECT_EQ(import->files[0].bytes, std::string("PNG\0\1\2\3", 7));
}

TEST(Lwo, EveryCutIsAnError) {
  const std::string whole =
      test::bytes_of("/usr/share/assimp/models/LWO/LWO2/MappingModes/earth_spherical_y.lwo");
  ASSERT_TRUE(read_bytes("a.lwo", whole).scene.has_value());
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    const Reading reading = read_bytes("a.lwo", std::string_view(whole).substr(0, size));
    EXPECT_FALSE(reading.scene.has_value()) << size;
    EXPECT_TRUE(reading.diagnostics.has_errors()) << size;
  }
}

}  // namespace
}  // namespace convert
