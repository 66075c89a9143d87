#include "grf/topology.h"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/grf/reading.h"

namespace grf {
namespace {

const std::string CubeVertices =
    "begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) (1, 1, 0) (0, 0, 1) (1, 0, 1) (0, 1, 1) (1, 1, 1) end ";

/// The topology of a mesh with these vertices and faces.
Topology topology(const std::string& vertices, const std::string& faces) {
  const Scene scene = scene_of("begin mesh " + vertices + "begin faces " + faces + " end faces end mesh\n");
  return topology_of(*std::get<Shared<Mesh>>(scene.contents.blocks.front().content)->geometry);
}

TEST(Topology, OfAClosedSurfaceIsSound) {
  const Topology cube =
      topology(CubeVertices, "(4, 5, 7, 6) (0, 1, 5, 4) (1, 3, 7, 5) (3, 2, 6, 7) (2, 0, 4, 6) (0, 2, 3, 1)");
  EXPECT_EQ(cube.boundary_edges, 0U);
  EXPECT_EQ(cube.boundary_loops, 0U);
  EXPECT_EQ(cube.nonmanifold_edges, 0U);
  EXPECT_EQ(cube.nonmanifold_vertices, 0U);
}

TEST(Topology, FindsEdgesBetweenPlacesOrVertices) {
  Geometry two_squares;
  two_squares.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                           {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
  two_squares.add_face(std::array{0U, 1U, 2U, 3U});
  two_squares.add_face(std::array{4U, 5U, 6U, 7U});
  const auto count = [&](const std::vector<std::uint32_t>& places) {
    std::size_t edges = 0;
    for_each_edge(half_edges_of(two_squares, places), [&](std::span<const HalfEdge>) { ++edges; });
    return edges;
  };
  EXPECT_EQ(count({}), 8U);
  EXPECT_EQ(count(first_at_position(two_squares)), 7U);
}

TEST(Topology, CountsHolesAsLoops) {
  const Topology tube = topology(CubeVertices, "(0, 1, 5, 4) (1, 3, 7, 5) (3, 2, 6, 7) (2, 0, 4, 6)");
  EXPECT_EQ(tube.boundary_edges, 8U);
  EXPECT_EQ(tube.boundary_loops, 2U);
  EXPECT_EQ(tube.nonmanifold_vertices, 0U);
}

TEST(Topology, TakesFansThatMeetAtAVertexApart) {
  const Topology bow_tie = topology(CubeVertices, "(0, 1, 3) (0, 6, 4)");
  EXPECT_EQ(bow_tie.boundary_edges, 6U);
  EXPECT_EQ(bow_tie.boundary_loops, 2U);
  EXPECT_EQ(bow_tie.nonmanifold_edges, 0U);
  EXPECT_EQ(bow_tie.nonmanifold_vertices, 1U);
}

TEST(Topology, CountsTheEndsOfNonManifoldEdgesNoMore) {
  const Topology fins = topology(CubeVertices, "(0, 1, 2) (1, 0, 4) (0, 1, 7)");
  EXPECT_EQ(fins.nonmanifold_edges, 1U);
  EXPECT_EQ(fins.nonmanifold_vertices, 0U);
  EXPECT_EQ(fins.boundary_edges, 6U);
}

TEST(Topology, SeesNoHoleWhereVerticesAreAtOnePlace) {
  const Topology seam = topology(
      "begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) normal (0, 0, 1) (1, 0, -0) (0, 1, 0) (1, 1, 0) end ",
      "(0, 1, 2) (3, 5, 4)");
  EXPECT_EQ(seam.boundary_edges, 4U);
  EXPECT_EQ(seam.boundary_loops, 1U);
  EXPECT_EQ(seam.nonmanifold_vertices, 0U);
}

TEST(Topology, OfNothingIsNothing) {
  EXPECT_EQ(topology_of(*Mesh().geometry).boundary_loops, 0U);
  const Topology point = topology(CubeVertices, "(0, 0, 0)");
  EXPECT_EQ(point.boundary_edges, 0U) << "edges without a length";
}

TEST(DisjointSets, AreJoinedAndKnownByTheLeast) {
  DisjointSets sets(6);
  for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(sets.set_of(i), i);
  sets.join(4, 5);
  sets.join(1, 2);
  EXPECT_NE(sets.set_of(1), sets.set_of(4));
  sets.join(5, 2);
  for (const std::uint32_t i : {1U, 2U, 4U, 5U}) EXPECT_EQ(sets.set_of(i), 1U);
  EXPECT_EQ(sets.set_of(0), 0U);
  EXPECT_EQ(sets.set_of(3), 3U);
}

}  // namespace
}  // namespace grf
