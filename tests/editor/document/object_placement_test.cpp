#include "editor/document/object_placement.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/scene_places.h"
#include "grf/write.h"
#include "grf/writer.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using StepKind = grf::TransformStep::Kind;
using grf::Vec3d;
using testing::HasSubstr;

/// A mesh of one triangle.
std::string triangle(const std::string& name, const std::string& vertices) {
  return "begin mesh \"" + name + "\" begin vertexs " + vertices +
         " end vertexs begin faces (0, 1, 2) end faces end mesh\n";
}

const std::string TwoMeshes = triangle("box", "(0.3, 0.1, 0) (1.3, 0.1, 0) (1.3, 0.6, 0.7)") +
                              "transform scale (2, 2, 2) begin\n" +
                              triangle("inner", "(0, 0, 0) (1, 0, 0) (0, 1, 0)") +
                              "light begin (0, 5, 0) (1, 0, 0) (0, 0, 1) end\nend\n";

TransformAction offset_by(const Vec3d& offset) {
  TransformAction action;
  action.value = offset;
  return action;
}

TransformAction turn(const Vec3d& axis, double degrees, const Vec3d& pivot) {
  TransformAction action;
  action.kind = StepKind::Rotation;
  action.value = axis;
  action.degrees = degrees;
  action.pivot = pivot;
  return action;
}

}  // namespace

class ObjectPlacement : public testing::Test {
 protected:
  void SetUp() override {
    scene_ = scene_of(TwoMeshes);
    box_ = objects().instances->at(0).path;
    inner_ = objects().instances->at(1).path;
    text_ = grf::to_text(scene_);
  }

  SceneObjects objects() const { return objects_of(scene_, "scene.grf"); }
  Vec3d first_corner(std::size_t instance) const {
    const SceneObjects now = objects();
    const MeshInstance& placed = now.instances->at(instance);
    return Vec3d(now.meshes[placed.mesh].mesh->geometry->positions[0]) * placed.to_world;
  }
  void apply(const std::vector<grf::ScenePath>& paths, const TransformAction& action) {
    auto result = transform_objects(scene_, paths, action, diagnostics_);
    ASSERT_TRUE(result) << diagnostics_.to_text();
    scene_ = std::move(result->scene);
    paths_ = std::move(result->paths);
  }
  Vec3d centre(const std::vector<grf::ScenePath>& paths) const {
    return pivot_of(scene_, objects(), paths, PivotPoint::Centre);
  }

  grf::Scene scene_;
  grf::ScenePath box_, inner_;
  std::vector<grf::ScenePath> paths_;  // of the last action
  std::string text_;
  grf::Diagnostics diagnostics_;
};

TEST_F(ObjectPlacement, TranslatingForthAndBackGivesTheSameBytes) {
  paths_ = {box_, inner_};
  for (int i = 0; i < 10; ++i) apply(paths_, offset_by({0.1, 0, -0.1}));
  EXPECT_THAT(grf::to_text(scene_), HasSubstr("translation (1, 0, -1)"));
  EXPECT_EQ(first_corner(0), Vec3d(0.3F, 0.1F, 0) + Vec3d(1, 0, -1));
  EXPECT_EQ(first_corner(1), Vec3d(1, 0, -1));
  for (int i = 0; i < 10; ++i) apply(paths_, offset_by({-0.1, 0, 0.1}));
  EXPECT_EQ(grf::to_text(scene_), text_);
  EXPECT_EQ(paths_, (std::vector{box_, inner_}));
}

TEST_F(ObjectPlacement, FourQuarterTurnsAboutTheCentreGiveTheSameBytes) {
  for (const Vec3d& axis : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}) {
    paths_ = {box_, inner_};
    for (int i = 0; i < 4; ++i) {
      apply(paths_, turn(axis, 90, centre(paths_)));
      if (i < 3) {
        EXPECT_NE(grf::to_text(scene_), text_);
      }
    }
    EXPECT_EQ(grf::to_text(scene_), text_);
  }
}

TEST_F(ObjectPlacement, TurnsAboutTheCentreOfTheObject) {
  apply({box_}, turn({0, 1, 0}, 90, centre({box_})));
  // A quarter turn about +y takes +z to +x and +x to -z; the centre is (0.8, 0.35, 0.35).
  EXPECT_LT((first_corner(0) - Vec3d(0.45, 0.1, 0.85)).length(), 1e-6);
  EXPECT_THAT(grf::to_text(scene_), HasSubstr("rotation (0, 1.5707964, 0)"));
}

TEST_F(ObjectPlacement, ActsInWorldSpaceInsideAScaledParent) {
  apply({inner_}, offset_by({1, 0, 0}));
  EXPECT_EQ(first_corner(1), Vec3d(1, 0, 0));
  EXPECT_THAT(grf::to_text(scene_), HasSubstr("translation (0.5, 0, 0)"));
  apply(paths_, turn({0, 0, 1}, 90, {0, 0, 0}));
  EXPECT_LT((first_corner(1) - Vec3d(0, 1, 0)).length(), 1e-6);
}

TEST_F(ObjectPlacement, ActsInWorldSpaceInsideAShearingParent) {
  scene_ = scene_of("transform scale (1, 3, 1) rotation (0, 0, 0.5) scale (1, -2, 1) begin\n" +
                    triangle("a", "(1, 1, 1) (2, 1, 1) (1, 2, 1)") +
                    triangle("b", "(1, 1, 1) (2, 1, 1) (1, 2, 1)") + "end");
  const Vec3d before = first_corner(1);
  const Vec3d pivot(0.25, -1, 2);
  apply({objects().instances->at(1).path}, turn({1, 2, 3}, 40, pivot));
  Imath::M44d rotation;
  rotation.setAxisAngle(Vec3d(1, 2, 3).normalized(), 40 * std::numbers::pi / 180);
  EXPECT_LT((first_corner(1) - (pivot + (before - pivot) * rotation)).length(), 2e-5);
}

TEST_F(ObjectPlacement, MovesAParentAndItsChildOnce) {
  const grf::ScenePath parent(inner_.begin(), inner_.end() - 1);
  apply({inner_, parent}, offset_by({1, 0, 0}));
  EXPECT_EQ(first_corner(1), Vec3d(1, 0, 0));
}

TEST_F(ObjectPlacement, ScalesAnAreaLightAboutItsCentre) {
  const grf::ScenePath light = objects().lights.at(0).path;
  TransformAction action;
  action.kind = StepKind::Scale;
  action.value = Vec3d(2);
  action.pivot = centre({light});
  EXPECT_EQ(action.pivot, Vec3d(1, 10, 1));
  apply({light}, action);
  const grf::Box3d bounds = object_bounds(objects(), paths_.at(0));
  EXPECT_EQ(bounds.min, Vec3d(-1, 10, -1));
  EXPECT_EQ(bounds.max, Vec3d(3, 10, 3));
}

TEST_F(ObjectPlacement, KeepsCommentsAndAuthoredIdentities) {
  scene_ = scene_of("// why\ntransform translation (1, 0, 0) begin\n" +
                    triangle("a", "(0, 0, 0) (1, 0, 0) (0, 1, 0)") + "end");
  apply({objects().instances->at(0).path}, offset_by({-1, 0, 0}));
  EXPECT_THAT(grf::to_text(scene_), HasSubstr("// why\ntransform translation (0, 0, 0)"));
}

TEST_F(ObjectPlacement, ReportsWhatCannotBeDone) {
  EXPECT_FALSE(transform_objects(scene_, {{7, 3}}, offset_by({1, 0, 0}), diagnostics_));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("only objects of the scene can be transformed"));
  TransformAction flat;
  flat.kind = StepKind::Scale;
  flat.value = Vec3d(1, 0, 1);
  EXPECT_FALSE(transform_objects(scene_, {box_}, flat, diagnostics_));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("must not be 0"));
}

TEST_F(ObjectPlacement, SetsPositionRotationAndScale) {
  ObjectTransform wanted;
  wanted.position = Vec3d(1, 2, 3);
  wanted.rotation = Vec3d(0, 45, 0);
  wanted.scale = Vec3d(1, 1, 2);
  auto result = set_object_transform(scene_, {box_}, wanted, diagnostics_);
  ASSERT_TRUE(result);
  const ObjectTransform shown = object_transform_at(result->scene, result->paths.at(0));
  EXPECT_EQ(shown.position, wanted.position);
  EXPECT_EQ(shown.rotation, wanted.rotation);
  EXPECT_EQ(shown.scale, wanted.scale);
  result = set_object_transform(result->scene, result->paths, ObjectTransform(), diagnostics_);
  EXPECT_EQ(grf::to_text(result->scene), text_);
}

TEST_F(ObjectPlacement, PivotIsTheCentreTheOriginTheActiveObjectOrTheWorld) {
  apply({box_}, offset_by({1, 0, 0}));
  const std::vector<grf::ScenePath> both = {inner_, paths_.at(0)};
  EXPECT_EQ(pivot_of(scene_, objects(), {paths_.at(0)}, PivotPoint::Centre), Vec3d(1.8, 0.35, 0.35));
  EXPECT_EQ(pivot_of(scene_, objects(), both, PivotPoint::Origin), Vec3d(0.5, 0, 0));
  EXPECT_EQ(pivot_of(scene_, objects(), both, PivotPoint::Active), Vec3d(1, 0, 0));
  EXPECT_EQ(pivot_of(scene_, objects(), both, PivotPoint::World), Vec3d(0));
}

// A cube of side 1 about (0.5, 0.5, 0.5) stands on a wall that faces +x: its upper side comes to face +x.
TEST(PlaceOnSurface, StandsUprightOrAlongANormal) {
  const grf::Scene scene = scene_of(
      "begin mesh begin vertexs (0,0,0) (1,0,0) (0,0,1) (1,0,1) (0,1,0) (1,1,0) (0,1,1) (1,1,1) end vertexs "
      "begin faces "
      "(0,1,3,2) (4,6,7,5) end faces end mesh\n");
  const SceneObjects objects = objects_of(scene, "scene.grf");
  const std::vector<grf::ScenePath> paths = {objects.instances->at(0).path};
  grf::Diagnostics diagnostics;
  const auto bounds_of = [](const TransformedObjects& placed) {
    return object_bounds(objects_of(placed.scene, "scene.grf"), placed.paths.front());
  };
  const auto upright = place_on_surface(scene, objects, paths, {4, 2, 6}, std::nullopt, diagnostics);
  ASSERT_TRUE(upright);
  EXPECT_EQ(bounds_of(*upright).min, Vec3d(3.5, 2, 5.5));
  EXPECT_EQ(bounds_of(*upright).max, Vec3d(4.5, 3, 6.5));
  const auto on_wall = place_on_surface(scene, objects, paths, {4, 2, 6}, Vec3d(1, 0, 0), diagnostics);
  ASSERT_TRUE(on_wall);
  EXPECT_LT((bounds_of(*on_wall).min - Vec3d(4, 1.5, 5.5)).length(), 1e-6);
  EXPECT_LT((bounds_of(*on_wall).max - Vec3d(5, 2.5, 6.5)).length(), 1e-6);
  const auto on_ceiling = place_on_surface(scene, objects, paths, {4, 2, 6}, Vec3d(0, -1, 0), diagnostics);
  ASSERT_TRUE(on_ceiling);
  EXPECT_LT((bounds_of(*on_ceiling).max - Vec3d(4.5, 2, 6.5)).length(), 1e-6);
}

}  // namespace editor
