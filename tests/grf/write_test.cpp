#include "grf/write.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/text_file.h"
#include "tests/grf/reading.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Writing, HasOneStyle) {
  const std::string text =
      "// A room\n"
      "include \"light.grf\"  // above\n"
      "def\n"
      "  // all walls\n"
      "  red = rgb (1, 0.1, 0)\n"
      "def chrome = brdf ward sx=0.1 kd=(0.1, 0.2, 0.3) fast=true  // for the ball\n"
      "def few = pdf adaptive nqt=4\n"
      "begin\n"
      "  transform scale (2, 2, 2) rotation (0, 1.5707964, 0) translation (0, 1e-20, 0) begin\n"
      "    begin mesh \"ball\"\n"
      "      rgb red\n"
      "      brdf chrome\n"
      "      pdf few\n"
      "      light rgb (10, 10, 10)\n"
      "      // the corners\n"
      "      begin vertexs\n"
      "        (0, 0, 0)\n"
      "        normal (0, 0, 1) (1, 0, 0)\n"
      "        normal (0, 0, 1) rgb (1, 1, 1) (0, 1, 0)\n"
      "      end vertexs\n"
      "      begin faces\n"
      "        (0, 1, 2)\n"
      "        rgb none\n"
      "        brdf ward\n"
      "        (0, 2, 1)\n"
      "        light none\n"
      "        (0, 1, 2, 1)\n"
      "      end faces  // three\n"
      "    end mesh\n"
      "  end\n"
      "  light begin\n"
      "    (0, 2, 0)\n"
      "    (1, 0, 0)\n"
      "    (0, 0, 1)\n"
      "    rgb (4, 4, 4)\n"
      "  end\n"
      "end\n"
      "// the end\n";
  const test::TemporaryFolder folder;
  folder.add("light.grf", "light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end");
  Diagnostics diagnostics;
  const auto scene = read(folder.add("scene.grf", text), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  EXPECT_EQ(to_text(*scene), text);
}

TEST(Writing, OfAModelIsWhatStandsAfterItsKind) {
  BrdfModel model;
  model.keyword = "ward";
  EXPECT_EQ(to_text(model), "ward");
  model.arguments = {{"sx", 0.1F, {}}, {"kd", Colour(0, 0.5F, 1), {}}, {"fast", false, {}}};
  EXPECT_EQ(to_text(model), "ward sx=0.1 kd=(0, 0.5, 1) fast=false");
}

TEST(Writing, TellsAKeywordFromADefinitionOfTheSameSpelling) {
  const std::string text = "def ward = brdf phong Ward = brdf phong begin " + triangle("brdf WARD") + "end";
  Scene scene = scene_of(text);
  auto& scope = std::get<DefinitionScope>(scene.contents.blocks[0].content);
  auto& mesh = std::get<Shared<Mesh>>(scope.body.blocks[0].content).edit();
  std::get<BrdfModel>(*mesh.surfaces[0].brdf).keyword = "ward";
  EXPECT_THAT(to_text(scene), HasSubstr("    brdf wArd\n"));
  EXPECT_EQ(scene_of(to_text(scene)), scene);
}

TEST(Writing, GivesAnythingButAReferenceItsOwnSpelling) {
  const std::string colour = "def ward = rgb (1, 0, 0) begin " + triangle("brdf ward") + "end";
  EXPECT_THAT(to_text(scene_of(colour)), HasSubstr("    brdf ward\n"))
      << "the name of a colour is not a BRDF";
  const std::string parameters = "def ward = brdf phong begin " + triangle("brdf ward sx=1") + "end";
  EXPECT_THAT(to_text(scene_of(parameters)), HasSubstr("    brdf ward sx=1\n"));
  const std::string definition = "def ward = brdf phong begin def shiny = brdf ward begin end end";
  EXPECT_THAT(to_text(scene_of(definition)), HasSubstr("  def shiny = brdf ward\n"));
}

TEST(Writing, GivesTheSameBytesAgainForSurfacesThatAreEqualButWrittenOtherwise) {
  const std::string faces = "(0, 1, 2) brdf none light none (0, 1, 2) brdf Ward light rgb (-0, 1, 1)";
  const std::string text = to_text(scene_of(triangle("", "brdf ward light rgb (0, 1, 1) " + faces)));
  EXPECT_THAT(text, HasSubstr("brdf Ward\n    light rgb (-0, 1, 1)\n"));
  EXPECT_EQ(to_text(scene_of(text)), text);
}

/// Returns the text of a scene that no text gives, which must be readable.
std::string written(const Scene& scene) {
  scene_of(to_text(scene));
  return to_text(scene);
}

Scene scene_with(Block block) {
  Scene scene;
  scene.contents.blocks.push_back(std::move(block));
  return scene;
}

TEST(Writing, MakesReadableFilesOfTextThatNoFileCanHold) {
  MeshDraft mesh;
  mesh.name = "a \"b\"\n“c”";
  mesh.comments.end = {std::string(" one\nend\r\0two", 13), "three\r\r"};
  EXPECT_EQ(written(scene_with({Shared<Mesh>(grf::MeshDraft(mesh)), {{"x\ny"}, "\r"}, {}})),
            "//x y\n"
            "begin mesh “a \"b\" \"c\"”\n"
            "  begin vertexs\n"
            "  end vertexs\n"
            "  begin faces\n"
            "  end faces\n"
            "  // one end\r two\n"
            "  //three\n"
            "end mesh\n");
}

TEST(Writing, KeepsCommentsOfAttributesThatAreGone) {
  MeshDraft mesh;
  mesh.comments.brdf.before = {" shiny"};
  EXPECT_THAT(written(scene_with({Shared<Mesh>(grf::MeshDraft(mesh)), {}, {}})),
              HasSubstr("  // shiny\n  begin vertexs\n"));
}

TEST(Writing, KeepsTheMeaningOfBlocksThatTheGrammarLacks) {
  EXPECT_EQ(written(scene_with({Transform(), {}, {}})), "transform translation (0, 0, 0) begin\nend\n");
  EXPECT_EQ(written(scene_with({DefinitionScope(), {}, {}})), "transform translation (0, 0, 0) begin\nend\n");
}

TEST(Writing, OfNothingIsNoEmptyFile) { EXPECT_EQ(written(Scene()), "\n"); }

class WriteTest : public testing::Test {
 protected:
  Scene read_scene(const std::string& name) {
    Diagnostics diagnostics;
    const auto scene = read(folder.path(name), diagnostics);
    EXPECT_TRUE(scene) << diagnostics.to_text();
    return scene ? *scene : Scene();
  }

  /// Writes, and gives what is said about it with the folder left out of its paths.
  std::string write_scene(const Scene& scene, const std::string& name, bool expected = true) {
    Diagnostics diagnostics;
    EXPECT_EQ(write(scene, folder.path(name), diagnostics), expected);
    std::string said = diagnostics.to_text();
    for (auto at = said.find(folder.path()); at != std::string::npos; at = said.find(folder.path())) {
      said.erase(at, folder.path().size() + 1);
    }
    return said;
  }

  void expect_same_after_reading(const Scene& scene, const std::string& name) {
    EXPECT_EQ(read_scene(name), scene);
  }

  test::TemporaryFolder folder;
  const std::string light = "light begin (0,2,0) (1,0,0) (0,0,1) end";
};

Include& include_in(Scene& scene, std::size_t index = 0) {
  return std::get<Include>(scene.contents.blocks.at(index).content);
}

void move_light(Include& include, float height) {
  std::get<AreaLight>(include.contents.edit().blocks[0].content).corner.y = height;
}

TEST_F(WriteTest, LeavesIncludedFilesThatDidNotChangeAsTheyAre) {
  folder.add("light.grf", light);
  folder.add("scene.grf", "include \"light.grf\"");
  Scene scene = read_scene("scene.grf");
  scene.contents.end_comments = {" changed"};
  EXPECT_EQ(write_scene(scene, "scene.grf"), "");
  EXPECT_EQ(test::bytes_of(folder.path("light.grf")), light);
  EXPECT_EQ(test::bytes_of(folder.path("scene.grf")), "include \"light.grf\"\n// changed\n");
}

TEST_F(WriteTest, NamesAndWritesIncludedFilesThatChanged) {
  folder.add("parts/light.grf", light);
  folder.add("parts/other.grf", light);
  folder.add("parts/room.grf", "include \"light.grf\" include \"other.grf\"");
  folder.add("scene.grf", "transform scale (2, 2, 2) begin include \"parts\\room.grf\" end");
  Scene scene = read_scene("scene.grf");
  auto& room =
      std::get<Include>(std::get<Transform>(scene.contents.blocks[0].content).body.blocks[0].content);
  move_light(std::get<Include>(room.contents.edit().blocks[0].content), 7);
  EXPECT_EQ(write_scene(scene, "scene.grf"),
            "parts/light.grf: note: this file, which the scene names, is written too\n"
            "parts/room.grf: note: this file, which the scene names, is written too\n");
  EXPECT_EQ(test::bytes_of(folder.path("parts/other.grf")), light);
  expect_same_after_reading(scene, "scene.grf");
  EXPECT_EQ(write_scene(scene, "scene.grf"), "") << "they are as they should be now";
}

TEST_F(WriteTest, WritesIncludedFilesBesideACopy) {
  folder.add("parts/light.grf", light);
  folder.add("scene.grf", "include \"parts/light.grf\"");
  const Scene scene = read_scene("scene.grf");
  std::filesystem::create_directory(folder.path("copy"));
  EXPECT_EQ(write_scene(scene, "copy/scene.grf"),
            "copy/parts/light.grf: note: this file, which the scene names, is written too\n");
  expect_same_after_reading(scene, "copy/scene.grf");
}

TEST_F(WriteTest, WritesAnIncludedFileThatWouldBeReadInAnotherWay) {
  folder.add("part.grf", triangle("brdf ward"));
  folder.add("scene.grf", "def shiny = brdf phong begin include \"part.grf\" end");
  Scene scene = read_scene("scene.grf");
  std::get<DefinitionScope>(scene.contents.blocks[0].content).definitions[0].name = "ward";
  EXPECT_EQ(write_scene(scene, "scene.grf"),
            "part.grf: note: this file, which the scene names, is written too\n");
  expect_same_after_reading(scene, "scene.grf");
}

TEST_F(WriteTest, WritesAFileThatIsIncludedTwiceIfBothPlacesAgree) {
  folder.add("light.grf", light);
  folder.add("scene.grf", "include \"light.grf\" include \"light.grf\"");
  Scene scene = read_scene("scene.grf");
  move_light(include_in(scene, 0), 7);
  EXPECT_EQ(
      write_scene(scene, "scene.grf", false),
      "light.grf: error: cannot write the file: it is included more than once, and was changed in one place "
      "only\n");
  EXPECT_EQ(test::bytes_of(folder.path("light.grf")), light);
  move_light(include_in(scene, 1), 7);
  EXPECT_EQ(write_scene(scene, "scene.grf"),
            "light.grf: note: this file, which the scene names, is written too\n");
  expect_same_after_reading(scene, "scene.grf");
}

TEST_F(WriteTest, WritesNothingOfASceneThatWouldIncludeItself) {
  Scene scene;
  Block block;
  block.content = Include{"scene.grf", {}, {}};
  scene.contents.blocks.push_back(block);
  EXPECT_EQ(write_scene(scene, "scene.grf", false),
            "scene.grf: error: cannot write the file: it would include itself\n");
  EXPECT_THAT(folder.names(), ElementsAre());
}

TEST_F(WriteTest, SaysWhyAFileCannotBeWritten) {
  EXPECT_EQ(write_scene(Scene(), "nowhere/scene.grf", false),
            "nowhere/scene.grf: error: cannot create the file: No such file or directory\n");
  folder.add("light.grf", light);
  folder.add("scene.grf", "include \"light.grf\"");
  Scene scene = read_scene("scene.grf");
  move_light(include_in(scene), 7);
  std::filesystem::remove(folder.path("light.grf"));
  std::filesystem::create_directory(folder.path("light.grf"));
  EXPECT_THAT(write_scene(scene, "scene.grf", false),
              HasSubstr("light.grf: error: cannot write the file: it is a directory\n"));
}

const std::string Lit = "begin mesh begin vertexs irad (1, 2, 3) (0, 0, 0) end begin faces end end\n";

TEST_F(WriteTest, RefusesIrradianceUnderANameThatIsNotOfIgrf) {
  const Scene scene = scene_of(Lit);
  EXPECT_EQ(write_scene(scene, "scene.grf", false),
            "scene.grf: error: cannot write the file: it has irradiance, expected the name of an IGRF file, "
            "such as "
            "'scene.igrf'\n");
  EXPECT_THAT(folder.names(), ElementsAre());
  EXPECT_EQ(write_scene(scene, "scene.igrf"), "");
  EXPECT_EQ(write_scene(scene, "other.IGRF"), "");
  expect_same_after_reading(scene, "scene.igrf");
}

TEST_F(WriteTest, WantsTheNameOfIgrfOnlyForTheFileThatHoldsIrradiance) {
  folder.add("part.igrf", Lit);
  folder.add("scene.grf", "include \"part.igrf\"");
  Scene scene = read_scene("scene.grf");
  EXPECT_EQ(write_scene(scene, "scene.grf"), "");
  include_in(scene).file = "part.grf";
  EXPECT_EQ(
      write_scene(scene, "scene.grf", false),
      "part.grf: error: cannot write the file: it has irradiance, expected the name of an IGRF file, such as "
      "'part.igrf'\n");
}

TEST_F(WriteTest, LeavesAFileAloneThatItReadUnderAnotherName) {
  folder.add("part.grf", Lit);
  folder.add("scene.grf", "include \"part.grf\"");
  EXPECT_EQ(write_scene(read_scene("scene.grf"), "scene.grf"), "") << "it is not written";
}

/// Scenes that are finite but for one number.
std::vector<Scene> infinite_scenes() {
  const float infinity = std::numeric_limits<float>::infinity();
  std::vector<Scene> scenes;
  const auto add = [&](const std::string& text, const auto& change) {
    scenes.push_back(scene_of(text));
    change(scenes.back().contents.blocks[0]);
  };
  const auto mesh_in = [](Block& block) -> Mesh& { return std::get<Shared<Mesh>>(block.content).edit(); };
  const auto add_mesh = [&](const auto& change_of_draft) {
    add(triangle(), [&](Block& block) {
      MeshDraft mesh(mesh_in(block));
      change_of_draft(mesh);
      mesh_in(block) = Mesh(std::move(mesh));
    });
  };
  const auto definition_in = [](Block& block) -> Definition::Body& {
    return std::get<DefinitionScope>(block.content).definitions.back().body;
  };
  add_mesh([&](MeshDraft& mesh) { mesh.positions[0].y = infinity; });
  add_mesh([&](MeshDraft& mesh) { mesh.positions[0].y = std::nanf(""); });
  add_mesh([&](MeshDraft& mesh) { mesh.normals.set(1, Vec3f(infinity)); });
  add_mesh([&](MeshDraft& mesh) { mesh.uvs.set(1, Vec2f(0, infinity)); });
  add_mesh([&](MeshDraft& mesh) { mesh.irradiance.set(1, Colour(infinity)); });
  add_mesh([&](MeshDraft& mesh) {
    mesh.irradiance.set(1, std::vector<DirectionalIrradiance>{{Vec3f(infinity), Colour(1)}});
  });
  add(triangle("rgb (1, 1, 1)"), [&](Block& block) { mesh_in(block).surfaces[0].colour = Colour(infinity); });
  add(triangle(), [&](Block& block) { mesh_in(block).surfaces[0].emission = Colour(infinity); });
  add(triangle(), [&](Block& block) {
    mesh_in(block).surfaces[0].opacity = Opacity{Opacity::Kind::Blend, infinity};
  });
  add(triangle("brdf ward sx=1"), [&](Block& block) {
    std::get<BrdfModel>(*mesh_in(block).surfaces[0].brdf).arguments[0].value = infinity;
  });
  add("def a = pdf few n=1 begin end",
      [&](Block& block) { std::get<PdfModel>(definition_in(block)).arguments[0].value = Colour(infinity); });
  add("def a = brdf ward b = brdf combine 1 a begin end",
      [&](Block& block) { std::get<BrdfModel>(definition_in(block)).terms[0].weight = infinity; });
  add("def a = rgb (1, 1, 1) begin end", [&](Block& block) { definition_in(block) = Colour(infinity); });
  add("params begin end",
      [&](Block& block) { std::get<Params>(block.content).views.emplace_back(infinity); });
  add("transform scale (1, 1, 1) begin end",
      [&](Block& block) { std::get<Transform>(block.content).steps[0].value.z = infinity; });
  add("light begin (0, 0, 0) (1, 0, 0) (0, 1, 0) end",
      [&](Block& block) { std::get<AreaLight>(block.content).radiance = Colour(infinity); });
  return scenes;
}

TEST_F(WriteTest, RefusesNumbersThatCannotBeReadAgain) {
  for (const Scene& scene : infinite_scenes()) {
    EXPECT_EQ(write_scene(scene, "scene.igrf", false),
              "scene.igrf: error: cannot write the file: it would have numbers that are infinite or not a "
              "number (nan)\n")
        << to_text(scene);
  }
  EXPECT_THAT(folder.names(), ElementsAre());
}

TEST_F(WriteTest, RefusesWordsThatCannotBeReadAgain) {
  for (const char* word : {"", "two words", "7", "-", "begin", "TRUE", "none", "Rgb", "color", "brdf", "pdf",
                           "texture", "ni\u00F1o"}) {
    Scene scene = scene_of(triangle("pdf few mode=warp"));
    Surface& surface = std::get<Shared<Mesh>>(scene.contents.blocks[0].content).edit().surfaces[0];
    std::get<PdfModel>(*surface.pdf).arguments[0].value = Word{word};
    EXPECT_EQ(write_scene(scene, "scene.grf", false),
              "scene.grf: error: cannot write the file: it would have words as values of parameters that are "
              "not names, or that begin a definition (such as rgb)\n")
        << word;
  }
  EXPECT_THAT(folder.names(), ElementsAre());
}

/// The BRDF that a scene defines, in a file of its own.
BrdfModel& brdf_in(Scene& scene) {
  return std::get<BrdfModel>(
      std::get<DefinitionScope>(scene.contents.blocks.at(0).content).definitions[0].body);
}

class WriteBrdfFile : public WriteTest {
 protected:
  void SetUp() override {
    folder.add("brdfs/gold.brdf", text);
    folder.add("scene.grf",
               "def gold = brdf \"brdfs/gold.brdf\" begin " + triangle("brdf \"brdfs/gold.brdf\"") + "end");
    scene = read_scene("scene.grf");
  }
  std::string brdf_text() const { return test::bytes_of(folder.path("brdfs/gold.brdf")); }

  const std::string text = "// bright\nBRDF Ward   sx=0.10 // along";
  Scene scene;
};

TEST_F(WriteBrdfFile, LeavesItAsItIsWhereTheBrdfDidNotChange) {
  brdf_in(scene).keyword = "WARD";
  EXPECT_EQ(write_scene(scene, "scene.grf"), "") << "the case of a keyword is no change";
  EXPECT_EQ(brdf_text(), text);
}

TEST_F(WriteBrdfFile, NamesAndWritesItWithItsCommentsWhereTheBrdfChanged) {
  std::get<DefinitionScope>(scene.contents.blocks[0].content).body = {};
  brdf_in(scene).arguments[0].value = 0.2F;
  EXPECT_EQ(write_scene(scene, "scene.grf"),
            "brdfs/gold.brdf: note: this file, which the scene names, is written too\n");
  EXPECT_EQ(brdf_text(), "// bright\n// along\nWard sx=0.2\n");
  expect_same_after_reading(scene, "scene.grf");
}

TEST_F(WriteBrdfFile, WritesItBesideACopy) {
  std::filesystem::create_directory(folder.path("copy"));
  EXPECT_EQ(write_scene(scene, "copy/scene.grf"),
            "copy/brdfs/gold.brdf: note: this file, which the scene names, is written too\n");
  expect_same_after_reading(scene, "copy/scene.grf");
}

TEST_F(WriteBrdfFile, CannotHoldTwoBrdfs) {
  brdf_in(scene).arguments[0].value = 0.2F;
  EXPECT_EQ(write_scene(scene, "scene.grf", false),
            "brdfs/gold.brdf: error: cannot write the file: it would have to hold several BRDFs\n");
  EXPECT_EQ(brdf_text(), text);
}

TEST_F(WriteBrdfFile, IsNotWrittenForASurfaceThatNoFaceHas) {
  auto& body = std::get<DefinitionScope>(scene.contents.blocks[0].content).body;
  Surface unused;
  unused.brdf = brdf_in(scene);
  std::get<BrdfModel>(*unused.brdf).instance_file = "unused.brdf";
  std::get<Shared<Mesh>>(body.blocks[0].content).edit().surfaces.push_back(unused);
  EXPECT_EQ(write_scene(scene, "scene.grf"), "");
  EXPECT_THAT(folder.names(), ElementsAre("brdfs", "scene.grf"));
}

TEST_F(WriteBrdfFile, CannotHoldNumbersThatCannotBeReadAgain) {
  std::get<DefinitionScope>(scene.contents.blocks[0].content).body = {};
  brdf_in(scene).arguments[0].value = std::numeric_limits<float>::infinity();
  EXPECT_THAT(write_scene(scene, "scene.grf", false), HasSubstr("it would have numbers that are infinite"));
  EXPECT_EQ(brdf_text(), text);
}

}  // namespace
}  // namespace grf
