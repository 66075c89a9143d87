#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grf/reading.h"

namespace grf {
namespace {

const std::string Faces = " end vertexs begin faces end faces end mesh";

Mesh mesh_with(const std::string& vertices) {
  return mesh_of(scene_of("begin mesh begin vertexs " + vertices + Faces));
}

TEST(Irradiance, BelongsToTheVerticesThatHaveSome) {
  const Mesh mesh = mesh_with(
      "(0, 0, 0) irad (1, 2, 3) (1, 0, 0) begin list ray (0, 0, 2) irad (4, 5, 6) ray (0, 1, 0) irad (7, 8, "
      "9) end "
      "list (2, 0, 0) begin list end list (3, 0, 0)");
  EXPECT_FALSE(mesh.irradiance->has(0));
  EXPECT_EQ((*mesh.irradiance)[1], Irradiance(Colour(1, 2, 3)));
  const std::vector<DirectionalIrradiance> list = {{Vec3f(0, 0, 2), Colour(4, 5, 6)},
                                                   {Vec3f(0, 1, 0), Colour(7, 8, 9)}};
  EXPECT_EQ((*mesh.irradiance)[2], Irradiance(list)) << "directions stay as they were written";
  ASSERT_TRUE(mesh.irradiance->has(3)) << "an empty list is not nothing";
  EXPECT_EQ((*mesh.irradiance)[3], Irradiance(std::vector<DirectionalIrradiance>()));
}

TEST(Irradiance, MakesMeshesDiffer) {
  const auto one = mesh_with("irad (1, 2, 3) (0, 0, 0)");
  EXPECT_EQ(one, mesh_with("irad (1, 2, 3) (0, 0, 0)"));
  EXPECT_FALSE(one == mesh_with("irad (1, 2, 4) (0, 0, 0)"));
  EXPECT_FALSE(one == mesh_with("(0, 0, 0)"));
  EXPECT_FALSE(one == mesh_with("begin list ray (0, 0, 1) irad (1, 2, 3) end list (0, 0, 0)"));
  EXPECT_FALSE(mesh_with("begin list end list (0, 0, 0)") == mesh_with("(0, 0, 0)"));
}

TEST(HasIrradiance, LooksEverywhereInAFile) {
  const auto has = [](const std::string& text) { return has_irradiance(scene_of(text).contents); };
  const std::string lit = "begin vertexs irad (1, 1, 1) (0, 0, 0) end vertexs begin faces end faces ";
  EXPECT_FALSE(has(triangle()));
  EXPECT_TRUE(has("begin mesh " + lit + "end mesh"));
  EXPECT_TRUE(has("mesh light begin " + lit + "end"));
  EXPECT_TRUE(has("transform scale (2, 2, 2) begin begin mesh " + lit + "end mesh end"));
  EXPECT_TRUE(has("def m = begin mesh " + lit + "end mesh begin end"));
  EXPECT_TRUE(has("def c = rgb (1, 1, 1) begin begin mesh " + lit + "end mesh end"));
  EXPECT_FALSE(has("params begin dependent view (0, 0, 5) end"));
}

TEST(Params, KeepTheObservers) {
  const Scene scene =
      scene_of("params begin end params begin dependent view (1, 2, 3) dependent view (4, 5, 6) end");
  EXPECT_TRUE(block<Params>(scene.contents).views.empty());
  EXPECT_EQ(block<Params>(scene.contents, 1).views, (std::vector<Vec3f>{Vec3f(1, 2, 3), Vec3f(4, 5, 6)}));
}

}  // namespace
}  // namespace grf
