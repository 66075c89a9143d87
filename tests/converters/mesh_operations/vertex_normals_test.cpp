#include "converters/mesh_operations/vertex_normals.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "grf/topology.h"

namespace convert {
namespace {

using Face = std::vector<std::uint32_t>;

const std::vector<grf::Vec3f> CubeCorners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                             {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

grf::Geometry geometry_of(std::vector<grf::Vec3f> positions, const std::vector<Face>& faces) {
  grf::Geometry geometry;
  geometry.positions = std::move(positions);
  for (const Face& face : faces) geometry.add_face(face);
  return geometry;
}

/// The normal at a vertex of all faces, without creases.
std::optional<grf::Vec3f> normal_at(const std::vector<grf::Vec3f>& positions, const std::vector<Face>& faces,
                                    std::uint32_t vertex) {
  grf::Vec3d sum(0);
  std::vector<grf::Vec3d> normals;
  for (const Face& face : faces) {
    weighted_normals(face, positions, normals);
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (face[k] == vertex) sum += normals[k];
    }
  }
  return unit_normal(sum);
}

void expect_near(const grf::Vec3f& a, const grf::Vec3f& b) { EXPECT_LT((a - b).length(), 1e-6F) << a << b; }

TEST(VertexNormals, DoNotDependOnHowAPolygonIsCut) {
  const grf::Vec3f diagonal = grf::Vec3f(1, 1, 1).normalized();
  expect_near(*normal_at(CubeCorners, {{4, 5, 6, 7}, {1, 2, 6, 5}, {2, 3, 7, 6}}, 6), diagonal);
  expect_near(*normal_at(CubeCorners, {{4, 5, 6}, {4, 6, 7}, {1, 2, 6, 5}, {2, 3, 7}, {2, 7, 6}}, 6),
              diagonal);
}

TEST(VertexNormals, CountTheInsideOfACornerThatPointsInwards) {
  // An arrow whose notch has an angle of 270 degrees, and a wall on one of its edges.
  const std::vector<grf::Vec3f> positions = {{0, 0, 0}, {-1, -1, 0}, {2, 0, 0}, {-1, 1, 0}, {-1, -1, 1}};
  const grf::Vec3f wall = grf::Vec3f(1, -1, 0).normalized();
  const float wall_angle = std::acos(grf::Vec3f(-1, -1, 0).dot({-1, -1, 1}) / std::sqrt(6.0F));
  const float notch_angle = 1.5F * std::numbers::pi_v<float>;
  expect_near(*normal_at(positions, {{0, 1, 2, 3}, {1, 0, 4}}, 0),
              (grf::Vec3f(0, 0, 1) * notch_angle + wall * wall_angle).normalized());
}

// A quadrilateral that is no plane, with an angle of 60 degrees at its first corner.
TEST(VertexNormals, TakeTheTrueAngleWhereAFaceIsNotPlane) {
  const std::vector<grf::Vec3f> positions = {{0, 0, 0}, {1, 1, 0}, {2, 0, 2}, {0, 1, 1}};
  std::vector<grf::Vec3d> normals;
  weighted_normals(Face{0, 1, 2, 3}, positions, normals);
  EXPECT_NEAR(normals[0].length(), std::numbers::pi / 3, 1e-12);
}

TEST(VertexNormals, HaveTheLengthOfAnObtuseAngle) {
  const std::vector<grf::Vec3f> positions = {{0, 0, 0}, {1, 0, 0}, {-1, 1, 0}};
  std::vector<grf::Vec3d> normals;
  weighted_normals(Face{0, 1, 2}, positions, normals);
  EXPECT_NEAR(normals[0].length(), std::numbers::pi * 3 / 4, 1e-12);
  EXPECT_NEAR(normals[0].length() + normals[1].length() + normals[2].length(), std::numbers::pi, 1e-12);
}

TEST(VertexNormals, OfFacesBackToBackOrWithoutAreaAreNone) {
  const std::vector<grf::Vec3f> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  EXPECT_FALSE(normal_at(positions, {{0, 1, 2}, {2, 1, 0}}, 0).has_value());
  EXPECT_FALSE(normal_at(positions, {{0, 1, 3}}, 0).has_value());
  EXPECT_TRUE(normal_at(positions, {{0, 1, 3}, {0, 1, 2}}, 0).has_value());
}

TEST(VertexNormals, AreApartAtCreases) {
  constexpr double RightAngle = std::numbers::pi / 2;
  // A floor and a wall that meet along the edge from 1 to 2.
  const grf::Geometry geometry = geometry_of(CubeCorners, {{0, 1, 2, 3}, {1, 5, 6, 2}});
  CreasedNormals smooth = creased_normals(geometry, {}, RightAngle + 1e-6);
  expect_near(*smooth.at(1), grf::Vec3f(-1, 0, 1).normalized());
  expect_near(*smooth.at(4), *smooth.at(1));
  expect_near(*smooth.at(0), {0, 0, 1});
  CreasedNormals creased = creased_normals(geometry, {}, RightAngle - 1e-6);
  expect_near(*creased.at(1), {0, 0, 1});
  expect_near(*creased.at(4), {-1, 0, 0});
}

TEST(VertexNormals, AreWeightedByAngleBetweenCreases) {
  const grf::Geometry geometry = geometry_of(CubeCorners, {{0, 1, 2}, {0, 2, 3}, {1, 5, 6, 2}});
  expect_near(*creased_normals(geometry, {}, 3).at(2), grf::Vec3f(-1, 0, 1).normalized());
}

TEST(VertexNormals, GoOverSeamsWherePlacesAreGiven) {
  std::vector<grf::Vec3f> positions = CubeCorners;
  positions.insert(positions.end(), CubeCorners.begin(), CubeCorners.end());
  const grf::Geometry geometry = geometry_of(positions, {{0, 1, 2, 3}, {9, 13, 14, 10}});
  CreasedNormals joined = creased_normals(geometry, grf::first_at_position(geometry), 3);
  expect_near(*joined.at(1), grf::Vec3f(-1, 0, 1).normalized());
  CreasedNormals apart = creased_normals(geometry, {}, 3);
  expect_near(*apart.at(1), {0, 0, 1});
}

}  // namespace
}  // namespace convert
