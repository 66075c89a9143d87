#include "grf/geometry.h"

#include <array>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "grf/mesh.h"
#include "grf/topology.h"
#include "grf/vertex_tree.h"

namespace grf {
namespace {

/// A rectangle of 2 by 1 and, beside it, a triangle of 1 by 1.
Geometry house() {
  Geometry geometry;
  geometry.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {3, 0, 0}};
  geometry.add_face(std::array<std::uint32_t, 4>{0, 1, 2, 3});
  geometry.add_face(std::array<std::uint32_t, 3>{1, 4, 2});
  return geometry;
}

TEST(SharedGeometry, KnowsWhatFollowsFromIt) {
  const SharedGeometry geometry(house());
  EXPECT_EQ(geometry.vertices().bounds(), Box3d({0, 0, 0}, {3, 1, 0}));
  EXPECT_DOUBLE_EQ(geometry.area(), 2.5);
  EXPECT_EQ(geometry.topology().boundary_edges, 5U);
  EXPECT_EQ(geometry.topology().boundary_loops, 1U);
}

TEST(SharedGeometry, IsCutIntoTrianglesFaceByFace) {
  const SharedGeometry geometry(house());
  const Triangulation& triangles = geometry.triangulation();
  ASSERT_EQ(triangles.size(), 3U);
  EXPECT_EQ(triangles.first_of(0), 0U);
  EXPECT_EQ(triangles.first_of(1), 2U);
  EXPECT_EQ(triangles.first_of(2), 3U);
  const auto area = [&](std::size_t i) {
    const auto [a, b, c] = triangles[i];
    const auto& positions = geometry->positions;
    return (positions[b] - positions[a]).cross(positions[c] - positions[a]).z / 2;
  };
  EXPECT_EQ(area(0) + area(1), 2);
  EXPECT_EQ(triangles[2], (std::array<std::uint32_t, 3>{1, 4, 2}));
}

TEST(SharedGeometry, OfTrianglesNeedsNoCutting) {
  Geometry geometry = house();
  geometry.corners = {0, 1, 2, 4, 2, 1};
  geometry.face_offsets = {0, 3, 6};
  const SharedGeometry shared(std::move(geometry));
  ASSERT_EQ(shared.triangulation().size(), 2U);
  EXPECT_EQ(shared.triangulation()[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(shared.triangulation()[1], (std::array<std::uint32_t, 3>{4, 2, 1}));
  EXPECT_EQ(shared.triangulation().first_of(1), 1U);
}

TEST(SharedGeometry, OfNothingIsEmpty) {
  const SharedGeometry nothing;
  EXPECT_TRUE(nothing.vertices().bounds().isEmpty());
  EXPECT_EQ(nothing.area(), 0);
  EXPECT_EQ(nothing.triangulation().size(), 0U);
}

TEST(SharedGeometry, MayBeAskedByThreadsAtOnce) {
  const SharedGeometry geometry(house());
  std::vector<std::size_t> counts(4);
  std::vector<std::thread> threads;
  for (std::size_t& count : counts) {
    threads.emplace_back([&count, geometry] { count = geometry.triangulation().size(); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(counts, std::vector<std::size_t>(4, 3));
}

TEST(Mesh, SharesItsGeometryWithOneOfOtherSurfaces) {
  MeshDraft draft;
  draft.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  draft.add_face(std::array<std::uint32_t, 3>{0, 1, 2}, 0);
  const Mesh mesh(std::move(draft));
  Mesh red = mesh;
  red.surfaces[0].colour = Colour(1, 0, 0);
  EXPECT_TRUE(red.geometry.shares(mesh.geometry));
  EXPECT_NE(red, mesh);
}

}  // namespace
}  // namespace grf
