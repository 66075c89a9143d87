#include "grf/vertex_tree.h"

#include <random>

#include <gtest/gtest.h>

#include "grf/mesh.h"

namespace grf {
namespace {

Mesh cloud(std::size_t vertices, std::mt19937& random) {
  std::normal_distribution<float> number;
  MeshDraft mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    mesh.positions.emplace_back(number(random), 3 * number(random), number(random) - 5);
  }
  return mesh;
}

/// Translations and scales along the axes, which may mirror, are shortcuts of `bounds_under`.
Matrix44d random_scale_and_translation(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-2, 2);
  Matrix44d matrix;
  for (int k = 0; k < 3; ++k) {
    matrix[k][k] = number(random);
    matrix[3][k] = number(random);
  }
  return matrix;
}

Matrix44d random_transform(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-2, 2);
  Matrix44d matrix;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) matrix[i][k] = number(random);
  }
  return matrix;
}

TEST(VertexTree, BoundsTheTransformedVerticesThemselves) {
  std::mt19937 random(1);
  for (const std::size_t vertices : {1, 2, 15, 16, 17, 64, 65, 1000, 5000}) {
    const Mesh mesh = cloud(vertices, random);
    const VertexTree tree(*mesh.geometry);
    for (int i = 0; i < 20; ++i) {
      const Matrix44d transform =
          i % 2 == 0 ? random_transform(random) : random_scale_and_translation(random);
      Box3d expected;
      for (const Vec3f& position : mesh.geometry->positions) expected.extendBy(Vec3d(position) * transform);
      const Box3d bounds = tree.bounds_under(transform);
      EXPECT_EQ(bounds.min, expected.min) << vertices;
      EXPECT_EQ(bounds.max, expected.max) << vertices;
    }
  }
}

TEST(VertexTree, FindsWhetherAVertexIsBeyondAPlane) {
  std::mt19937 random(2);
  std::normal_distribution<double> number;
  for (const std::size_t vertices : {1, 16, 33, 4000}) {
    const Mesh mesh = cloud(vertices, random);
    const VertexTree tree(*mesh.geometry);
    int found = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3d normal = Vec3d(number(random), number(random), number(random)).normalized();
      const double height = 8 * number(random);
      const auto above = [&](const Vec3d& position) { return position.dot(normal) - height; };
      bool expected = false;
      for (const Vec3f& position : mesh.geometry->positions)
        expected = expected || above(Vec3d(position)) > 0;
      const auto bound = [&](const Box3d& box) { return highest_at_corners(box, above); };
      EXPECT_EQ(tree.highest(bound, above, 0, 0) > 0, expected) << vertices;
      const double highest = tree.highest(bound, above);
      EXPECT_EQ(highest > 0, expected) << vertices;
      EXPECT_EQ(tree.highest(bound, above, highest + 1), highest + 1) << "none is over that";
      found += expected ? 1 : 0;
    }
    EXPECT_GT(found, 20);
    EXPECT_LT(found, 180);
  }
}

TEST(VertexTree, OfNothingIsEmpty) {
  const Geometry nothing;
  const VertexTree tree(nothing);
  EXPECT_TRUE(tree.bounds().isEmpty());
  EXPECT_TRUE(tree.bounds_under(Matrix44d()).isEmpty());
}

}  // namespace
}  // namespace grf
