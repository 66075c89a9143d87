#include "editor/view/mesh_geometry.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "editor/view/proxy_mesh.h"
#include "tests/grf/height_field.h"

namespace editor {
namespace {

using grf::Vec3d;

/// The nearest hit over all triangles, by their planes and edge tests.
std::optional<MeshHit> brute_force(const TriangleArrays& arrays, const ViewRay& ray) {
  std::optional<MeshHit> nearest;
  for (std::uint32_t i = 0; i < arrays.triangles.size(); ++i) {
    const auto& [ia, ib, ic] = arrays.triangles[i];
    const Vec3d a(arrays.positions[ia]);
    const Vec3d b(arrays.positions[ib]);
    const Vec3d c(arrays.positions[ic]);
    const Vec3d normal = (b - a).cross(c - a);
    const double distance = (a - ray.origin).dot(normal) / ray.direction.dot(normal);
    if (!(distance > ray.nearest)) continue;
    const Vec3d p = ray.at(distance);
    const bool is_inside = (b - a).cross(p - a).dot(normal) >= 0 && (c - b).cross(p - b).dot(normal) >= 0 &&
                           (a - c).cross(p - c).dot(normal) >= 0;
    if (is_inside && (!nearest || distance < nearest->distance)) nearest = {distance, i};
  }
  return nearest;
}

TEST(MeshGeometry, RaysMeetTheNearestTriangle) {
  const MeshGeometry geometry(grf::height_field(60));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    ViewRay ray;
    ray.origin = Vec3d(uniform(random), uniform(random), 1.5);
    ray.direction = (Vec3d(uniform(random), uniform(random), 0) - ray.origin).normalized();
    if (i % 4 == 0) ray.direction = Vec3d(0, 0, -1);
    const auto expected = brute_force(geometry.arrays(), ray);
    const auto hit = geometry.intersect(ray);
    ASSERT_EQ(hit.has_value(), expected.has_value());
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->distance, expected->distance, 1e-9);
    // Two triangles may be hit at their common edge.
    if (hit->triangle != expected->triangle) {
      EXPECT_NEAR(hit->distance, expected->distance, 1e-12);
    }
  }
  EXPECT_GT(hits, 1500);
}

TEST(MeshGeometry, KnowsFacesOfTrianglesAndEdgesOfPolygons) {
  grf::MeshDraft mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.add_face(std::array{0U, 1U, 2U, 3U}, 0);
  mesh.add_face(std::array{1U, 4U, 2U}, 0);
  const MeshGeometry geometry(std::move(mesh));
  EXPECT_EQ(geometry.arrays().face_of_triangle, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(geometry.edges().size(), 6);
  EXPECT_EQ(geometry.first_triangle(1), 2);
  EXPECT_EQ(geometry.first_triangle(2), 3);
  EXPECT_EQ(Vec3d(geometry.centres()[0]), Vec3d(0.5, 0.5, 0));
  EXPECT_EQ(Vec3d(geometry.normals()[1]), Vec3d(0, 0, 1));
}

TEST(StandIn, HasAboutAsManyTrianglesAndTheSameShape) {
  const MeshGeometry geometry(grf::height_field(400));
  const TriangleArrays quick = make_proxy_mesh(geometry.arrays(), 20'000);
  EXPECT_GT(quick.triangles.size(), 5'000);
  EXPECT_LT(quick.triangles.size(), 30'000);
  EXPECT_EQ(quick.face_of_triangle.size(), quick.triangles.size());
  double farthest = 0;
  for (const grf::Vec3f& p : quick.positions) {
    farthest = std::max(farthest, double(std::abs(p.z - std::sin(9 * p.x) * std::cos(7 * p.y) / 5)));
  }
  EXPECT_LT(farthest, 0.005);
}

TEST(StandIn, OfASmallMeshIsTheMesh) {
  const MeshGeometry geometry(grf::height_field(10));
  EXPECT_EQ(make_proxy_mesh(geometry.arrays(), 1000).triangles, geometry.arrays().triangles);
}

TEST(StandIn, ThinningTakesEveryNthTriangle) {
  const MeshGeometry geometry(grf::height_field(101));
  const TriangleArrays thin = subsampled(geometry.arrays(), 1000);
  EXPECT_EQ(thin.triangles.size(), 1000);
  EXPECT_EQ(thin.face_of_triangle[7], 140);
}

}  // namespace
}  // namespace editor
