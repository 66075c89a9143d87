#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/assimp/three_ds_file.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

// Two triangles with a right angle between them: one in the plane y = 0, one in the plane x = 0, along the
// z axis.
const std::vector<float> Fold = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0};
const std::vector<std::vector<unsigned>> FoldFaces = {{0, 2, 1}, {0, 1, 3}};

/// Chunks of a map: how often the image is repeated (Autodesk's 3DS File Toolkit, MAT_MAP_USCALE and
/// _VSCALE).
constexpr unsigned UScale = 0xA354;
constexpr unsigned VScale = 0xA356;

Reading read_object(const ThreeDsParts& parts, const std::string& materials = "") {
  return read_bytes("model.3ds", three_ds_file(materials + object("fold", parts)));
}

std::size_t normals_of(const grf::Mesh& mesh) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i)
    count += mesh.geometry->normals.has(i) ? 1 : 0;
  return count;
}

TEST(ThreeDs, KeepsAxesNamesAndSharedVertices) {
  const Reading reading = read_object({Fold, FoldFaces, {}, {}, {}});
  const grf::Mesh mesh = only_mesh(reading);
  EXPECT_EQ(mesh.name, "fold");
  EXPECT_EQ(mesh.face_count(), 2U);
  ASSERT_EQ(mesh.geometry->positions.size(), 4U);
  EXPECT_EQ(mesh.geometry->positions[2], grf::Vec3f(0, 0, 1)) << "not turned to y up";
  EXPECT_EQ(normals_of(mesh), 0U) << "the file has no smoothing groups";
  EXPECT_FALSE(mesh.surface(0).brdf.has_value()) << "the file has no materials";
  EXPECT_TRUE(definitions_of(*reading.scene).empty());
  EXPECT_EQ(reading.diagnostics.warning_count(), 0U) << reading.text();
  EXPECT_TRUE(std::holds_alternative<grf::Shared<grf::Mesh>>(reading.scene->contents.blocks[0].content));
}

TEST(ThreeDs, FacesOfOneSmoothingGroupAreSmoothWhereTheyMeet) {
  for (const unsigned second : {1U, 5U, 0x80000001U}) {
    const grf::Mesh mesh = only_mesh(read_object({Fold, FoldFaces, {1, second}, {}, {}}));
    ASSERT_EQ(mesh.geometry->positions.size(), 4U);
    ASSERT_EQ(normals_of(mesh), 4U);
    // Both faces have as large an angle at the origin, and at the other end of the fold.
    const float diagonal = std::sqrt(0.5F);
    EXPECT_LT((mesh.geometry->normals[mesh.face(0)[0]] - grf::Vec3f(-diagonal, -diagonal, 0)).length(), 1e-6);
    EXPECT_LT((mesh.geometry->normals[mesh.face(0)[2]] - grf::Vec3f(-diagonal, -diagonal, 0)).length(), 1e-6);
    EXPECT_LT((mesh.geometry->normals[mesh.face(0)[1]] - grf::Vec3f(0, -1, 0)).length(), 1e-6);
  }
}

TEST(ThreeDs, FacesOfDifferentSmoothingGroupsAreNotSmoothWhereTheyMeet) {
  const grf::Mesh mesh = only_mesh(read_object({Fold, FoldFaces, {1, 2}, {}, {}}));
  EXPECT_EQ(mesh.geometry->positions.size(), 6U);
  EXPECT_LT((mesh.geometry->normals[mesh.face(0)[0]] - grf::Vec3f(0, -1, 0)).length(), 1e-6);
  EXPECT_LT((mesh.geometry->normals[mesh.face(1)[0]] - grf::Vec3f(-1, 0, 0)).length(), 1e-6);
}

TEST(ThreeDs, AFaceWithoutASmoothingGroupIsFlat) {
  const grf::Mesh mesh = only_mesh(read_object({Fold, FoldFaces, {0, 1}, {}, {}}));
  for (const std::uint32_t vertex : mesh.face(0)) EXPECT_FALSE(mesh.geometry->normals.has(vertex));
  EXPECT_LT((mesh.geometry->normals[mesh.face(1)[0]] - grf::Vec3f(-1, 0, 0)).length(), 1e-6)
      << "the flat face is not smoothed into it";
}

TEST(ThreeDs, TwoVerticesAtOnePlaceAreSmoothTogether) {
  std::vector<float> positions = Fold;
  positions.insert(positions.end(), {0, 0, 0, 0, 0, 1});
  const grf::Mesh mesh = only_mesh(read_object({positions, {{0, 2, 1}, {4, 5, 3}}, {1, 1}, {}, {}}));
  EXPECT_EQ(mesh.geometry->positions.size(), 4U);
  EXPECT_EQ(normals_of(mesh), 4U);
}

TEST(ThreeDs, SmoothingHoldsAcrossMaterialsOfOneObject) {
  const std::string materials =
      material("a", colour_chunk(0xA020, 1, 0, 0)) + material("b", colour_chunk(0xA020, 0, 1, 0));
  const grf::Mesh mesh =
      only_mesh(read_object({Fold, FoldFaces, {1, 1}, {{"b", {0}}, {"A", {1}}}, {}}, materials));
  EXPECT_EQ(mesh.geometry->positions.size(), 4U);
  EXPECT_EQ(mesh.face_count(), 2U);
  EXPECT_EQ(material_of(mesh, 0), "a") << "names are the same whatever their case";
  EXPECT_EQ(material_of(mesh, 1), "b");
}

TEST(ThreeDs, MaterialsBecomeBrdfs) {
  const std::string shiny = material(
      "Shiny", colour_chunk(0xA020, 0.5F, 0.25F, 0) + colour_chunk(0xA030, 1, 1, 1) +
                   percentage_chunk(0xA040, 50) + percentage_chunk(0xA041, 20) + chunk(0xA100, word(3)));
  const std::string lamp = material("Lamp", colour_chunk(0xA020, 1, 0.5F, 0) + percentage_chunk(0xA084, 50));
  const Reading reading =
      read_object({Fold, FoldFaces, {}, {{"Shiny", {0}}, {"Lamp", {1}}}, {}}, shiny + lamp);
  const grf::Mesh mesh = only_mesh(reading);
  const auto definitions = definitions_of(*reading.scene);
  ASSERT_EQ(definitions.size(), 2U);
  EXPECT_EQ(definitions[0].name, "Shiny");
  EXPECT_EQ(brdf_text(definitions[0]), "lewis n=32 ks=0.2 kd=(0.5, 0.25, 0)")
      << "a glossiness of 50 % is an exponent of 2^5";
  EXPECT_THAT(definitions[0].comments.before.front(), HasSubstr("3DS: "));
  EXPECT_THAT(definitions[0].comments.before.front(), HasSubstr("shininess 50"));
  EXPECT_EQ(brdf_text(definitions[1]), "diffuse kd=(1, 0.5, 0)");
  ASSERT_TRUE(mesh.surface(1).emission.has_value());
  EXPECT_LT((*mesh.surface(1).emission - grf::Colour(0.5F, 0.25F, 0)).length(), 1e-6);
}

TEST(ThreeDs, ATextureStandsInThePlaceOfTheDiffuseColour) {
  const std::string map = chunk(
      0xA200, chunk(0xA300, text("WALL.JPG")) + chunk(UScale, floats({2})) + chunk(VScale, floats({4})));
  const std::string brick = material("brick", colour_chunk(0xA020, 0.2F, 0.2F, 0.2F) + map);
  const Reading reading =
      read_object({Fold, FoldFaces, {}, {{"brick", {0, 1}}}, {0, 0, 0.5F, 0.5F, 1, 1, 0, 1}}, brick);
  const grf::Mesh mesh = only_mesh(reading);
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene).at(0)), "diffuse kd=1");
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(0).texture).file, "WALL.JPG");
  // The image is repeated about its centre, twice along u and four times along v.
  ASSERT_TRUE(mesh.geometry->uvs.has(mesh.face(0)[0]));
  const grf::Vec2f corner = mesh.geometry->uvs[mesh.face(0)[0]];
  const grf::Vec2f centre = mesh.geometry->uvs[mesh.face(0)[2]];
  EXPECT_EQ(centre, grf::Vec2f(0.5F, 0.5F));
  EXPECT_EQ(corner, grf::Vec2f(-0.5F, -1.5F));
}

TEST(ThreeDs, TilesAnImageAlongUAndAlongVApart) {
  const auto corner_of = [](const std::string& chunks) {
    const std::string map = chunk(0xA200, chunk(0xA300, text("WALL.JPG")) + chunks);
    const grf::Mesh mesh =
        only_mesh(read_object({Fold, FoldFaces, {}, {{"brick", {0, 1}}}, {0, 0.25F, 0.5F, 0.5F, 1, 1, 0, 1}},
                              material("brick", map)));
    return mesh.geometry->uvs[mesh.face(0)[0]];
  };
  EXPECT_EQ(corner_of(""), grf::Vec2f(0, 0.25F));
  EXPECT_EQ(corner_of(chunk(UScale, floats({3}))), grf::Vec2f(-1, 0.25F));
  EXPECT_EQ(corner_of(chunk(VScale, floats({3}))), grf::Vec2f(0, -0.25F));
}

TEST(ThreeDs, AnUnknownMaterialIsSaidAndGivesNoBrdf) {
  const Reading reading = read_object({Fold, FoldFaces, {1, 1}, {{"none", {0, 1}}}, {}});
  const grf::Mesh mesh = only_mesh(reading);
  EXPECT_FALSE(mesh.surface(0).brdf.has_value());
  EXPECT_EQ(normals_of(mesh), 4U);
  EXPECT_THAT(reading.text(), HasSubstr("warning: Assimp says: 3DS: Unknown material: none"));
}

TEST(ThreeDs, BrokenFilesAreErrorsWithAnOffset) {
  const Reading index = read_object({Fold, {{0, 1, 4}}, {}, {}, {}});
  EXPECT_FALSE(index.scene.has_value());
  EXPECT_THAT(index.text(), HasSubstr("error: a face of the object 'fold' has vertex 4 of 4"));
  EXPECT_THAT(read_object({Fold, FoldFaces, {}, {}, {0, 0}}).text(),
              HasSubstr("error: the object 'fold' has 1 texture coordinate for 4 vertices"));
  const std::string list = chunk(0x4110, word(9) + floats({0, 0, 0}));
  const Reading cut = read_bytes("cut.3ds", three_ds_file(chunk(0x4000, text("cut") + chunk(0x4100, list))));
  EXPECT_FALSE(cut.scene.has_value());
  EXPECT_THAT(cut.text(), HasSubstr("error: the list of 9 vertices ends after 1"));
  std::vector<float> far = Fold;
  far[4] = std::numeric_limits<float>::infinity();
  EXPECT_THAT(read_object({far, FoldFaces, {}, {}, {}}).text(), HasSubstr("is not finite"));
}

TEST(ThreeDs, EveryCutIsAnError) {
  const std::string whole = three_ds_file(material("a", percentage_chunk(0xA084, 50)) +
                                          object("fold", {Fold, FoldFaces, {1, 1}, {{"a", {0}}}, {}}));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Reading reading = read_bytes("model.3ds", std::string_view(whole).substr(0, size));
    EXPECT_FALSE(reading.scene.has_value()) << size;
    EXPECT_TRUE(reading.diagnostics.has_errors()) << size;
  }
  EXPECT_TRUE(read_bytes("model.3ds", whole).scene.has_value());
}

TEST(ThreeDs, AChunkThatEndsBehindTheOneItIsInIsAnError) {
  const ThreeDsParts parts = {Fold, FoldFaces, {}, {}, {}};
  for (const std::uint32_t size : {0U, 5U, 1000U, 0xFFFFFFFFU}) {
    std::string wrong = object("fold", parts);
    wrong.replace(2, 4, little_endian(size, 4));
    const Reading reading = read_bytes("model.3ds", three_ds_file(object("whole", parts) + wrong));
    EXPECT_FALSE(reading.scene.has_value()) << size;
    EXPECT_THAT(reading.text(), HasSubstr("a chunk extends past its parent chunk")) << size;
  }
}

}  // namespace
}  // namespace convert
