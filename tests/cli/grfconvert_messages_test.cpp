// Tests that messages of `grfconvert` are correct and not repeated.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/grfconvert.h"
#include "tests/support/temporary_folder.h"

namespace {

using nlohmann::json;
using test::grfconvert;
using test::TemporaryFolder;
using test::Triangle;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string Spider = "/usr/share/assimp/models/OBJ/spider.obj";
const std::string TexturedBox = "/usr/share/assimp/models/glTF2/BoxTextured-glTF/BoxTextured.gltf";

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

// Meshes of a binary model have no line numbers, so messages about different meshes would look the same.
TEST(GrfconvertMessages, CountFacesOfAllMeshesOfAModel) {
  const TemporaryFolder folder;
  const std::string err = grfconvert({Spider, "-o", folder.path("a.grf")}).err;
  EXPECT_THAT(err, AllOf(HasSubstr(Spider + ": warning: 56 faces of 4 meshes have no area\n"),
                         HasSubstr("2 faces of 2 meshes have normals that point away from the front\n")));
  EXPECT_EQ(count(err, "no area"), 1U);
  // A GRF file has line numbers.
  EXPECT_EQ(count(grfconvert({"check", folder.path("a.grf")}).err, "14 faces, the first is 0, have no area"),
            4U);
}

TEST(GrfconvertMessages, NameEachMissingImageOnce) {
  const TemporaryFolder folder;
  folder.add("a.mtl", "newmtl paint\nmap_Kd lost.png\n");
  const std::string obj = "mtllib a.mtl\nvt 0 0\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n";
  const std::string err = grfconvert({folder.add("a.obj", obj), "-o", folder.path("a.gltf")}).err;
  EXPECT_THAT(err, HasSubstr("a.mtl:2:1: warning: there is no image '" + folder.path("lost.png") + "'\n"));
  EXPECT_EQ(count(err, "lost.png'"), 1U) << err;
  json gltf = json::parse(test::bytes_of(folder.path("a.gltf")));
  gltf.erase("extras");
  const std::string plain = folder.add("plain.gltf", gltf.dump());
  EXPECT_EQ(grfconvert({plain, "-o", folder.path("b.grf")}).err,
            plain + ": warning: there is no image '" + folder.path("lost.png") + "'\n");
}

TEST(GrfconvertMessages, DoNotMissImagesThatAreThere) {
  const TemporaryFolder folder;
  for (const char* name : {"a.grf", "a.gltf", "a.glb"}) {
    EXPECT_THAT(grfconvert({TexturedBox, "-o", folder.path(name)}).err, Not(HasSubstr("no image"))) << name;
    EXPECT_THAT(grfconvert({"info", folder.path(name)}).err, Not(HasSubstr("no image"))) << name;
  }
}

TEST(GrfconvertMessages, LeaveNoImagesBesideAFileThatHoldsThem) {
  const TemporaryFolder folder;
  const test::Outcome outcome = grfconvert({TexturedBox, "-o", folder.path("a.glb"), "--json"});
  EXPECT_EQ(json::parse(outcome.out)["files"], json::array());
  EXPECT_THAT(folder.names(), ElementsAre("a.glb"));
  ASSERT_EQ(grfconvert({folder.path("a.glb"), "-o", folder.path("b.gltf")}).exit_code, 0);
  EXPECT_THAT(folder.names(), ElementsAre("CesiumLogoFlat.png", "a.glb", "b.bin", "b.gltf"));
}

// Line numbers of the converted text are not those of the file, so no source line is shown.
TEST(GrfconvertMessages, TellTheSceneInsideAGltfFileFromTheFile) {
  const TemporaryFolder folder;
  const std::string model = folder.add("a.obj", Triangle);
  for (const char* name : {"a.gltf", "a.glb"}) {
    const std::string path = folder.path(name);
    ASSERT_EQ(grfconvert({model, "-o", path}).exit_code, 0);
    EXPECT_EQ(grfconvert({"info", path}).err,
              path + "#grf:1:1: warning: faces without a BRDF: they are diffuse with kd=0.5\n");
  }
}

// A file that no reader can read, not even ours, is worse than no file.
TEST(GrfconvertMessages, SayThatNoFloatHoldsAVertex) {
  const TemporaryFolder folder;
  const std::string scene =
      folder.add("a.grf", "transform scale (1e30, 1e30, 1e30) scale (1e30, 1e30, 1e30) begin begin mesh" +
                              test::Faces + " end");
  for (const char* name : {"a.obj", "a.ply", "a.stl"}) {
    const test::Outcome outcome = grfconvert({scene, "-o", folder.path(name)});
    EXPECT_EQ(outcome.exit_code, 1) << name;
    EXPECT_THAT(outcome.err, HasSubstr("a transform moves a vertex out of the range of a float\n"));
  }
  EXPECT_THAT(folder.names(), ElementsAre("a.grf"));
}

TEST(GrfconvertDryRun, SaysWhatWritingWouldSay) {
  const TemporaryFolder folder;
  const std::string model = folder.add("a.obj", "o thing\n" + Triangle);
  const std::string output = folder.path("a.ply");
  const test::Outcome tried = grfconvert({model, "-o", output, "--dry-run"});
  const json record = json::parse(grfconvert({model, "-o", output, "--dry-run", "--json"}).out);
  EXPECT_THAT(folder.names(), ElementsAre("a.obj"));
  EXPECT_THAT(tried.err, HasSubstr(output + ": warning: 1 mesh lost its name: PLY has none\n"));
  EXPECT_EQ(record["losses"], json::array({"1 mesh lost its name: PLY has none"}));
  EXPECT_THAT(record["files"], IsEmpty());
  EXPECT_EQ(grfconvert({model, "-o", output}).err, tried.err);
}

TEST(GrfconvertDryRun, DoesNotSayThatFilesAreConverted) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.obj", Triangle);
  const std::string b = folder.add("b.obj", Triangle);
  EXPECT_THAT(grfconvert({a, b, "-o", folder.path("out"), "--dry-run"}).out,
              HasSubstr("2 of 2 files can be converted (not written: --dry-run)\n"));
}

}  // namespace
