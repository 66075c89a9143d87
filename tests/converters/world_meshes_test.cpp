#include "converters/world_meshes.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/reading.h"

namespace convert {
namespace {

using grf::Colour;
using grf::Vec3f;
using testing::ElementsAre;

const std::string Triangle =
    "begin mesh \"t\" begin vertexs normal (0,0,2) (0.1,0,0) normal (0,0,2) (1,0,0) (0,1,0) end vertexs\n"
    "begin faces (0,1,2) end faces end mesh\n";

/// Twice the area of a face, along its normal, as it stands in the world.
grf::Vec3d area_of(const WorldMesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  const grf::Vec3d origin(mesh.position(corners[0]));
  grf::Vec3d sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (grf::Vec3d(mesh.position(corners[i])) - origin)
               .cross(grf::Vec3d(mesh.position(corners[i + 1])) - origin);
  }
  return sum;
}

TEST(WorldMeshes, WhatIsNotMovedKeepsItsBits) {
  const grf::Scene scene = scene_of_grf(Triangle);
  const WorldMeshes world(scene);
  ASSERT_EQ(world.meshes().size(), 1U);
  const WorldMesh& mesh = world.meshes().front();
  EXPECT_EQ(mesh.name(), "t");
  EXPECT_EQ(mesh.position(0), Vec3f(0.1F, 0, 0));
  EXPECT_EQ(mesh.normal(0), Vec3f(0, 0, 2)) << "as written, not of unit length";
}

TEST(WorldMeshes, TransformsActInDouble) {
  const grf::Scene scene = scene_of_grf(
      "transform translation (1e8,0,0) begin transform translation (-1e8,0,0) begin " + Triangle + "end end");
  EXPECT_EQ(WorldMeshes(scene).meshes().front().position(0), Vec3f(0.1F, 0, 0))
      << "floats would have lost it";
}

TEST(WorldMeshes, NormalsFollowTheInverseTranspose) {
  const grf::Scene scene =
      scene_of_grf("transform rotation (0.3,0,0) scale (1,4,0.5) begin " + Triangle + "end");
  const WorldMeshes world(scene);
  const WorldMesh& mesh = world.meshes().front();
  const grf::Vec3d normal(mesh.normal(0));
  EXPECT_NEAR(normal.length(), 1, 1e-6);
  EXPECT_NEAR(normal.dot(area_of(mesh, 0).normalized()), 1, 1e-6) << "they stood upright, and still do";
}

TEST(WorldMeshes, MirrorsKeepFronts) {
  const grf::Scene scene =
      scene_of_grf("transform scale (1,1,-1) rotation (0,1,0) begin " + Triangle + "end");
  const WorldMeshes world(scene);
  const WorldMesh& mesh = world.meshes().front();
  EXPECT_THAT(mesh.face(0), ElementsAre(0, 2, 1));
  EXPECT_GT(grf::Vec3d(mesh.normal(0)).dot(area_of(mesh, 0)), 0);
}

TEST(WorldMeshes, InstancesStandWhereTheyAreUsed) {
  const grf::Scene scene = scene_of_grf(
      "def red = rgb (1,0,0) m = begin mesh rgb red begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs\n"
      "begin faces (0,1,2) end faces end mesh begin use m transform translation (5,0,0) begin use m end end");
  const WorldMeshes world(scene);
  ASSERT_EQ(world.meshes().size(), 2U);
  EXPECT_EQ(world.meshes()[0].position(1), Vec3f(1, 0, 0));
  EXPECT_EQ(world.meshes()[1].position(1), Vec3f(6, 0, 0));
  EXPECT_EQ(world.meshes()[1].name(), "m");
  EXPECT_EQ(world.meshes()[1].surface(0).colour, Colour(1, 0, 0));
}

TEST(WorldMeshes, MaterialsAreTheNamesOfBrdfs) {
  const std::string mesh =
      "begin mesh brdf gold begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs\n"
      "begin faces (0,1,2) brdf phong n=3 (0,1,2) brdf silver$20$2 (0,1,2) end faces end mesh\n";
  const grf::Scene scene = scene_of_grf(
      "def silver$20$2 = brdf phong n=2 unused = brdf phong n=9 begin def gold = brdf phong n=1 begin " +
      mesh + "end def gold = brdf phong n=4 begin " + mesh + "end end");
  const WorldMeshes world(scene);
  EXPECT_THAT(world.materials(), ElementsAre("gold", "silver 2", "gold_2"));
  EXPECT_EQ(world.meshes()[0].surface(0).material, 0U);
  EXPECT_EQ(world.meshes()[0].surface(1).material, std::nullopt);
  EXPECT_EQ(world.meshes()[0].surface(1).brdf->keyword, "phong");
  EXPECT_EQ(world.meshes()[0].surface(2).material, 1U);
  EXPECT_EQ(world.meshes()[1].surface(0).material, 2U) << "another definition of that name";
}

TEST(WorldMeshes, LightsAreMeshesThatOnlyEmit) {
  const grf::Scene scene = scene_of_grf(
      "light begin rgb (2,3,4) (0,0,0) (1,0,0) (0,1,0) end\n"
      "mesh light begin begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs begin faces (0,1,2) end faces "
      "end " +
      Triangle);
  const WorldMeshes world(scene);
  ASSERT_EQ(world.meshes().size(), 3U);
  EXPECT_TRUE(world.meshes()[0].is_light());
  EXPECT_EQ(world.meshes()[0].surface(0).emission, Colour(2, 3, 4));
  EXPECT_GT(area_of(world.meshes()[0], 0).z, 0);
  EXPECT_TRUE(world.meshes()[1].is_light());
  EXPECT_EQ(world.meshes()[1].surface(0).emission, Colour(1));
  EXPECT_FALSE(world.meshes()[2].is_light());
}

TEST(WorldMeshes, CountWhatTheyHave) {
  const grf::Scene scene = scene_of_grf(
      "light begin (0,0,0) (1,0,0) (0,1,0) end\n"
      "begin mesh \"name\" begin vertexs rgb (1,0,0) uv (0,1) (0,0,0) irad (1,1,1) (1,0,0) (0,1,0) (9,9,9) "
      "end vertexs\n"
      "begin faces brdf phong n=3 (0,1,2) (0,2,1,3) pdf uniform texture \"a.png\" light rgb (1,1,1) (1,2,3) "
      "end faces "
      "end mesh");
  const WorldMeshes world(scene);
  const auto count = [&world](Loss loss) {
    Losses losses;
    world.count({loss}, losses);
    return losses.count(loss);
  };
  EXPECT_EQ(count(Loss::AreaLight), 1U);
  EXPECT_EQ(count(Loss::MeshName), 1U);
  EXPECT_EQ(count(Loss::Brdf), 3U);
  EXPECT_EQ(count(Loss::SamplingScheme), 1U);
  EXPECT_EQ(count(Loss::Texture), 1U);
  EXPECT_EQ(count(Loss::Emission), 1U);
  EXPECT_EQ(count(Loss::VertexColour), 1U);
  EXPECT_EQ(count(Loss::Irradiance), 1U);
  EXPECT_EQ(count(Loss::TextureCoordinates), 2U);
  EXPECT_EQ(count(Loss::Polygon), 1U);
  EXPECT_EQ(count(Loss::LooseVertex), 0U);
  EXPECT_EQ(count(Loss::FaceColour), 0U);
}

}  // namespace
}  // namespace convert
