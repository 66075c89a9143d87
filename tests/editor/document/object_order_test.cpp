#include "editor/document/object_order.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "editor/document/object_edits.h"
#include "grf/write.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Paths = std::vector<grf::ScenePath>;

std::string named_triangle(const std::string& name, const std::string& surface = {}) {
  return "begin mesh \"" + name + "\" " + surface +
         " begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs begin faces (0,1,2) end faces end mesh\n";
}
std::string translated_by(const std::string& offset, const std::string& body) {
  return "transform translation " + offset + " begin\n" + body + "end\n";
}

class MovingObjects : public testing::Test {
 protected:
  /// The scene after an edit, as text; the message if it failed.
  std::string text_after(const std::optional<TransformedObjects>& edited) {
    if (!edited) return diagnostics_.entries().front().message;
    paths_ = edited->paths;
    return grf::to_text(edited->scene);
  }
  static std::string text(const std::string& scene) { return grf::to_text(scene_of(scene)); }

  grf::Diagnostics diagnostics_;
  Paths paths_;
};

TEST_F(MovingObjects, ChangesTheOrder) {
  const grf::Scene scene =
      scene_of(named_triangle("a") + named_triangle("b") + named_triangle("c") + named_triangle("d"));
  EXPECT_EQ(text_after(move_objects(scene, {{2}, {0}}, {{}, 4}, diagnostics_)),
            text(named_triangle("b") + named_triangle("d") + named_triangle("a") + named_triangle("c")));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{3}, grf::ScenePath{2})) << "in the order of the arguments";
  EXPECT_EQ(text_after(move_objects(scene, {{3}}, place_before(scene, grf::ScenePath{1}), diagnostics_)),
            text(named_triangle("a") + named_triangle("d") + named_triangle("b") + named_triangle("c")));
  EXPECT_EQ(text_after(move_objects(scene, {{1}, {2}}, place_after(scene, grf::ScenePath{1}), diagnostics_)),
            grf::to_text(scene));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{1}, grf::ScenePath{2}));
}

TEST_F(MovingObjects, ShiftsAmongSiblings) {
  const std::string a = named_triangle("a"), b = named_triangle("b"), c = named_triangle("c"),
                    d = named_triangle("d");
  const grf::Scene scene = scene_of(a + b + c + d);
  const auto after = [&](const Paths& paths, int step) {
    return text_after(shift_objects(scene, paths, step));
  };
  EXPECT_EQ(after({{2}}, -1), text(a + c + b + d));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{1}));
  EXPECT_EQ(after({{3}, {1}}, -1), text(b + a + d + c)) << "each by one place";
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{2}, grf::ScenePath{0}));
  EXPECT_EQ(after({{0}, {1}, {3}}, -1), text(a + b + d + c)) << "those at the end stay";
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{0}, grf::ScenePath{1}, grf::ScenePath{2}));
  EXPECT_EQ(after({{0}, {1}}, 1), text(c + a + b + d));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{1}, grf::ScenePath{2}));
  EXPECT_EQ(after({{3}}, 1), text(a + b + c + d));
  const grf::Scene scope =
      scene_of("def red = rgb (1, 0, 0)\nbegin\n" + a + translated_by("(1, 0, 0)", b) + "end\n");
  EXPECT_EQ(text_after(shift_objects(scope, {{0, 2, 0}}, -1)),
            text("def red = rgb (1, 0, 0)\nbegin\n" + translated_by("(1, 0, 0)", b) + a + "end\n"))
      << "with its own transform, behind the definitions";
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{0, 1, 0}));
  EXPECT_EQ(text_after(shift_objects(scope, {{0, 1}}, -1)), grf::to_text(scope));
}

TEST_F(MovingObjects, LeavesAndEntersGroups) {
  const std::string a = named_triangle("a"), b = named_triangle("b"), c = named_triangle("c"),
                    d = named_triangle("d");
  const grf::Scene scene = scene_of(translated_by("(1, 2, 3)", a + b + c) + d);
  EXPECT_EQ(text_after(move_out_of_group(scene, {{0, 1}}, diagnostics_)),
            text(translated_by("(1, 2, 3)", a + c) + translated_by("(1, 2, 3)", b) + d));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{1, 0}));
  EXPECT_EQ(text_after(move_into_group(scene, {{1}}, diagnostics_)),
            text(translated_by("(1, 2, 3)", a + b + c + translated_by("(-1, -2, -3)", d))));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{0, 3, 0}));
  EXPECT_THAT(text_after(move_out_of_group(scene, {{1}}, diagnostics_)), HasSubstr("in no group"));
  diagnostics_ = {};
  EXPECT_THAT(text_after(move_into_group(scene, {{0}}, diagnostics_)), HasSubstr("no group in front"));
  diagnostics_ = {};
  const grf::Scene single = scene_of(translated_by("(1, 2, 3)", a) + b);
  EXPECT_THAT(text_after(move_into_group(single, {{1}}, diagnostics_)), HasSubstr("no group in front"))
      << "a transform of one object is no group";
}

TEST_F(MovingObjects, KeepsTheirPlaceInWorldSpace) {
  const grf::Scene scene = scene_of(translated_by("(1, 2, 3)", named_triangle("a") + named_triangle("b")) +
                                    translated_by("(0.1, 0, 0)", named_triangle("c")));
  EXPECT_EQ(text_after(move_objects(scene, {{1, 0}}, place_at_end(scene, grf::ScenePath{0}), diagnostics_)),
            text(translated_by("(1, 2, 3)", named_triangle("a") + named_triangle("b") +
                                                translated_by("(-0.9, -2, -3)", named_triangle("c")))));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{0, 2, 0}));
  const grf::Scene into =
      move_objects(scene, {{1, 0}}, place_at_end(scene, grf::ScenePath{0}), diagnostics_)->scene;
  EXPECT_EQ(text_after(move_objects(into, {{0, 2, 0}}, place_at_end(into, {}), diagnostics_)),
            grf::to_text(scene))
      << "and back: the same numbers";
  EXPECT_EQ(
      text_after(move_objects(scene, {{0, 1}}, {{}, 0}, diagnostics_)),
      text(translated_by("(1, 2, 3)", named_triangle("b")) + translated_by("(1, 2, 3)", named_triangle("a")) +
           translated_by("(0.1, 0, 0)", named_triangle("c"))));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{0, 0}));
}

TEST_F(MovingObjects, KeepsTheirPlaceUnderRotationAndScale) {
  const grf::Scene scene =
      scene_of("transform scale (2, 3, 4) rotation (0.5, -0.25, 1) translation (1, 2, 3) begin\n" +
               named_triangle("a") + named_triangle("b") + "end\n" +
               translated_by("(0.1, 0, 0)", named_triangle("c")));
  const auto corners = [](const grf::Scene& of, const std::string& name) {
    const SceneObjects objects = objects_of(of, {});
    std::vector<grf::Vec3d> found;
    for (const MeshInstance& instance : *objects.instances) {
      if (objects.meshes[instance.mesh].name != name) continue;
      for (const auto& position : objects.meshes[instance.mesh].mesh->geometry->positions)
        found.push_back(grf::Vec3d(position) * instance.to_world);
    }
    return found;
  };
  const auto in = move_objects(scene, {{1, 0}}, {{0}, 1}, diagnostics_);
  const auto out = move_objects(scene, {{0, 1}}, {{}, 0}, diagnostics_);
  ASSERT_TRUE(in && out);
  EXPECT_EQ(in->paths.front().front(), 0U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT((corners(in->scene, "c")[i] - corners(scene, "c")[i]).length(), 1e-5);
    EXPECT_EQ(corners(out->scene, "b")[i], corners(scene, "b")[i]) << "the same steps";
  }
}

TEST_F(MovingObjects, RefusesWhatCannotBe) {
  const grf::Scene scene =
      scene_of(translated_by("(1, 0, 0)", named_triangle("a") + named_triangle("b")) + named_triangle("c"));
  EXPECT_EQ(text_after(move_objects(scene, {{0}}, {{0}, 1}, diagnostics_)),
            "an object cannot be moved into itself");
  diagnostics_ = {};
  EXPECT_THAT(text_after(group_objects(scene, {{1}}, diagnostics_)), HasSubstr("two objects"));
  diagnostics_ = {};
  EXPECT_EQ(text_after(ungroup_objects(scene, {{1}}, diagnostics_)), "only groups can be ungrouped");
}

TEST_F(MovingObjects, KeepsTheMeaningOfNames) {
  // Two scopes: inside the second one "paint" is another colour, and "inner" is known only in the first one.
  const std::string first = "def paint = rgb (1, 0, 0)\ndef inner = rgb (0, 1, 0)\nbegin\n" +
                            named_triangle("red", "rgb paint") + named_triangle("green", "rgb inner") +
                            named_triangle("plain") + "end\n";
  const std::string second =
      "def paint = rgb (0, 0, 1)\nbegin\n" + named_triangle("blue", "rgb paint") + "end\n";
  const grf::Scene scene = scene_of(first + second);
  const BlockPlace there = place_after(scene, grf::ScenePath{1, 1});
  EXPECT_EQ(text_after(move_objects(scene, {{0, 2}}, there, diagnostics_)),
            "it uses 'paint', which is the name of something else there");
  diagnostics_ = {};
  EXPECT_EQ(text_after(move_objects(scene, {{0, 3}}, there, diagnostics_)),
            "it uses 'inner', which is not defined there");
  diagnostics_ = {};
  EXPECT_EQ(text_after(move_objects(scene, {{0, 3}}, {{}, 2}, diagnostics_)),
            "it uses 'inner', which is not defined there");
  diagnostics_ = {};
  EXPECT_TRUE(move_objects(scene, {{0, 4}}, there, diagnostics_)) << "it uses no name";
  EXPECT_TRUE(move_objects(scene, {{0}}, {{}, 2}, diagnostics_)) << "a scope moves with its definitions";
  EXPECT_TRUE(move_objects(scene, {{0, 2}}, place_at_end(scene, grf::ScenePath{0}), diagnostics_));
}

TEST_F(MovingObjects, GroupsAndUngroups) {
  const grf::Scene scene = scene_of(named_triangle("a") + named_triangle("b") +
                                    translated_by("(1, 0, 0)", named_triangle("c") + named_triangle("d")));
  const std::string grouped =
      text(named_triangle("a") +
           translated_by("(0, 0, 0)", named_triangle("b") + translated_by("(1, 0, 0)", named_triangle("d"))) +
           translated_by("(1, 0, 0)", named_triangle("c")));
  EXPECT_EQ(text_after(group_objects(scene, {{2, 1}, {1}}, diagnostics_)), grouped);
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{1}));
  EXPECT_EQ(text_after(ungroup_objects(scene, {{2}}, diagnostics_)),
            text(named_triangle("a") + named_triangle("b") + translated_by("(1, 0, 0)", named_triangle("c")) +
                 translated_by("(1, 0, 0)", named_triangle("d"))));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{2, 0}, grf::ScenePath{3, 0}));
  const auto again = group_objects(scene, {{0}, {1}}, diagnostics_);
  ASSERT_TRUE(again);
  EXPECT_EQ(text_after(ungroup_objects(again->scene, again->paths, diagnostics_)), grf::to_text(scene));
}

TEST_F(MovingObjects, MovesIncludesWhole) {
  grf::Scene scene = scene_of(named_triangle("a") + named_triangle("b"));
  grf::Block include;
  include.content =
      grf::Include{"part.grf", scene_of(named_triangle("inside") + named_triangle("too")).contents, {}};
  scene.contents.blocks.insert(scene.contents.blocks.begin(), include);
  const auto edited = move_objects(scene, {{0, 1}}, {{}, 3}, diagnostics_);
  ASSERT_TRUE(edited);
  EXPECT_THAT(edited->paths, ElementsAre(grf::ScenePath{2, 1}));
  EXPECT_TRUE(edited->scene.contents.blocks.back() == include);
  EXPECT_THAT(text_after(move_objects(scene, {{1}}, {{0}, 1}, diagnostics_)), HasSubstr("included file"));
}

TEST_F(MovingObjects, MakesInstances) {
  const std::string tile = "def paint = rgb (1, 0, 0)\ndef tile = " + named_triangle("", "rgb paint");
  const grf::Scene scene = scene_of(tile + "begin\n" + named_triangle("a") + "end\n");
  const auto used = use_definition(scene, grf::ScenePath{0, 1}, place_at_end(scene, {}), diagnostics_);
  EXPECT_EQ(text_after(used), text(tile + "begin\n" + named_triangle("a") + "use tile\nend\n"));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{0, 3}));
  const auto single = make_single(used->scene, {{0, 3}}, diagnostics_);
  ASSERT_TRUE(single);
  EXPECT_EQ(text_after(single),
            text(tile + "begin\n" + named_triangle("a") + named_triangle("tile", "rgb paint") + "end\n"));
  EXPECT_EQ(text_after(make_instance(scene, {0, 2}, diagnostics_)),
            text(tile + "def a = " + named_triangle("a") + "begin\nuse a\nend\n"));
  EXPECT_THAT(paths_, ElementsAre(grf::ScenePath{0, 3}));
  EXPECT_FALSE(use_definition(scene, grf::ScenePath{0, 0}, place_at_end(scene, {}), diagnostics_))
      << "a colour";
}

TEST_F(MovingObjects, RefusesInstancesOutOfScope) {
  const std::string tile = "def paint = rgb (1, 0, 0)\ndef tile = " + named_triangle("", "rgb paint");
  const grf::Scene scene = scene_of(tile + "begin\ndef paint = rgb (0, 1, 0)\nbegin\nuse tile\nend\nend\n" +
                                    named_triangle("out"));
  EXPECT_FALSE(make_single(scene, {{0, 2, 1}}, diagnostics_));
  EXPECT_EQ(diagnostics_.entries().front().message,
            "it uses 'paint', which is the name of something else there");
  diagnostics_ = {};
  EXPECT_EQ(text_after(use_definition(scene, grf::ScenePath{0, 1}, {{}, 2}, diagnostics_)),
            "'tile' is not defined there");
}

TEST_F(MovingObjects, IsOneUndoStepThatKeepsTheSelection) {
  Document document;
  document.take(scene_of(named_triangle("a") + named_triangle("b") + named_triangle("c")), {}, {});
  document.select_objects({{0}, {2}});
  const grf::Scene before = document.scene();
  document.replace_objects("Group", *group_objects(before, document.selected_objects(), diagnostics_));
  EXPECT_THAT(document.selected_objects(), ElementsAre(grf::ScenePath{0}));
  document.undo_stack().undo();
  EXPECT_TRUE(document.scene() == before);
  EXPECT_THAT(document.selected_objects(), ElementsAre(grf::ScenePath{0}, grf::ScenePath{2}));
  EXPECT_EQ(document.undo_stack().count(), 1);
}

}  // namespace
}  // namespace editor
