// Cameras with names, and animations of the camera, against positions computed by hand.
#include "renderer/job/camera_path.h"

#include <gtest/gtest.h>

namespace {

using grf::Vec3d;
using grf::Vec3f;
using options::NamedCamera;
using options::RenderOptions;
using transport::View;

void expect_near(const Vec3d& found, const Vec3d& expected) {
  EXPECT_NEAR((found - expected).length(), 0, 1e-9) << found << " instead of " << expected;
}

NamedCamera camera_at(const std::string& name, const Vec3f& eye, float field_of_view = 40) {
  return {name, eye, Vec3f(0), Vec3f(0, 1, 0), field_of_view, 0, 0};
}

View frame_of(RenderOptions options, int frame, const View& view = {}) {
  options.frame = frame;
  return job::view_of_frame(options, view);
}

TEST(CameraPath, TurntablesTurnCounterClockwiseSeenFromAbove) {
  RenderOptions options;
  options.frames = 4;
  View view;
  view.eye = Vec3d(1, 2, 7);
  view.target = Vec3d(1, 0, 3);
  expect_near(frame_of(options, 1, view).eye, {1, 2, 7});
  expect_near(frame_of(options, 2, view).eye, {5, 2, 3});
  expect_near(frame_of(options, 3, view).eye, {1, 2, -1});
  expect_near(frame_of(options, 4, view).eye, {-3, 2, 3});
  view.up = Vec3f(0, 0, 3);  // about z: x goes to y
  view.eye = Vec3d(2, 0, 5);
  view.target = Vec3d(0);
  expect_near(frame_of(options, 2, view).eye, {0, 2, 5});
  options.frames = 1;
  expect_near(frame_of(options, 0, view).eye, view.eye);
}

TEST(CameraPath, GoesStraightThroughItsCameras) {
  RenderOptions options;
  options.camera_path = "linear";
  options.frames = 5;
  options.cameras = {camera_at("a", {0, 0, 8}, 40), camera_at("b", {4, 0, 8}, 20),
                     camera_at("c", {4, 6, 8}, 30)};
  expect_near(frame_of(options, 1).eye, {0, 0, 8});
  expect_near(frame_of(options, 2).eye, {2, 0, 8});
  EXPECT_FLOAT_EQ(frame_of(options, 2).field_of_view, 30);
  expect_near(frame_of(options, 3).eye, {4, 0, 8});
  expect_near(frame_of(options, 4).eye, {4, 3, 8});
  expect_near(frame_of(options, 5).eye, {4, 6, 8});
  EXPECT_FLOAT_EQ(frame_of(options, 5).field_of_view, 30);
  EXPECT_FLOAT_EQ(frame_of(options, 1).focus_distance, 8);  // to the target
}

// A uniform Catmull-Rom spline: through 0, 1 and 0, with -1 in front and -1 behind, it is at 0.625 a quarter
// of the way.
TEST(CameraPath, GoesSmoothlyThroughItsCameras) {
  RenderOptions options;
  options.camera_path = "smooth";
  options.frames = 5;
  options.cameras = {camera_at("a", {0, 0, 8}), camera_at("b", {1, 0, 8}), camera_at("c", {0, 0, 8})};
  expect_near(frame_of(options, 1).eye, {0, 0, 8});
  expect_near(frame_of(options, 2).eye, {0.625, 0, 8});
  expect_near(frame_of(options, 3).eye, {1, 0, 8});
  expect_near(frame_of(options, 4).eye, {0.625, 0, 8});
  expect_near(frame_of(options, 5).eye, {0, 0, 8});
  // Equal steps along a line stay equal steps.
  options.cameras = {camera_at("a", {0, 0, 8}), camera_at("b", {2, 1, 8}), camera_at("c", {4, 2, 8})};
  for (int frame = 1; frame <= 5; ++frame) {
    expect_near(frame_of(options, frame).eye, {double(frame - 1), 0.5 * (frame - 1), 8});
  }
}

TEST(CameraPath, FindsCamerasByTheirNames) {
  RenderOptions options;
  options.cameras = {camera_at("front", {0, 0, 8}), camera_at("side", {8, 0, 0}, 25)};
  EXPECT_FALSE(job::named_view(options));
  options.camera = "side";
  ASSERT_TRUE(job::named_view(options));
  expect_near(job::named_view(options)->eye, {8, 0, 0});
  EXPECT_EQ(job::named_view(options)->field_of_view, 25);
}

TEST(CameraPath, NumbersItsFiles) {
  EXPECT_EQ(job::file_of_frame("renders/my.scene.exr", 7), "renders/my.scene_0007.exr");
  EXPECT_EQ(job::file_of_frame("image", 12345), "image_12345");
  RenderOptions options;
  EXPECT_EQ(job::frames_of(options), std::vector<int>());
  options.frames = 3;
  EXPECT_EQ(job::frames_of(options), (std::vector<int>{1, 2, 3}));
  options.frame = 2;
  EXPECT_EQ(job::frames_of(options), std::vector<int>{2});
}

std::string problem_of(const RenderOptions& options) {
  grf::Diagnostics diagnostics;
  const bool is_right = job::check_cameras(options, diagnostics);
  EXPECT_EQ(is_right, diagnostics.entries().empty());
  return diagnostics.entries().empty() ? "" : diagnostics.entries().front().message;
}

TEST(CameraPath, SaysWhatIsMissing) {
  RenderOptions options;
  EXPECT_EQ(problem_of(options), "");
  options.camera = "side";
  EXPECT_EQ(problem_of(options), "there is no camera 'side': BPT_Cameras names none");
  options.cameras = {camera_at("front", {0, 0, 8}), camera_at("top", {0, 8, 0})};
  EXPECT_EQ(problem_of(options), "there is no camera 'side', expected one of front, top");
  options.camera = "top";
  options.frames = 5;
  EXPECT_EQ(problem_of(options), "");
  options.frame = 6;
  EXPECT_EQ(problem_of(options), "there is no frame 6: BPT_Frames is 5");
  options.frame = 5;
  options.camera_path = "linear";
  EXPECT_EQ(problem_of(options), "");
  options.cameras.pop_back();
  options.camera = "front";
  EXPECT_EQ(problem_of(options), "a camera path needs two cameras or more, and BPT_Cameras names one");
}

}  // namespace
