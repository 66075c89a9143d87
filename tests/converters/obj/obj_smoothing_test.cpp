// Smoothing groups of files without normals.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace convert
