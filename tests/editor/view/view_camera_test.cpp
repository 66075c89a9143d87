#include "editor/view/view_camera.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace editor {
namespace {

using grf::Vec2d;
using grf::Vec3d;

constexpr double Aspect = 1.5;

ViewCamera looking(const Vec3d& eye, const Vec3d& target) {
  transport::View view;
  view.eye = eye;
  view.target = target;
  view.field_of_view = 50;
  return ViewCamera(view);
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance = 1e-9) {
  EXPECT_LT((a - b).length(), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

void expect_near(const Vec2d& a, const Vec2d& b) { EXPECT_LT((a - b).length(), 1e-9); }

/// The position at which OpenGL draws a point.
Vec2d drawn_at(const ViewCamera& camera, const Vec3d& point) {
  const grf::Box3d box(Vec3d(-5), Vec3d(5));
  const Vec3d clip = point * (camera.world_to_camera() * camera.camera_to_clip(Aspect, box));
  EXPECT_LE(std::abs(clip.z), 1);
  return {clip.x, clip.y};
}

TEST(ViewCamera, KeepsEyeAndTargetOfAView) {
  for (const Vec3d& eye :
       {Vec3d(0, 0, 4), Vec3d(3, 2, -1), Vec3d(-3, -2, -1), Vec3d(0, 5, 0), Vec3d(0, -5, 0)}) {
    const ViewCamera camera = looking(eye, Vec3d(0));
    expect_near(camera.eye(), eye);
    expect_near(Vec3d(camera.view().eye), eye);
    EXPECT_EQ(camera.view().field_of_view, 50);
    EXPECT_GE(camera.up().y, -1e-12);
  }
}

TEST(ViewCamera, FromAboveTheViewsUpIsTheImages) {
  transport::View view;
  view.eye = Vec3d(0, 5, 0);
  view.up = grf::Vec3f(0, 0, -1);
  const ViewCamera camera(view);
  expect_near(camera.up(), Vec3d(0, 0, -1));
  expect_near(Vec3d(camera.view().up), Vec3d(0, 0, -1), 1e-6);
}

TEST(ViewCamera, RaysPassThroughWhatIsDrawnThere) {
  for (const bool is_orthographic : {false, true}) {
    ViewCamera camera = looking(Vec3d(2, 3, 7), Vec3d(0.5, 0, 0));
    camera.set_orthographic(is_orthographic);
    for (const Vec3d& point : {Vec3d(0), Vec3d(1, -1, 2), Vec3d(-2, 1, -3)}) {
      const auto place = camera.place_of(point, Aspect);
      ASSERT_TRUE(place);
      expect_near(*place, drawn_at(camera, point));
      const ViewRay ray = camera.ray(*place, Aspect);
      EXPECT_LT((point - ray.origin).cross(ray.direction).length(), 1e-9);
    }
  }
}

TEST(ViewCamera, NothingIsSeenBehindTheEye) {
  EXPECT_FALSE(looking(Vec3d(0, 0, 5), Vec3d(0)).place_of(Vec3d(0, 0, 6), Aspect));
}

TEST(ViewCamera, OrbitKeepsTargetAndDistanceAndStopsAtThePole) {
  ViewCamera camera = looking(Vec3d(0, 0, 5), Vec3d(1, 1, 0));
  const double distance = camera.distance();
  const Vec3d right = camera.right();
  const Vec3d before = camera.eye();
  camera.orbit(0.1, 0);
  EXPECT_GT((camera.eye() - before).dot(right), 0);
  camera.orbit(0, 0.1);
  EXPECT_GT(camera.eye().y, before.y);
  camera.orbit(0, 10);
  expect_near(camera.eye(), camera.target() + Vec3d(0, distance, 0));
  EXPECT_NEAR(camera.right().length(), 1, 1e-12);
}

TEST(ViewCamera, ZoomKeepsWhatIsUnderThePointer) {
  for (const bool is_orthographic : {false, true}) {
    ViewCamera camera = looking(Vec3d(2, 3, 7), Vec3d(0.5, 0, 0));
    camera.set_orthographic(is_orthographic);
    const Vec2d place(0.4, -0.3);
    const double half = camera.half_height_at(camera.target());
    const Vec3d point =
        camera.target() + camera.right() * (place.x * half * Aspect) + camera.up() * (place.y * half);
    const double distance = camera.distance();
    camera.zoom(0.5, place, Aspect);
    EXPECT_NEAR(camera.distance(), distance / 2, 1e-9);
    expect_near(*camera.place_of(point, Aspect), place);
  }
}

TEST(ViewCamera, ZoomComesNoNearerThanDigitsLast) {
  ViewCamera camera = looking(Vec3d(0, 0, 5), Vec3d(0));
  for (int i = 0; i < 1000; ++i) camera.zoom(0.5, Vec2d(0), Aspect);
  EXPECT_GE(camera.distance(), 0.99e-7);
}

TEST(ViewCamera, PanMovesByPartsOfTheImage) {
  ViewCamera camera = looking(Vec3d(0, 0, 5), Vec3d(0));
  const Vec3d point = camera.target();
  camera.pan(0, 0.25);
  expect_near(*camera.place_of(point, Aspect), Vec2d(0, -0.5));
}

TEST(ViewCamera, LookKeepsTheEye) {
  ViewCamera camera = looking(Vec3d(1, 2, 5), Vec3d(0));
  const Vec3d right = camera.right();
  camera.look(0.2, 0.1);
  expect_near(camera.eye(), Vec3d(1, 2, 5));
  EXPECT_GT(camera.forward().dot(right), 0.1);
}

TEST(ViewCamera, StandardViewsLookAlongAxes) {
  ViewCamera camera = looking(Vec3d(2, 3, 7), Vec3d(0));
  camera.look_from(StandardView::Front);
  expect_near(camera.forward(), Vec3d(0, 0, -1));
  camera.look_from_opposite();
  expect_near(camera.forward(), Vec3d(0, 0, 1));
  camera.look_from(StandardView::Right);
  expect_near(camera.forward(), Vec3d(-1, 0, 0));
  camera.look_from(StandardView::Top);
  expect_near(camera.forward(), Vec3d(0, -1, 0));
  expect_near(camera.up(), Vec3d(0, 0, -1));
  camera.look_from_opposite();
  expect_near(camera.forward(), Vec3d(0, 1, 0));
}

TEST(ViewCamera, FramesABoxWholly) {
  const grf::Box3d box(Vec3d(-3, 0, 1), Vec3d(1, 9, 2));
  for (const bool is_orthographic : {false, true}) {
    for (const double aspect : {0.5, 2.0}) {
      ViewCamera camera = looking(Vec3d(2, 3, 7), Vec3d(0));
      camera.set_orthographic(is_orthographic);
      camera.frame(box, aspect);
      double largest = 0;
      for (int i = 0; i < 8; ++i) {
        const Vec3d corner((i & 1 ? box.max : box.min).x, (i & 2 ? box.max : box.min).y,
                           (i & 4 ? box.max : box.min).z);
        const auto place = camera.place_of(corner, aspect);
        ASSERT_TRUE(place);
        largest = std::max({largest, std::abs(place->x), std::abs(place->y)});
      }
      EXPECT_LE(largest, 1);
      EXPECT_GE(largest, 0.4);
    }
  }
}

TEST(ViewCamera, ATargetLiesInTheMiddleAndTheViewTurnsNot) {
  ViewCamera camera = looking(Vec3d(2, 3, 7), Vec3d(0));
  const Vec3d forward = camera.forward();
  camera.set_target(Vec3d(1, 1, 1));
  expect_near(camera.forward(), forward);
  expect_near(*camera.place_of(Vec3d(1, 1, 1), Aspect), Vec2d(0));
}

}  // namespace
}  // namespace editor
