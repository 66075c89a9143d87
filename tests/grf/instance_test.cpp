#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/grf/reading.h"

namespace grf {
namespace {

struct Placed {
  std::string definition;  ///< empty for a mesh that stands in the scene
  Vec3d place;
  std::string brdf;
  Colour colour;
};

std::vector<Placed> placed_in(const std::string& text) {
  std::vector<Placed> all;
  SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block&) {
    const ResolvedSurface surface = resolve(mesh.surface(0), placement.scope);
    all.push_back({placement.instance_of == nullptr ? "" : placement.instance_of->name,
                   Vec3d(mesh.geometry->positions[1]) * placement.to_world,
                   surface.brdf == nullptr ? "" : surface.brdf->keyword, surface.colour});
  };
  visit(scene_of(text), visitor);
  return all;
}

TEST(DefinedMesh, StandsOnlyWhereItIsUsed) {
  EXPECT_EQ(placed_in("def m = " + triangle() + " begin end").size(), 0U);
  const auto all = placed_in("def m = " + triangle() + " begin use m " + triangle() + "use m end");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].definition, "m");
  EXPECT_EQ(all[1].definition, "");
  EXPECT_EQ(all[2].definition, "m");
}

TEST(Use, PlacesAMeshUnderTheTransformsInForceThere) {
  const auto all =
      placed_in("transform scale (9, 9, 9) begin def m = " + triangle() +
                " begin use m transform translation (0, 1, 0) scale (2, 2, 2) begin use m end end end");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].place, Vec3d(9, 0, 0));
  EXPECT_EQ(all[1].place, Vec3d(18, 18, 0));
}

TEST(Use, CostsNoSecondMesh) {
  std::vector<const Mesh*> meshes;
  SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement&, const Block&) { meshes.push_back(&mesh); };
  visit(scene_of("def m = " + triangle() + " begin use m use m end"), visitor);
  ASSERT_EQ(meshes.size(), 2U);
  EXPECT_EQ(meshes[0], meshes[1]);
}

TEST(DefinedMesh, HasTheNamesOfWhereItIsDefined) {
  const std::string outer = "def a = brdf ward c = rgb (1, 0, 0) m = " + triangle("brdf a rgb c");
  const auto hidden = placed_in(outer + " begin def a = brdf phong c = rgb (0, 0, 1) begin use m end end");
  ASSERT_EQ(hidden.size(), 1U);
  EXPECT_EQ(hidden[0].brdf, "ward");
  EXPECT_EQ(hidden[0].colour, Colour(1, 0, 0));
  const auto other_kind = placed_in(outer + " begin def a = rgb (0, 0, 0) c = brdf ward begin use m end end");
  EXPECT_EQ(other_kind.at(0).brdf, "ward");
  EXPECT_EQ(other_kind.at(0).colour, Colour(1, 0, 0));
}

TEST(DefinedMesh, HasNoNamesOfAfterIt) {
  const auto all = placed_in("def a = brdf ward begin def m = " + triangle("brdf a") +
                             " a = brdf phong begin use m " + triangle("brdf a") + "end end");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].brdf, "ward");
  EXPECT_EQ(all[1].brdf, "phong");
}

TEST(DefinedMesh, TakesABareWordForAModelWhereTheNameComesLater) {
  const auto all = placed_in("def m = " + triangle("brdf ward") + " ward = brdf phong begin use m end");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].brdf, "ward");
}

TEST(Use, MeansTheInnermostMeshOfTheName) {
  const std::string far =
      "begin mesh begin vertexs (0, 0, 0) (7, 0, 0) (0, 1, 0) end begin faces (0, 1, 2) end end";
  const auto all =
      placed_in("def m = " + triangle() + " begin use m def m = " + far + " begin use m end use m end");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].place.x, 1);
  EXPECT_EQ(all[1].place.x, 7);
  EXPECT_EQ(all[2].place.x, 1);
}

TEST(DefinedMesh, MayHaveTheNameOfAKeyword) {
  const auto all =
      placed_in("def light = " + triangle() + " mesh = " + triangle() + " ward = " + triangle("brdf ward") +
                " begin use light use mesh use ward light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end end");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].definition, "light");
  EXPECT_EQ(all[2].brdf, "ward");
}

}  // namespace
}  // namespace grf
