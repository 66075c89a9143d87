#include "editor/document/scene_patch.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "grf/write.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

std::string mesh(const std::string& name, const std::string& surface, const std::string& faces) {
  return "begin mesh \"" + name + "\"\n" + surface +
         "\nbegin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) (1, 1, 0) end vertexs\nbegin faces " + faces +
         " end faces\nend mesh\n";
}

/// Scenes that each differ in one thing from the one before; the last differs in all.
std::vector<std::string> scenes() {
  const std::string plain = mesh("a", "", "(0, 1, 2) (1, 3, 2)");
  const std::string red = mesh("a", "rgb (1, 0, 0)", "(0, 1, 2) (1, 3, 2)");
  const std::string half = mesh("a", "rgb (1, 0, 0)", "(0, 1, 2) rgb (0, 1, 0) (1, 3, 2)");
  const std::string light = "arealight (0, 0, 1) (1, 0, 1) (0, 1, 1)\n";
  const auto moved = [](const std::string& steps, const std::string& body) {
    return "transform " + steps + " begin\n" + body + "end\n";
  };
  const auto defined = [](const std::string& definitions, const std::string& body) {
    return "def " + definitions + "\nbegin\n" + body + "end\n";
  };
  return {
      plain,
      red,
      half,
      mesh("b", "rgb (1, 0, 0)", "(0, 1, 2) rgb (0, 1, 0) (1, 3, 2)"),
      mesh("b", "rgb (1, 0, 0)", "(0, 1, 3)"),
      half + red,
      "// before\n" + half + red + "// at the end\n",
      red + half + plain,
      moved("scale (2, 2, 2)", red + half),
      moved("scale (3, 2, 2)", red + half),
      moved("scale (3, 2, 2)", red + "// another\n" + plain),
      defined("c = rgb (1, 1, 0)", moved("scale (3, 2, 2)", red)),
      defined("c = rgb (1, 0, 0)", moved("scale (3, 2, 2)", red)),
      defined("c = rgb (1, 0, 0) d = brdf phong", moved("scale (3, 2, 2)", half)),
      defined("d = brdf phong c = rgb (1, 0, 0)", moved("scale (3, 2, 2)", half)),
      defined("m = " + red, "use m\n"),
      defined("m = " + half, "use m\n"),
  };
}

TEST(ScenePatch, LeadsFromEachStateToTheOther) {
  const std::vector<std::string> texts = scenes();
  for (const std::string& from : texts) {
    for (const std::string& to : texts) {
      const grf::Scene before = scene_of(from);
      const grf::Scene after = scene_of(to);
      const ScenePatch patch = ScenePatch::between(before, after);
      EXPECT_EQ(patch.empty(), before == after);
      grf::Scene scene = before;
      patch.apply(scene);
      EXPECT_EQ(grf::to_text(scene), grf::to_text(after)) << "from\n" << from;
      patch.revert(scene);
      EXPECT_EQ(grf::to_text(scene), grf::to_text(before)) << "from\n" << to;
    }
  }
}

TEST(ScenePatch, TakesUpWhatFollows) {
  const std::vector<std::string> texts = scenes();
  for (std::size_t i = 0; i + 2 < texts.size(); ++i) {
    const grf::Scene first = scene_of(texts[i]);
    const grf::Scene second = scene_of(texts[i + 1]);
    const grf::Scene third = scene_of(texts[i + 2]);
    ScenePatch patch = ScenePatch::between(first, second);
    patch.append(ScenePatch::between(second, third));
    grf::Scene scene = first;
    patch.apply(scene);
    EXPECT_EQ(grf::to_text(scene), grf::to_text(third)) << texts[i];
    patch.revert(scene);
    EXPECT_EQ(grf::to_text(scene), grf::to_text(first)) << texts[i];
  }
}

TEST(ScenePatch, SaysWhatItChanges) {
  const std::vector<std::string> texts = scenes();
  const auto change = [&](std::size_t from, std::size_t to) {
    return ScenePatch::between(scene_of(texts[from]), scene_of(texts[to])).change();
  };
  EXPECT_FALSE(change(0, 1).is_structural);
  EXPECT_FALSE(change(1, 2).is_structural);
  EXPECT_TRUE(change(2, 3).names);
  EXPECT_FALSE(change(2, 3).is_structural) << "a name alone";
  EXPECT_TRUE(change(3, 4).is_structural) << "other faces";
  EXPECT_TRUE(change(8, 9).transforms);
  EXPECT_FALSE(change(8, 9).is_structural) << "other steps of a transform";
  EXPECT_TRUE(change(11, 12).definitions);
  EXPECT_FALSE(change(11, 12).is_structural);
  EXPECT_TRUE(change(12, 13).is_structural) << "a definition came";
}

}  // namespace
}  // namespace editor
