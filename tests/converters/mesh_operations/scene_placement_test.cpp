#include "converters/mesh_operations/scene_placement.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace convert {
namespace {

using Kind = grf::TransformStep::Kind;

TEST(TransformStepsText, AreThoseOfGrfInDegrees) {
  std::string problem;
  const auto steps = read_transform_steps("rotation 0 90 0 Translation (1, -2, .5e1) scale 1 2 -1", problem);
  ASSERT_TRUE(steps.has_value()) << problem;
  ASSERT_EQ(steps->size(), 3U);
  EXPECT_EQ((*steps)[0], (grf::TransformStep{Kind::Rotation, {0, std::numbers::pi_v<float> / 2, 0}}));
  EXPECT_EQ((*steps)[1], (grf::TransformStep{Kind::Translation, {1, -2, 5}}));
  EXPECT_EQ((*steps)[2], (grf::TransformStep{Kind::Scale, {1, 2, -1}}));
}

TEST(TransformStepsText, SaysWhatIsWrong) {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {" ", "expected scale, rotation or translation"},
           {"turn 1 2 3", "found 'turn', expected scale, rotation or translation"},
           {"scale 1 2", "expected three numbers after 'scale'"},
           {"scale 1 2 3x", "expected three numbers after 'scale'"},
           {"scale 1 2 1e99", "expected three numbers after 'scale'"},
           {"scale 1 2 nan", "expected three numbers after 'scale'"},
           {"scale 1 2 3 4", "found '4', expected scale, rotation or translation"},
           {"scale 1 0 1", "a scale of zero makes the scene degenerate"},
           {"scale 1 1e-50 1", "a scale of zero makes the scene degenerate"},
       }) {
    std::string problem;
    EXPECT_FALSE(read_transform_steps(text, problem).has_value());
    EXPECT_EQ(problem, message) << text;
  }
}

TEST(Place, PutsAllUnderTheSteps) {
  grf::Scene scene;
  scene.contents.blocks.emplace_back();
  scene.contents.end_comments = {"the end"};
  const grf::BlockList contents = scene.contents;
  place(scene, {}, {});
  EXPECT_EQ(scene.contents, contents);
  place(scene, {z_up_to_y_up()}, {});
  ASSERT_EQ(scene.contents.blocks.size(), 1U);
  const auto& transform = std::get<grf::Transform>(scene.contents.blocks[0].content);
  EXPECT_EQ(transform.body, contents);
  const grf::Matrix44d matrix = grf::matrix_of(transform.steps);
  EXPECT_LT((grf::Vec3d(0, 0, 1) * matrix - grf::Vec3d(0, 1, 0)).length(), 1e-7);
  EXPECT_LT((grf::Vec3d(1, 0, 0) * matrix - grf::Vec3d(1, 0, 0)).length(), 1e-7);
}

}  // namespace
}  // namespace convert
