#include "editor/rendering/baked_irradiance.h"

#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "tests/editor/rendering/rendering_helpers.h"

namespace editor {
namespace {

const std::string View = "params begin dependent view (1,2,3) end\n";

/// A triangle, with or without irradiance at its vertices.
std::string triangle(const std::string& irradiance = "") {
  return "begin mesh begin vertexs" + irradiance + " (0,0,0)" + irradiance + " (1,0,0)" + irradiance +
         " (0,1,0) end vertexs begin faces (0,1,2) end faces end mesh\n";
}
std::string irad(int value) { return " irad (" + std::to_string(value) + ",0,0)"; }

/// The red irradiance at the first vertex of each mesh instance, in order; -1 for none.
std::vector<float> irradiances(const grf::Scene& scene) {
  std::vector<float> values;
  grf::SceneVisitor visitor;
  visitor.mesh = [&values](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
    values.push_back(mesh.irradiance->has(0) ? std::get<grf::Colour>((*mesh.irradiance)[0]).x : -1);
  };
  grf::visit(scene, visitor);
  return values;
}

class BakedIrradianceTest : public testing::Test {
 protected:
  grf::Scene read(const std::string& name) const {
    grf::Diagnostics diagnostics;
    auto scene = grf::read(folder_.path(name), diagnostics);
    EXPECT_TRUE(scene) << diagnostics.to_text();
    return scene.value_or(grf::Scene());
  }
  std::string path() const { return folder_.path("scene.grf"); }
  /// Writes the scene and reads it again.
  grf::Scene again(const grf::Scene& scene, const std::string& name) const {
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(grf::write(scene, folder_.path(name), diagnostics)) << diagnostics.to_text();
    return read(name);
  }

  test::TemporaryFolder folder_;
};

TEST_F(BakedIrradianceTest, IsGivenToTheSceneAsItIsByNow) {
  const grf::Scene snapshot = test::scene_of_text(triangle() + triangle());
  const BakedIrradiance irradiance(snapshot,
                                   test::scene_of_text(triangle(irad(3)) + triangle(irad(5)) + View));
  grf::Scene edited = snapshot;
  auto& blocks = edited.contents.blocks;
  test::first_mesh(edited).edit().surfaces[0].colour = grf::Colour(0, 1, 0);
  blocks.insert(blocks.begin(), test::scene_of_text(triangle()).contents.blocks.front());
  const IrradiatedScene irradiated = irradiance.applied_to(edited, path());
  EXPECT_EQ(irradiances(irradiated.scene), (std::vector<float>{-1, 3, 5}));
  EXPECT_EQ(irradiated.meshes, 2U);
  EXPECT_EQ(irradiated.skipped, 1U) << "the triangle that is new";
  const auto& first = std::get<grf::Shared<grf::Mesh>>(irradiated.scene.contents.blocks[1].content);
  EXPECT_EQ(std::get<grf::Colour>(*first->surfaces[0].colour), grf::Colour(0, 1, 0));
  const auto& observer = std::get<grf::Params>(irradiated.scene.contents.blocks[3].content);
  EXPECT_EQ(observer.views, std::vector<grf::Vec3f>{grf::Vec3f(1, 2, 3)});
}

TEST_F(BakedIrradianceTest, IsNotGivenToWhatHasMovedOrIsOfAnotherScene) {
  const grf::Scene snapshot = test::scene_of_text(triangle() + triangle());
  const BakedIrradiance irradiance(snapshot,
                                   test::scene_of_text(triangle(irad(3)) + triangle(irad(5)) + View));
  grf::Scene moved = snapshot;
  grf::Transform transform;
  transform.steps.push_back({grf::TransformStep::Kind::Translation, grf::Vec3f(0, 0, 1)});
  transform.body.blocks.push_back(moved.contents.blocks[0]);
  moved.contents.blocks[0].content = transform;
  EXPECT_EQ(irradiances(irradiance.applied_to(moved, path()).scene), (std::vector<float>{-1, 5}));
  const grf::Scene other = test::scene_of_text(triangle());
  const IrradiatedScene irradiated = irradiance.applied_to(other, path());
  EXPECT_EQ(irradiated.meshes, 0U);
  EXPECT_EQ(irradiated.scene, other);
}

TEST_F(BakedIrradianceTest, KeepsIncludesInFilesThatMayHaveIt) {
  folder_.add("lamp.grf", "light begin (0,0,2) (1,0,0) (0,1,0) end\n");
  folder_.add("parts/part.grf", triangle());
  folder_.add("parts/part.igrf", triangle(irad(99)));  // of another scene
  folder_.add("scene.grf", "include \"lamp.grf\"\ninclude \"parts/part.grf\"\n" + triangle() + View);
  const grf::Scene scene = read("scene.grf");
  const BakedIrradiance irradiance(scene, test::scene_of_text(triangle(irad(3)) + triangle(irad(5)) + View));
  const IrradiatedScene irradiated = irradiance.applied_to(scene, path());
  EXPECT_EQ(irradiances(irradiated.scene), (std::vector<float>{3, 5}));
  EXPECT_EQ(irradiated.expanded_includes, 0U);
  const auto& blocks = irradiated.scene.contents.blocks;
  ASSERT_EQ(blocks.size(), 4U) << "the observer was there already";
  EXPECT_EQ(std::get<grf::Include>(blocks[0].content).file, "lamp.grf");
  EXPECT_EQ(std::get<grf::Include>(blocks[1].content).file, "parts/part_2.igrf");
  EXPECT_EQ(irradiances(again(irradiated.scene, "scene.igrf")), (std::vector<float>{3, 5}));
  EXPECT_EQ(irradiances(read("scene.grf")), (std::vector<float>{-1, -1})) << "whose files are as they were";
  EXPECT_EQ(irradiances(read("parts/part.igrf")), std::vector<float>{99});
}

TEST_F(BakedIrradianceTest, TakesAFileApartThatIsIncludedWhereOtherLightArrives) {
  folder_.add("parts/inner.grf", triangle());
  folder_.add("parts/part.grf", "include \"inner.grf\"\n");
  folder_.add(
      "scene.grf",
      "include \"parts/part.grf\"\ntransform translation (2,0,0) begin include \"parts/part.grf\" end\n");
  const grf::Scene scene = read("scene.grf");
  const BakedIrradiance irradiance(
      scene, test::scene_of_text(triangle(irad(3)) + "transform translation (2,0,0) begin\n" +
                                 triangle(irad(5)) + "end\n" + View));
  const IrradiatedScene irradiated = irradiance.applied_to(scene, path());
  EXPECT_EQ(irradiances(irradiated.scene), (std::vector<float>{3, 5}));
  EXPECT_GT(irradiated.expanded_includes, 0U);
  EXPECT_EQ(irradiances(again(irradiated.scene, "scene.igrf")), (std::vector<float>{3, 5}));
  EXPECT_EQ(irradiances(read("scene.grf")), (std::vector<float>{-1, -1}));
}

TEST_F(BakedIrradianceTest, CopiesAMeshThatIsUsedAtSeveralPlaces) {
  const std::string uses = "begin use tile transform translation (0,1,0) begin use tile end end\n";
  const grf::Scene scene = test::scene_of_text("def tile = " + triangle() + uses);
  const BakedIrradiance irradiance(
      scene,
      test::scene_of_text("def tile = " + triangle(irad(3)) + "def other = " + triangle(irad(5)) +
                          "begin use tile transform translation (0,1,0) begin use other end end\n" + View));
  EXPECT_EQ(irradiances(irradiance.applied_to(scene, path()).scene), (std::vector<float>{3, 5}));
  grf::Scene edited = scene;
  auto& body = std::get<grf::DefinitionScope>(edited.contents.blocks[0].content).body.blocks;
  std::get<grf::Transform>(body[1].content).steps[0].value.y = 2;
  EXPECT_EQ(irradiances(irradiance.applied_to(edited, path()).scene), (std::vector<float>{3, -1}))
      << "an instance that was moved meanwhile";
}

}  // namespace
}  // namespace editor
