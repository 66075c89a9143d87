#include "converters/mesh_operations/normals.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/converters/mesh_operations/meshes.h"

namespace convert {
namespace {

constexpr double Degree = std::numbers::pi / 180;

/// The largest distance between the normals of a face's corners and a direction.
float distance_to(const grf::Mesh& mesh, std::size_t face, const grf::Vec3f& direction) {
  float largest = 0;
  for (const std::uint32_t corner : mesh.face(face)) {
    if (!mesh.geometry->normals.has(corner)) return 2;
    largest = std::max(largest, (mesh.geometry->normals[corner] - direction).length());
  }
  return largest;
}

TEST(SmoothNormals, OfACubePointOutwards) {
  const grf::Mesh mesh = with_smooth_normals(torn(cube()), std::numbers::pi);
  EXPECT_EQ(mesh.geometry->positions.size(), 8U) << "what faces shared not is shared now";
  for (std::size_t i = 0; i < 8; ++i) {
    const grf::Vec3f outwards = (mesh.geometry->positions[i] - grf::Vec3f(0.5F)).normalized();
    EXPECT_LT((mesh.geometry->normals[i] - outwards).length(), 1e-6F);
  }
}

TEST(SmoothNormals, SplitAtCreases) {
  const grf::Mesh mesh = with_smooth_normals(cube(), 89 * Degree);
  EXPECT_EQ(mesh.geometry->positions.size(), 24U);
  EXPECT_LT(distance_to(mesh, 0, {0, 0, 1}), 1e-6F);
  EXPECT_LT(distance_to(mesh, 1, {0, -1, 0}), 1e-6F);
  EXPECT_EQ(with_smooth_normals(cube(), 90 * Degree).geometry->positions.size(), 8U)
      << "the angle itself is smooth";
}

// A triangle of a corner's side counts by its angle: a square's two triangles as much as the square.
TEST(SmoothNormals, AreWeightedByAngle) {
  const grf::Mesh square = cube();
  grf::MeshDraft halves(cube());
  halves.corners.clear();
  halves.face_offsets = {0};
  halves.surface_of_face.clear();
  for (std::size_t face = 0; face < square.face_count(); ++face) {
    const auto c = square.face(face);
    halves.add_face(std::array{c[0], c[1], c[2]}, 0);
    halves.add_face(std::array{c[0], c[2], c[3]}, 0);
  }
  const grf::Mesh mesh = with_smooth_normals(grf::MeshDraft(halves), std::numbers::pi);
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    const grf::Vec3f outwards = (mesh.geometry->positions[i] - grf::Vec3f(0.5F)).normalized();
    EXPECT_LT((mesh.geometry->normals[i] - outwards).length(), 1e-6F);
  }
}

// Two sheets that touch in a vertex alone have a normal each there.
TEST(SmoothNormals, DoNotReachOverAVertex) {
  grf::MeshDraft mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  mesh.add_face(std::array{0U, 1U, 2U}, 0);
  mesh.add_face(std::array{0U, 3U, 4U}, 0);
  const grf::Mesh smooth = with_smooth_normals(grf::MeshDraft(mesh), std::numbers::pi);
  EXPECT_LT(distance_to(smooth, 0, {0, 0, 1}), 1e-6F);
  EXPECT_LT(distance_to(smooth, 1, {0, 1, 0}), 1e-6F);
}

TEST(SmoothNormals, KeepAllElse) {
  grf::MeshDraft mesh(sheet(2, true));
  mesh.name = "sheet";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.normals.set(i, {1, 0, 0});
    mesh.uvs.set(i, {mesh.positions[i].x, mesh.positions[i].y});
    mesh.irradiance.set(i, grf::Colour(float(i)));
  }
  const grf::Mesh smooth = with_smooth_normals(grf::MeshDraft(mesh), 0);
  EXPECT_EQ(smooth.name, "sheet");
  EXPECT_EQ(smooth.geometry->positions.size(), mesh.positions.size());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    EXPECT_EQ(smooth.surface(face), mesh.surfaces[mesh.surface_of_face[face]]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t before = mesh.face(face)[k];
      const std::uint32_t after = smooth.face(face)[k];
      EXPECT_EQ(smooth.geometry->positions[after], mesh.positions[before]);
      EXPECT_EQ(smooth.geometry->uvs[after], mesh.uvs[before]);
      EXPECT_EQ((*smooth.irradiance)[after], mesh.irradiance[before]);
      EXPECT_EQ(smooth.geometry->normals[after], grf::Vec3f(0, 0, 1));
    }
  }
}

TEST(SmoothNormals, OfAFaceWithoutAreaAreNone) {
  grf::MeshDraft mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.add_face(std::array{0U, 1U, 2U}, 0);
  EXPECT_TRUE(with_smooth_normals(grf::MeshDraft(mesh), std::numbers::pi).geometry->normals.empty());
}

TEST(FlatFaces, HaveNoNormalsAndShareVertices) {
  const grf::Mesh mesh = with_flat_faces(with_smooth_normals(cube(), 0));
  EXPECT_TRUE(mesh.geometry->normals.empty());
  EXPECT_EQ(mesh.geometry->positions.size(), 8U);
  EXPECT_EQ(mesh.face_count(), 6U);
}

}  // namespace
}  // namespace convert
