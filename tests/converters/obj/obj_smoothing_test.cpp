// Smoothing groups of files without normals.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/smooth_normals.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::IsEmpty;

// Two squares that meet at a right angle along the edge from 2 to 3.
const std::string Roof = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\n";

grf::Mesh mesh_of(const std::string& obj) {
  const Reading reading = read_obj_text(obj);
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_THAT(reading.text(), IsEmpty());
  return reading.scene ? meshes_of(*reading.scene).at(0) : grf::Mesh();
}

grf::Vec3f normal_of(const grf::Mesh& mesh, std::size_t face, std::size_t corner) {
  const std::uint32_t vertex = mesh.face(face)[corner];
  return mesh.geometry->normals.has(vertex) ? mesh.geometry->normals[vertex] : grf::Vec3f(0);
}

void expect_near(const grf::Vec3f& a, const grf::Vec3f& b) { EXPECT_LT((a - b).length(), 1e-6F) << a << b; }

TEST(SmoothingGroups, GiveTheFacesOfOneGroupOneNormal) {
  const grf::Mesh mesh = mesh_of(Roof + "s 1\nf 1 2 3 4\nf 2 5 6 3\n");
  EXPECT_EQ(mesh.geometry->positions.size(), 6U);
  const float half = std::sqrt(0.5F);
  expect_near(normal_of(mesh, 0, 0), {0, 0, 1});
  expect_near(normal_of(mesh, 0, 1), {half, 0, half});
  expect_near(normal_of(mesh, 1, 3), {half, 0, half});
  expect_near(normal_of(mesh, 1, 1), {1, 0, 0});
}

TEST(SmoothingGroups, KeepFacesOfOtherGroupsApart) {
  const grf::Mesh mesh = mesh_of(Roof + "s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n");
  EXPECT_EQ(mesh.geometry->positions.size(), 8U);
  expect_near(normal_of(mesh, 0, 1), {0, 0, 1});
  expect_near(normal_of(mesh, 1, 0), {1, 0, 0});
}

TEST(SmoothingGroups, MayBeOff) {
  for (const char* off : {"s off", "s 0", "s"}) {
    const grf::Mesh mesh = mesh_of(Roof + "s 1\nf 1 2 3 4\n" + off + "\nf 2 5 6 3\n");
    EXPECT_EQ(mesh.geometry->positions.size(), 8U);
    expect_near(normal_of(mesh, 0, 1), {0, 0, 1});
    EXPECT_FALSE(mesh.geometry->normals.has(mesh.face(1)[0])) << "it is flat";
  }
}

TEST(SmoothingGroups, GoOnAcrossObjectsAndMaterials) {
  const Reading reading = read_obj_text(Roof + "s 3\no a\nf 1 2 3 4\no b\nusemtl m\nf 2 5 6 3\n");
  ASSERT_TRUE(reading.scene.has_value());
  const std::vector<grf::Mesh> meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 2U);
  expect_near(normal_of(meshes[0], 0, 1), normal_of(meshes[1], 0, 0));
}

TEST(SmoothingGroups, LeaveNormalsAsTheyAre) {
  const grf::Mesh mesh = mesh_of(Roof + "vn 0 1 0\ns 1\nf 1//1 2//1 3//1 4//1\nf 2 5 6 3\n");
  expect_near(normal_of(mesh, 0, 0), {0, 1, 0});
  expect_near(normal_of(mesh, 1, 0), {1, 0, 0});
}

TEST(SmoothingGroups, WithoutAreaGiveNoNormal) {
  const grf::Mesh mesh = mesh_of("v 0 0 0\nv 1 0 0\nv 2 0 0\ns 1\nf 1 2 3\n");
  EXPECT_TRUE(mesh.geometry->normals.empty());
}

TEST(SmoothNormals, DoNotDependOnHowAPolygonIsCut) {
  const std::vector<grf::Vec3f> cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const auto normal_at = [&](const std::vector<std::vector<std::uint32_t>>& faces) {
    SmoothNormals normals;
    for (const auto& face : faces) normals.add_face(1, face, cube);
    return *normals.normal(1, 6);
  };
  const grf::Vec3f diagonal = grf::Vec3f(1, 1, 1).normalized();
  expect_near(normal_at({{4, 5, 6, 7}, {1, 2, 6, 5}, {2, 3, 7, 6}}), diagonal);
  expect_near(normal_at({{4, 5, 6}, {4, 6, 7}, {1, 2, 6, 5}, {2, 3, 7}, {2, 7, 6}}), diagonal);
}

TEST(SmoothNormals, CountTheInsideOfACornerThatPointsInwards) {
  // An arrow whose notch has an angle of 270 degrees, and a wall on one of its edges.
  const std::vector<grf::Vec3f> positions = {{0, 0, 0}, {-1, -1, 0}, {2, 0, 0}, {-1, 1, 0}, {-1, -1, 1}};
  SmoothNormals normals;
  normals.add_face(1, std::vector<std::uint32_t>{0, 1, 2, 3}, positions);
  normals.add_face(1, std::vector<std::uint32_t>{1, 0, 4}, positions);
  const grf::Vec3f wall = grf::Vec3f(1, -1, 0).normalized();
  const float wall_angle = std::acos(grf::Vec3f(-1, -1, 0).dot({-1, -1, 1}) / std::sqrt(6.0F));
  const float notch_angle = 1.5F * std::acos(-1.0F);
  expect_near(*normals.normal(1, 0), (grf::Vec3f(0, 0, 1) * notch_angle + wall * wall_angle).normalized());
}

TEST(SmoothNormals, OfFacesBackToBackAreNone) {
  const std::vector<grf::Vec3f> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  SmoothNormals normals;
  normals.add_face(1, std::vector<std::uint32_t>{0, 1, 2}, positions);
  normals.add_face(1, std::vector<std::uint32_t>{2, 1, 0}, positions);
  EXPECT_FALSE(normals.normal(1, 0).has_value());
  EXPECT_FALSE(normals.normal(2, 0).has_value());
}

}  // namespace
}  // namespace convert
