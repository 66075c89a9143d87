#include "editor/document/apply_transforms.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/scene_places.h"
#include "grf/write.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using grf::Vec3f;
using testing::HasSubstr;
using testing::Not;

const std::string Corner =
    "begin mesh \"corner\" begin vertexs normal (0, 0, 1) (0, 0, 0) normal (0, 0, 1) (1, 0, 0) "
    "(0, 1, 0) end vertexs begin faces (0, 1, 2) end faces end mesh\n";

/// Applies the transform of the first block of a scene.
std::optional<TransformedObjects> applied(const std::string& text, std::string* problem = nullptr) {
  grf::Diagnostics diagnostics;
  const grf::Scene scene = scene_of(text);
  const SceneObjects objects = objects_of(scene, "scene.grf");
  grf::ScenePath path = objects.instances->at(0).path;
  const auto parent_block = [&] { return block_at(scene, grf::ScenePathView(path).first(path.size() - 1)); };
  while (path.size() > 1 && std::holds_alternative<grf::Transform>(parent_block()->content)) path.pop_back();
  auto result = apply_transforms(scene, {path}, diagnostics);
  if (problem != nullptr && !diagnostics.entries().empty()) *problem = diagnostics.entries().front().message;
  return result;
}

// By hand: scaled by (1, 2, 3), turned by 90 degrees about z (x to y, y to -x), moved by (5, 0, 0).
TEST(ApplyTransforms, MovesVerticesAndNormals) {
  const auto result =
      applied("transform scale (1, 2, 3) rotation (0, 0, 1.5707963267948966) translation (5, 0, 0) begin\n" +
              Corner + "end\n");
  ASSERT_TRUE(result);
  const SceneObjects objects = objects_of(result->scene, "scene.grf");
  ASSERT_EQ(objects.instances->size(), 1U);
  EXPECT_EQ(objects.instances->at(0).to_world, grf::Matrix44d());
  EXPECT_EQ(result->paths.front(), objects.instances->at(0).path);
  const grf::Geometry& geometry = *objects.meshes[0].mesh->geometry;
  EXPECT_LT((geometry.positions[0] - Vec3f(5, 0, 0)).length(), 1e-6);
  EXPECT_LT((geometry.positions[1] - Vec3f(5, 1, 0)).length(), 1e-6);
  EXPECT_LT((geometry.positions[2] - Vec3f(3, 0, 0)).length(), 1e-6);
  EXPECT_EQ(geometry.normals[0], Vec3f(0, 0, 1));
  EXPECT_FALSE(geometry.normals.has(2));
  EXPECT_THAT(grf::to_text(result->scene), Not(HasSubstr("transform")));
}

// A normal is transformed by the inverse transpose: on the plane x + y = 1 scaled by 2 along x, it is (1, 2)
// / sqrt 5.
TEST(ApplyTransforms, KeepsNormalsAcrossSurfaces) {
  const auto result = applied(
      "transform scale (2, 1, 1) begin begin mesh begin vertexs normal (1, 1, 0) (1, 0, 0) "
      "normal (1, 1, 0) (0, 1, 0) (0, 1, 1) end vertexs begin faces (0, 1, 2) end faces end mesh end\n");
  ASSERT_TRUE(result);
  const SceneObjects objects = objects_of(result->scene, "scene.grf");
  const Vec3f normal = objects.meshes[0].mesh->geometry->normals[0];
  EXPECT_LT((normal - Vec3f(1, 2, 0) / std::sqrt(5.0F)).length(), 1e-6);
}

TEST(ApplyTransforms, KeepsTheFrontsOfWhatIsMirrored) {
  const auto result = applied("transform scale (1, 1, -1) begin\n" + Corner +
                              "light begin (0, 0, 2) (1, 0, 0) (0, 1, 0) end\nend\n");
  ASSERT_TRUE(result);
  const SceneObjects objects = objects_of(result->scene, "scene.grf");
  const grf::Mesh& mesh = *objects.meshes[0].mesh;
  // It faced +z, and faces -z behind the mirror.
  EXPECT_LT(grf::doubled_area_vector(*mesh.geometry, 0, {}).z, 0);
  EXPECT_EQ(mesh.geometry->normals[0], Vec3f(0, 0, -1));
  EXPECT_EQ(mesh.face(0)[0], 0U);
  const grf::AreaLight& light = objects.lights.at(0).light;
  EXPECT_EQ(light.corner, Vec3f(0, 0, -2));
  EXPECT_LT(light.edge1.cross(light.edge2).z, 0);
}

TEST(ApplyTransforms, LeaveWhatIsSharedWithAMessage) {
  std::string problem;
  EXPECT_FALSE(applied(
      "def stone = " + Corner + " begin transform translation (1, 0, 0) begin use stone end end", &problem));
  EXPECT_EQ(problem, "the transform cannot be applied: it moves an instance");
}

TEST(ApplyTransforms, LeaveObjectsWithoutATransform) {
  const auto result = applied(Corner);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->scene, scene_of(Corner));
}

}  // namespace
}  // namespace editor
