// The images of materials: how they are named, and where on a face they are looked up.
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/obj/mtl_image.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string TexturedSquare =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3 4/4\n";

std::string file_of(const grf::Mesh& mesh) {
  const auto& texture = mesh.surface(0).texture;
  return texture ? std::get<grf::Texture>(*texture).file : std::string();
}

/// Reads a square whose material is in `materials/m.mtl` with these statements.
Reading read_square(const test::TemporaryFolder& folder, const std::string& statements) {
  folder.add("materials/m.mtl", "newmtl m\n" + statements);
  return read_path(folder.add("model.obj", "mtllib materials/m.mtl\n" + TexturedSquare));
}

TEST(ObjTextures, AreNamedFromTheFolderOfTheModel) {
  const test::TemporaryFolder folder;
  folder.add("materials/images/a b#c.png", "");
  for (const char* name :
       {"images/a b#c.png", "images\\a b#c.png", "\"images/a b#c.png\"", "./images/a b#c.png"}) {
    const Reading reading = read_square(folder, fmt::format("map_Kd {}\n", name));
    ASSERT_TRUE(reading.scene.has_value()) << reading.text();
    EXPECT_THAT(reading.text(), IsEmpty());
    const grf::Mesh mesh = meshes_of(*reading.scene).at(0);
    EXPECT_EQ(file_of(mesh), "materials/images/a b#c.png") << name;
    EXPECT_EQ(mesh.geometry->uvs[2], grf::Vec2f(1, 1));
  }
}

TEST(ObjTextures, AreFoundBesideTheLibraryIfTheirFolderIsMissing) {
  const test::TemporaryFolder folder;
  folder.add("materials/a.png", "");
  const Reading reading = read_square(folder, "map_Kd C:\\somebody\\images\\a.png\n");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), IsEmpty());
  EXPECT_EQ(file_of(meshes_of(*reading.scene).at(0)), "materials/a.png");
}

// That they are missing is said where a scene is checked, whatever its format.
TEST(ObjTextures, ThatAreMissingKeepTheirName) {
  const test::TemporaryFolder folder;
  const Reading reading = read_square(folder, "map_Kd lost.png\n");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), IsEmpty());
  EXPECT_EQ(file_of(meshes_of(*reading.scene).at(0)), "materials/lost.png");
}

TEST(ObjTextures, WithoutANameAreAValueThatIsNotRead) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(read_square(folder, "map_Kd -s 1 1 1\n").text(), HasSubstr("1 value was not read"));
}

TEST(ObjTextures, AreTheColourWhereNoOtherIsGiven) {
  const test::TemporaryFolder folder;
  folder.add("materials/a.png", "");
  const auto brdf_with = [&](const std::string& statements) {
    return brdf_text(definitions_of(*read_square(folder, statements).scene).at(0));
  };
  EXPECT_EQ(brdf_with("map_Kd a.png\n"), "diffuse kd=1");
  EXPECT_EQ(brdf_with("map_Kd a.png\nKd 0.25 0.25 0.25\n"), "diffuse kd=0.25");
}

TEST(ObjTextures, AreLookedUpAtScaleAndOffset) {
  const test::TemporaryFolder folder;
  folder.add("materials/a.png", "");
  const Reading reading = read_square(folder, "map_Kd -s 2 3 1 -o 0.25 -clamp off a.png\n");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), IsEmpty());
  const grf::Mesh mesh = meshes_of(*reading.scene).at(0);
  EXPECT_EQ(mesh.geometry->uvs[0], grf::Vec2f(0.25F, 0));
  EXPECT_EQ(mesh.geometry->uvs[2], grf::Vec2f(2.25F, 3));
}

TEST(ObjTextures, OfOneMaterialMoveTheCoordinatesOfItsFacesAlone) {
  const test::TemporaryFolder folder;
  folder.add("a.png", "");
  folder.add("model.mtl", "newmtl m\nmap_Kd a.png\nnewmtl n\nmap_Kd -o 5 0 0 a.png\n");
  const Reading reading =
      read_path(folder.add("model.obj", "mtllib model.mtl\n" + TexturedSquare +
                                            "usemtl n\nf 1/1 2/2 3/3\nusemtl m\nf 1/1 2/2 3/3\n"));
  ASSERT_TRUE(reading.scene.has_value());
  const grf::Mesh mesh = meshes_of(*reading.scene).at(0);
  EXPECT_EQ(mesh.geometry->positions.size(), 7U);
  EXPECT_EQ(mesh.geometry->uvs[mesh.face(1)[0]], grf::Vec2f(5, 0));
  EXPECT_EQ(mesh.face(2)[0], mesh.face(0)[0]);
}

/// What the one statement of a text names.
std::optional<MtlImage> image_of(const std::string& text) {
  StatementReader reader(std::make_shared<const std::string>(text), nullptr);
  Statement statement;
  EXPECT_TRUE(reader.next(statement));
  return parse_image(statement);
}

TEST(MtlImage, OptionsTakeAsManyNumbersAsThereAre) {
  EXPECT_EQ(image_of("map_Kd -s 2 -o 1 2 3 4.png")->name, "4.png");
  EXPECT_EQ(image_of("map_Kd -s 2 -o 1 2 3 4.png")->uv.scale, grf::Vec2d(2, 1));
  EXPECT_EQ(image_of("map_Kd -o 1 2 3 4.png")->uv.offset, grf::Vec2d(1, 2));
  EXPECT_EQ(image_of("map_Kd -unknown.png")->name, "-unknown.png");
  EXPECT_EQ(image_of("map_Kd -BM 1 -blendu on \\\n a.png")->name, "a.png");
  EXPECT_FALSE(image_of("map_Kd").has_value());
  EXPECT_FALSE(image_of("map_Kd -clamp").has_value());
}

TEST(MtlImage, TellsOptionsThatChangeSomething) {
  for (const char* option :
       {"-clamp on", "-cc on", "-blendu off", "-mm 0.5 1", "-mm 0 2", "-t 1 0 0", "-imfchan r"}) {
    EXPECT_TRUE(image_of(fmt::format("map_Kd {} a.png", option))->has_other_options) << option;
  }
  for (const char* option :
       {"-clamp off", "-cc off", "-blendv on", "-mm 0 1", "-t 0 0 0", "-bm 1", "-s 2 2 2"}) {
    EXPECT_FALSE(image_of(fmt::format("map_Kd {} a.png", option))->has_other_options) << option;
  }
}

}  // namespace
}  // namespace convert
