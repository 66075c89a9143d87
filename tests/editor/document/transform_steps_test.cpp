#include "editor/document/transform_steps.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace editor {
namespace {

using StepKind = grf::TransformStep::Kind;

std::string text_of_steps(const TransformSteps& steps) {
  std::string text;
  for (const grf::TransformStep& step : steps) {
    text += fmt::format("{}({},{},{}) ", "srt"[static_cast<int>(step.kind)], step.value.x, step.value.y,
                        step.value.z);
  }
  return text;
}

TransformSteps authored_steps() {
  return {{StepKind::Scale, {2, 2, 2}},
          {StepKind::Rotation, {0, 0.523599F, 0}},
          {StepKind::Translation, {0.3F, 1.25F, -2}}};
}

void expect_matrix(const grf::Matrix44d& matrix, const grf::Matrix44d& expected, double tolerance = 1e-5) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      EXPECT_NEAR(matrix[row][column], expected[row][column], tolerance) << row << ' ' << column;
    }
  }
}

/// The action of a rotation by Imath's own axis and angle.
grf::Matrix44d turned_about(const grf::Vec3d& axis, double degrees, const grf::Vec3d& pivot) {
  grf::Matrix44d back;
  grf::Matrix44d turn;
  grf::Matrix44d forth;
  back.setTranslation(-pivot);
  turn.setAxisAngle(axis.normalized(), degrees * std::numbers::pi / 180);
  forth.setTranslation(pivot);
  return back * turn * forth;
}

TEST(TransformSteps, TranslateByATenthTenTimesAndBack) {
  for (const TransformSteps& start :
       {TransformSteps(), authored_steps(),
        TransformSteps{{StepKind::Translation, {0.12345679F, 1234.5678F, -1e-7F}}}}) {
    TransformSteps steps = start;
    for (int i = 0; i < 10; ++i) translate(steps, {0.1, -0.1, 0.1});
    const grf::Vec3d moved = grf::matrix_of(steps).translation() - grf::matrix_of(start).translation();
    EXPECT_LT((moved - grf::Vec3d(1, -1, 1)).length(), 2e-4);  // of `float` at 1234
    EXPECT_LE(steps.size(), start.size() + 1);
    for (int i = 0; i < 10; ++i) translate(steps, {-0.1, 0.1, -0.1});
    EXPECT_EQ(text_of_steps(steps), text_of_steps(start));
  }
}

TEST(TransformSteps, TranslationsAreWrittenAsDecimals) {
  TransformSteps steps;
  for (int i = 0; i < 3; ++i) translate(steps, {0.1, 0, 0});
  EXPECT_EQ(text_of_steps(steps), "t(0.3,0,0) ");
}

TEST(TransformSteps, FourQuarterTurnsChangeNothing) {
  const std::vector<TransformSteps> starts = {{},
                                              authored_steps(),
                                              {{StepKind::Rotation, {3, -2, 0.1F}}},
                                              {{StepKind::Translation, {1, 2, 3}},
                                               {StepKind::Rotation, {0.1F, 0.2F, 0.3F}},
                                               {StepKind::Scale, {1, 2, 3}}},
                                              {{StepKind::Rotation, {0, 1.5707964F, 0.5F}}}};
  for (const TransformSteps& start : starts) {
    for (const grf::Vec3d& axis : {grf::Vec3d(1, 0, 0), grf::Vec3d(0, 1, 0), grf::Vec3d(0, 0, 1)}) {
      for (const grf::Vec3d& pivot : {grf::Vec3d(0), grf::Vec3d(0.3, -1.25, 17.5)}) {
        TransformSteps steps = start;
        for (int i = 0; i < 4; ++i) rotate(steps, axis, 90, pivot);
        EXPECT_EQ(text_of_steps(steps), text_of_steps(start));
      }
    }
  }
}

TEST(TransformSteps, TurnsOfThirtyDegreesCloseACircle) {
  TransformSteps steps = authored_steps();
  for (int i = 0; i < 12; ++i) rotate(steps, {0, 0, 1}, 30, {0.5, 0.25, 0});
  EXPECT_EQ(text_of_steps(steps), text_of_steps(authored_steps()));
}

TEST(TransformSteps, RotatesAsTheMatrixOfTheAxisAndAngle) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int i = 0; i < 200; ++i) {
    const auto vector = [&] { return grf::Vec3d(number(random), number(random), number(random)); };
    TransformSteps steps;
    grf::Matrix44d expected;
    for (int edit = 0; edit < 6; ++edit) {
      const grf::Vec3d axis = vector();
      const grf::Vec3d pivot = vector();
      const double degrees = 100 * number(random);
      rotate(steps, axis, degrees, pivot);
      expected *= turned_about(axis, degrees, pivot);
    }
    expect_matrix(grf::matrix_of(steps), expected, 2e-5);
    EXPECT_LE(steps.size(), 4);
  }
}

TEST(TransformSteps, ScalesAlongAnyAxesAboutAPivot) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0.5, 2);
  for (int i = 0; i < 100; ++i) {
    TransformSteps steps = authored_steps();
    grf::Matrix44d expected = grf::matrix_of(steps);
    for (int edit = 0; edit < 4; ++edit) {
      const grf::Vec3d factors(number(random), -number(random), number(random));
      const grf::Vec3d pivot(number(random), number(random), number(random));
      grf::Matrix44d axes;
      if (edit % 2 == 0) axes.setAxisAngle(grf::Vec3d(1, 2, 3).normalized(), number(random));
      scale(steps, factors, axes, pivot);
      grf::Matrix44d back;
      grf::Matrix44d grown;
      grf::Matrix44d forth;
      back.setTranslation(-pivot);
      grown.setScale(factors);
      forth.setTranslation(pivot);
      expected *= back * axes.transposed() * grown * axes * forth;
    }
    expect_matrix(grf::matrix_of(steps), expected, 1e-4);
    EXPECT_LE(steps.size(), 6);
  }
}

TEST(TransformSteps, ScalesBackToTheSameNumbers) {
  TransformSteps steps = authored_steps();
  grf::Matrix44d axes;
  for (int i = 0; i < 5; ++i) scale(steps, grf::Vec3d(1.1), axes, {1, 0, 2});
  for (int i = 0; i < 5; ++i) scale(steps, grf::Vec3d(1 / 1.1), axes, {1, 0, 2});
  EXPECT_EQ(text_of_steps(steps), text_of_steps(authored_steps()));
}

TEST(TransformSteps, ScalesARotatedObjectAlongItsOwnAxesWithoutShear) {
  TransformSteps steps = authored_steps();
  grf::Matrix44d own;
  own.setAxisAngle(grf::Vec3d(0, 1, 0), double{0.523599F});
  scale(steps, {3, 1, 1}, own, {0.3, 1.25, -2});
  EXPECT_EQ(text_of_steps(steps), "s(6,2,2) r(0,0.523599,0) t(0.3,1.25,-2) ");
}

TEST(TransformSteps, ShowsPositionRotationAndScale) {
  const ObjectTransform shown = object_transform_of({{StepKind::Scale, {1, 2, 3}},
                                                     {StepKind::Rotation, {0, 0.5235988F, 0}},
                                                     {StepKind::Translation, {0.1F, 0, 0}}});
  EXPECT_EQ(shown.position, grf::Vec3d(0.1, 0, 0));
  EXPECT_EQ(shown.rotation, grf::Vec3d(0, 30, 0));
  EXPECT_EQ(shown.scale, grf::Vec3d(1, 2, 3));
  EXPECT_FALSE(shown.has_shear);
}

TEST(TransformSteps, DecomposesStepsInAnyOrder) {
  const TransformSteps steps = {{StepKind::Translation, {1, 2, 3}},
                                {StepKind::Rotation, {0.1F, 0.2F, 0.3F}},
                                {StepKind::Scale, {-2, -2, -2}}};
  const ObjectTransform shown = object_transform_of(steps);
  EXPECT_FALSE(shown.has_shear);
  expect_matrix(grf::matrix_of(steps_of(shown)), grf::matrix_of(steps));
  EXPECT_TRUE(
      object_transform_of({{StepKind::Rotation, {0, 0, 0.5F}}, {StepKind::Scale, {1, 2, 1}}}).has_shear);
}

TEST(TransformSteps, FindsShortNumbers) {
  EXPECT_EQ(shortest_near(0.30000001, 1e-7), 0.3);
  EXPECT_EQ(shortest_near(1e-9, 1e-7), 0);
  EXPECT_EQ(shortest_near(0.1234567891, 1e-9), 0.1234567891);
}

}  // namespace
}  // namespace editor
