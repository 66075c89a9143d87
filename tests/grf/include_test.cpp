#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/grf/reading.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

const std::string Light = "light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end\n";

class IncludeTest : public testing::Test {
 protected:
  /// Reads the file; what is said about it has the folder left out of its paths.
  std::optional<Scene> read_file_named(const std::string& name) {
    Diagnostics diagnostics;
    auto scene = read(folder.path(name), diagnostics);
    said = diagnostics.to_text();
    const std::string prefix = folder.path() + "/";
    for (auto at = said.find(prefix); at != std::string::npos; at = said.find(prefix, at)) {
      said.erase(at, prefix.size());
    }
    return scene;
  }

  std::size_t count_lights(const Scene& scene) {
    std::size_t count = 0;
    SceneVisitor visitor;
    visitor.light = [&](const AreaLight&, const Placement&, const Block&) { ++count; };
    visit(scene, visitor);
    return count;
  }

  test::TemporaryFolder folder;
  std::string said;
};

TEST_F(IncludeTest, IsANodeWithTheContentsOfItsFile) {
  folder.add("light.grf", Light);
  folder.add("scene.grf", "include \"light.grf\"");
  const auto scene = read_file_named("scene.grf");
  ASSERT_TRUE(scene) << said;
  const auto& include = block<Include>(scene->contents);
  EXPECT_EQ(include.file, "light.grf");
  EXPECT_EQ(*include.contents, scene_of(Light).contents);
  EXPECT_EQ(include.origin.path, folder.path("light.grf"));
  EXPECT_EQ(include.origin.contents, include.contents);
}

TEST_F(IncludeTest, IsRelativeToTheFileThatNamesIt) {
  folder.add("parts/inner/light.grf", Light);
  folder.add("parts/room.grf", "include \"inner\\light.grf\" include \"./inner/../inner/light.grf\"");
  folder.add("scene.grf", "include \"parts/room.grf\" include \"" + folder.path("parts/room.grf") + "\"");
  const auto scene = read_file_named("scene.grf");
  ASSERT_TRUE(scene) << said;
  EXPECT_EQ(count_lights(*scene), 4U);
}

TEST_F(IncludeTest, StandsInTheScopeAndUnderTheTransformsOfItsPlace) {
  folder.add("part.grf", triangle("rgb red"));
  folder.add("scene.grf",
             "def red = rgb (1, 0, 0) begin transform scale (3, 3, 3) begin include \"part.grf\" end end");
  const auto scene = read_file_named("scene.grf");
  ASSERT_TRUE(scene) << said;
  SceneVisitor visitor;
  visitor.mesh = [](const Mesh& mesh, const Placement& placement, const Block&) {
    EXPECT_EQ(resolve(mesh.surface(0), placement.scope).colour, Colour(1, 0, 0));
    EXPECT_EQ(Vec3d(1, 1, 1) * placement.to_world, Vec3d(3, 3, 3));
  };
  visit(*scene, visitor);
}

TEST_F(IncludeTest, GivesItsDefinitionsToNobody) {
  folder.add("part.grf", "def red = rgb (1, 0, 0) begin end");
  folder.add("scene.grf", "include \"part.grf\"\n" + triangle("rgb red"));
  EXPECT_FALSE(read_file_named("scene.grf"));
  EXPECT_NE(said.find("scene.grf:2:16: error: no colour called 'red'"), std::string::npos) << said;
}

TEST_F(IncludeTest, IsReadOnceForAllPlacesWhereItMeansTheSame) {
  folder.add("part.grf", triangle("brdf material"));
  folder.add("scene.grf",
             "include \"part.grf\" include \"part.grf\" def material = brdf ward begin include \"part.grf\" "
             "end def material = brdf phong begin include \"part.grf\" end def material = rgb (1, 0, 0) "
             "begin include \"part.grf\" end");
  const auto scene = read_file_named("scene.grf");
  ASSERT_TRUE(scene) << said;
  const auto contents = [&](std::size_t index) {
    const auto* include = std::get_if<Include>(&scene->contents.blocks[index].content);
    if (include == nullptr) {
      include = &block<Include>(block<DefinitionScope>(scene->contents, index).body);
    }
    return &*include->contents;
  };
  EXPECT_EQ(contents(0), contents(1));
  EXPECT_NE(contents(1), contents(2)) << "the word is a keyword outside and a reference inside";
  EXPECT_EQ(contents(2), contents(3)) << "whatever the name means, it is that of a BRDF";
  EXPECT_NE(contents(3), contents(4)) << "here it is that of a colour";
  EXPECT_EQ(*contents(1), *contents(4)) << "and so no reference";
}

TEST_F(IncludeTest, CannotIncludeItself) {
  folder.add("a.grf", Light + "include \"parts/b.grf\"");
  folder.add("parts/b.grf", "include \"c.grf\"");
  folder.add("parts/c.grf", "include \"../parts/b.grf\"");
  EXPECT_FALSE(read_file_named("a.grf"));
  EXPECT_EQ(
      said,
      "parts/c.grf:1:9: error: 'parts/b.grf' includes itself: parts/b.grf -> parts/c.grf -> parts/b.grf\n"
      "  include \"../parts/b.grf\"\n"
      "          ^\n"
      "  included from parts/b.grf:1:9\n"
      "  included from a.grf:2:9\n");
}

TEST_F(IncludeTest, CannotIncludeItselfByALink) {
  folder.add("a.grf", "include \"b.grf\"");
  std::filesystem::create_symlink("a.grf", folder.path("b.grf"));
  EXPECT_FALSE(read_file_named("a.grf"));
  EXPECT_NE(said.find("includes itself: a.grf -> b.grf"), std::string::npos) << said;
}

TEST_F(IncludeTest, MayBeNestedSixtyFourDeep) {
  for (int i = 0; i < 65; ++i) {
    folder.add(std::to_string(i) + ".grf", "include \"" + std::to_string(i + 1) + ".grf\"");
  }
  folder.add("64.grf", Light);
  EXPECT_TRUE(read_file_named("0.grf")) << said;
  folder.add("scene.grf", "include \"0.grf\"");
  EXPECT_FALSE(read_file_named("scene.grf"));
  EXPECT_EQ(said.substr(0, said.find('\n')), "63.grf:1:9: error: includes are nested deeper than 64");
}

TEST_F(IncludeTest, CountsTowardsTheNestingOfBlocks) {
  std::string text = "include \"inner.grf\"";
  for (int i = 0; i < 600; ++i) text = "transform scale (2, 2, 2) begin " + text + " end";
  folder.add("scene.grf", text);
  folder.add("inner.grf", text.replace(text.find("include"), 19, Light));
  EXPECT_FALSE(read_file_named("scene.grf"));
  EXPECT_NE(said.find("inner.grf:1:12801: error: blocks are nested deeper than 1000\n"), std::string::npos)
      << said;
}

TEST_F(IncludeTest, SaysWhatIsWrongWithItsFile) {
  folder.add("empty.grf", "");
  folder.add("binary.grf", std::string("\0\1", 2));
  std::filesystem::create_directory(folder.path("folder"));
  folder.add("scene.grf",
             "include \"empty.grf\" include \"binary.grf\" include \"folder\" include \"nowhere.grf\"");
  EXPECT_FALSE(read_file_named("scene.grf"));
  EXPECT_NE(said.find("empty.grf: error: the file is empty"), std::string::npos) << said;
  EXPECT_NE(said.find("binary.grf: error: this is a binary file"), std::string::npos) << said;
  EXPECT_NE(said.find("scene.grf:1:50: error: cannot read 'folder': it is a directory"), std::string::npos)
      << said;
  EXPECT_NE(said.find("scene.grf:1:67: error: cannot read 'nowhere.grf': No such file"), std::string::npos)
      << said;
}

TEST_F(IncludeTest, IsReportedOnceHoweverOftenItIsIncluded) {
  folder.add("wrong.grf", "light begin end");
  folder.add("scene.grf", "include \"wrong.grf\" include \"wrong.grf\" include \"wrong.grf\"");
  EXPECT_FALSE(read_file_named("scene.grf"));
  EXPECT_EQ(said,
            "wrong.grf:1:13: error: found 'end', expected '(' and three numbers\n"
            "  light begin end\n"
            "              ^\n"
            "  included from scene.grf:1:9\n");
}

TEST_F(IncludeTest, CannotMakeASceneWithoutEnd) {
  for (int i = 0; i < 40; ++i) {
    const std::string include = "include \"" + std::to_string(i + 1) + ".grf\" ";
    folder.add(std::to_string(i) + ".grf", include + include);
  }
  folder.add("40.grf", Light);
  EXPECT_FALSE(read_file_named("0.grf"));
  EXPECT_NE(said.find("the same files are included too often"), std::string::npos) << said;
  EXPECT_EQ(said.find("error"), said.rfind("error")) << said;
}

TEST_F(IncludeTest, MayPlaceOneFileManyTimesButNotMoreThanAHundredThousand) {
  folder.add("light.grf", Light);
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "include \"light.grf\"\n";
  folder.add("many.grf", text);
  const auto scene = read_file_named("many.grf");
  ASSERT_TRUE(scene) << said;
  EXPECT_EQ(count_lights(*scene), 100'000U);
  folder.add("more.grf", text + "include \"light.grf\"\n");
  EXPECT_FALSE(read_file_named("more.grf"));
  EXPECT_EQ(said.substr(0, said.find(',')), "more.grf:100001:9: error: more than 100000 includes") << said;
}

}  // namespace
}  // namespace grf
