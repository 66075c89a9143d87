// Tests of nesting at the maximum depth and beyond: blocks in blocks, files in files, sums of sums. The
// stacks are smaller than those of the real threads.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "grf/check.h"
#include "grf/relocate.h"
#include "grf/summary.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "tests/grf/reading.h"
#include "tests/support/small_stack.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

const std::string LightInside = "light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end\n";

/// Makes alternating transforms and definitions, nested to a depth.
std::string nested_blocks(std::size_t depth, const std::string& innermost) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) {
    text += i % 2 == 0 ? "transform translation (1, 0, 0) begin\n" : "def a = rgb (1, 1, 1) begin\n";
  }
  text += innermost;
  for (std::size_t i = 0; i < depth; ++i) text += "end\n";
  return text;
}

/// c0 = diffuse, c1 = combine 1 c0, c2 = combine 1 c1 and so on.
std::string chain_of_sums(std::size_t length) {
  std::string text = "def c0 = brdf diffuse kd=0.25\n";
  for (std::size_t i = 1; i < length; ++i) {
    text += "def c" + std::to_string(i) + " = brdf combine 1 c" + std::to_string(i - 1) + "\n";
  }
  return text;
}

double x_of_the_light(const Scene& scene) {
  double x = -1;
  SceneVisitor visitor;
  visitor.light = [&x](const AreaLight& light, const Placement& placement, const Block&) {
    x = (Vec3d(light.corner) * placement.to_world).x;
  };
  visit(scene, visitor);
  return x;
}

/// Runs all operations on a whole scene.
void expect_all_is_possible(const Scene& scene, const std::string& path) {
  EXPECT_EQ(x_of_the_light(scene), 500);
  const Scene same = scene_of(to_text(scene));
  EXPECT_EQ(same, scene);
  EXPECT_EQ(nesting_of(scene.contents), DeepestNesting);
  EXPECT_FALSE(has_irradiance(scene.contents));
  EXPECT_EQ(summarize(scene).lights, 1U);
  Diagnostics diagnostics;
  EXPECT_TRUE(check(scene, {}, diagnostics)) << diagnostics.to_text();
  EXPECT_EQ(x_of_the_light(flatten(scene, path)), 500);
  EXPECT_EQ(x_of_the_light(with_absolute_names(scene, path)), 500);
  Scene moved = scene;
  relocate(moved, path, path + "/elsewhere/scene.grf");
  EXPECT_EQ(x_of_the_light(moved), 500);
  EXPECT_TRUE(write(scene, path, diagnostics)) << diagnostics.to_text();
  const auto again = read(path, diagnostics);
  ASSERT_TRUE(again) << diagnostics.to_text();
  EXPECT_EQ(*again, scene);
}

TEST(DeepNesting, OfAThousandBlocksFitsASmallStack) {
  const test::TemporaryFolder folder;
  test::run_on_small_stack([&] {
    expect_all_is_possible(scene_of(nested_blocks(DeepestNesting, LightInside)), folder.path("scene.grf"));
  });
}

TEST(DeepNesting, OfFilesInFilesFitsASmallStack) {
  // 64 files in files, with all but eight of the thousand blocks around the includes.
  const test::TemporaryFolder folder;
  for (int i = 0; i < 64; ++i) {
    folder.add(std::to_string(i) + ".grf",
               nested_blocks(i == 0 ? 118 : 14, "include \"" + std::to_string(i + 1) + ".grf\"\n"));
  }
  folder.add("64.grf", LightInside);
  test::run_on_small_stack([&] {
    Diagnostics diagnostics;
    const auto scene = read(folder.path("0.grf"), diagnostics);
    ASSERT_TRUE(scene) << diagnostics.to_text();
    EXPECT_EQ(nesting_of(scene->contents), 1000U);
    EXPECT_EQ(x_of_the_light(*scene), 500);
    EXPECT_EQ(x_of_the_light(flatten(*scene, folder.path("0.grf"))), 500);
    EXPECT_TRUE(write(*scene, folder.path("other.grf"), diagnostics)) << diagnostics.to_text();
  });
}

TEST(DeepNesting, IsNotHiddenByAFileThatWasReadBefore) {
  const test::TemporaryFolder folder;
  folder.add("deep.grf", nested_blocks(600, LightInside));
  std::string around;
  for (int i = 0; i < 401; ++i) around = "transform translation (1, 0, 0) begin " + around;
  std::string text = "include \"deep.grf\"\n" + around + "include \"deep.grf\"";
  for (int i = 0; i < 401; ++i) text += " end";
  Diagnostics diagnostics;
  EXPECT_FALSE(read(folder.add("scene.grf", text), diagnostics));
  EXPECT_NE(diagnostics.to_text().find("error: blocks are nested deeper than 1000"), std::string::npos)
      << diagnostics.to_text();
  EXPECT_EQ(diagnostics.error_count(), 1U);
  // One block less around it is as deep as blocks may stand.
  text.erase(text.find("transform translation (1, 0, 0) begin "), 38);
  Diagnostics none;
  EXPECT_TRUE(read(folder.add("scene.grf", text.substr(0, text.size() - 4)), none)) << none.to_text();
}

TEST(DeepNesting, ThatCouldNotBeReadAgainIsNotWritten) {
  const test::TemporaryFolder folder;
  Transform transform;
  transform.steps.push_back({TransformStep::Kind::Translation, Vec3f(1, 0, 0)});
  transform.body = scene_of(nested_blocks(DeepestNesting, LightInside)).contents;
  Scene scene;
  scene.contents.blocks.emplace_back().content = std::move(transform);
  Diagnostics diagnostics;
  EXPECT_FALSE(write(scene, folder.path("scene.grf"), diagnostics));
  EXPECT_EQ(diagnostics.entries().at(0).message,
            "cannot write the file: its blocks are nested deeper than 1000");
  EXPECT_TRUE(folder.names().empty());
}

// Indentation of a line a level would make megabytes of each thousand lines.
TEST(DeepNesting, IsNotWrittenInManyTimesItsBytes) {
  std::string lights;
  for (int i = 0; i < 2000; ++i) lights += LightInside;
  const std::string text = nested_blocks(DeepestNesting, lights);
  EXPECT_LT(to_text(scene_of(text)).size(), 10 * text.size());
}

TEST(SumsOfSums, CanBeAChainOfAnyLength) {
  constexpr std::size_t Length = 60'000;
  const std::string text = chain_of_sums(Length) +
                           "begin begin mesh brdf c59999 begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) "
                           "end begin faces (0, 1, 2) end end end";
  test::run_on_small_stack([&] {
    const Scene scene = scene_of(text);
    std::vector<WeightedBrdf> summands;
    SceneVisitor visitor;
    visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block&) {
      const ResolvedSurface surface = resolve(mesh.surface(0), placement.scope);
      summands = summands_of(*surface.brdf, surface.brdf_scope);
    };
    visit(scene, visitor);
    ASSERT_EQ(summands.size(), 1U);
    EXPECT_EQ(summands[0].model->keyword, "diffuse");
    EXPECT_EQ(summands[0].weight, 1);
    EXPECT_EQ(scene_of(to_text(scene)), scene);
  });
}

TEST(SumsOfSums, AddUpWhatTheyNameInItsOrder) {
  // s = 2 a + 3 (4 b + 5 a) + 0.5 c, with a + b + c each once.
  const Scene scene = scene_of(
      "def a = brdf diffuse b = brdf phong c = brdf ward t = brdf combine 4 b, 5 a s = brdf combine 2 a, 3 "
      "t, "
      "0.5 c begin begin mesh brdf s begin vertexs end begin faces end end end");
  SceneVisitor visitor;
  std::vector<std::pair<std::string, float>> found;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block&) {
    const ResolvedSurface surface = resolve(mesh.surfaces[0], placement.scope);
    for (const WeightedBrdf& one : summands_of(*surface.brdf, surface.brdf_scope)) {
      found.emplace_back(one.model->keyword, one.weight);
    }
  };
  visit(scene, visitor);
  EXPECT_EQ(found,
            (std::vector<std::pair<std::string, float>>{{"diffuse", 17}, {"phong", 12}, {"ward", 0.5F}}));
}

}  // namespace
}  // namespace grf
