#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/visit.h"
#include "tests/support/paths.h"

namespace grf {
namespace {

Scene scene_of_corpus(const std::string& name) {
  Diagnostics diagnostics;
  const auto scene = read(GRANADA_SOURCE_DIR "/tests/grf/corpus/valid/" + name + ".grf", diagnostics);
  EXPECT_EQ(diagnostics.to_text(), "");
  return scene ? *scene : Scene();
}

TEST(FirstExampleOfTheThesis, IsACubeOfOneBrdfAndColour) {
  std::size_t meshes = 0;
  SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block&) {
    ++meshes;
    EXPECT_EQ(mesh.geometry->positions.size(), 8U);
    ASSERT_EQ(mesh.face_count(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(mesh.face(i).size(), 4U);
      const ResolvedSurface surface = resolve(mesh.surface(i), placement.scope);
      EXPECT_EQ(surface.colour, Colour(0.3F, 0.8F, 1));
      ASSERT_NE(surface.brdf, nullptr);
      EXPECT_EQ(surface.brdf->keyword, "ward");
      EXPECT_EQ(surface.brdf->arguments.size(), 4U);
    }
  };
  visit(scene_of_corpus("thesis_first_example"), visitor);
  EXPECT_EQ(meshes, 1U);
}

TEST(SecondExampleOfTheThesis, PlacesItsFilesAndGivesThemItsNames) {
  std::vector<std::string> brdfs;
  std::vector<Vec3f> lights;
  SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block&) {
    const ResolvedSurface surface = resolve(mesh.surface(0), placement.scope);
    brdfs.push_back(surface.brdf == nullptr ? "none" : surface.brdf->keyword);
  };
  visitor.light = [&](const AreaLight& light, const Placement& placement, const Block&) {
    lights.emplace_back(Vec3d(light.corner) * placement.to_world);
  };
  visit(scene_of_corpus("thesis_second_example"), visitor);
  EXPECT_THAT(brdfs, testing::ElementsAre("none", "lafortune", "ward"));
  ASSERT_EQ(lights.size(), 2U);
  EXPECT_EQ(lights[0], Vec3f(0, 2, 0));
  EXPECT_LT((lights[1] - Vec3f(0, 0.5F, 2)).length(), 1e-5F) << "rotated, then moved";
}

}  // namespace
}  // namespace grf
