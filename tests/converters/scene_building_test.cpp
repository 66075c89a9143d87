#include "converters/scene_building.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace convert {
namespace {

using grf::Matrix44d;
using Kind = grf::TransformStep::Kind;

void expect_is_matrix(const std::vector<grf::TransformStep>& steps, const Matrix44d& matrix) {
  const Matrix44d made = grf::matrix_of(steps);
  double largest = 1;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) largest = std::max(largest, std::abs(matrix[i][k]));
  }
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) RC_ASSERT(std::abs(made[i][k] - matrix[i][k]) <= 1e-6 * largest);
  }
}

double number() { return *rc::gen::inRange(-3000, 3001) / 1000.0; }

RC_GTEST_PROP(TransformSteps, AreTheMatrix, ()) {
  Matrix44d matrix;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) matrix[i][k] = number();
  }
  RC_PRE(std::abs(matrix.determinant()) > 1e-3);
  expect_is_matrix(transform_steps(matrix), matrix);
}

RC_GTEST_PROP(TransformSteps, AreFewForWhatIsWrittenSo, ()) {
  const auto vector = [] { return grf::Vec3f(grf::Vec3d(number(), number(), number())); };
  const grf::Vec3f scale = vector();
  RC_PRE(std::abs(scale.x * scale.y * scale.z) > 1e-3F);
  const std::vector<grf::TransformStep> steps = {
      {Kind::Scale, scale}, {Kind::Rotation, vector()}, {Kind::Translation, vector()}};
  const auto again = transform_steps(grf::matrix_of(steps));
  RC_ASSERT(again.size() <= 3U);
  expect_is_matrix(again, grf::matrix_of(steps));
}

TEST(TransformSteps, HoldAtTheEndsOfTheAngles) {
  const float right = std::numbers::pi_v<float> / 2;
  for (const float x : {0.0F, right, -right, 2 * right}) {
    for (const float y : {right, -right}) {
      for (const float z : {0.0F, 0.3F, right}) {
        const Matrix44d matrix = grf::matrix_of({{Kind::Rotation, grf::Vec3f(x, y, z)}});
        const Matrix44d made = grf::matrix_of(transform_steps(matrix));
        for (int i = 0; i < 3; ++i) {
          for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(made[i][k], matrix[i][k], 1e-6) << x << ' ' << y << ' ' << z;
        }
      }
    }
  }
}

TEST(TransformSteps, OfTheIdentityAreNone) { EXPECT_TRUE(transform_steps(Matrix44d()).empty()); }

TEST(TransformSteps, KeepNumbersThatWereGivenSo) {
  Matrix44d matrix;
  matrix.setScale(grf::Vec3d(2, -3, 0.5));
  matrix[3][1] = 7;
  const std::vector<grf::TransformStep> expected = {{Kind::Scale, grf::Vec3f(2, -3, 0.5F)},
                                                    {Kind::Translation, grf::Vec3f(0, 7, 0)}};
  EXPECT_EQ(transform_steps(matrix), expected);
}

TEST(NameOfFile, HasNoFolderAndQuotesOfOneKind) {
  EXPECT_EQ(name_of_file("models/a \u201Cb\u201D.obj"), "a \u201Cb\u201D");
  EXPECT_EQ(name_of_file("models/a\" \u201Cb\u201D.obj"), "a\" \"b\"");
}

TEST(DefinitionNames, AreDifferentIdentifiers) {
  DefinitionNames names;
  EXPECT_EQ(names.take("steel"), "steel");
  EXPECT_EQ(names.take("steel"), "steel_2");
  EXPECT_EQ(names.take("steel_2"), "steel_2_2");
  EXPECT_EQ(names.take("a b"), "a$20$b");
}

}  // namespace
}  // namespace convert
