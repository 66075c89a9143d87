#include "converters/mesh_operations/decimate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "converters/mesh_operations/normals.h"
#include "grf/summary.h"
#include "grf/topology.h"
#include "tests/converters/mesh_operations/meshes.h"

namespace convert {
namespace {

double area_of_surface(const grf::Mesh& mesh, std::uint32_t surface) {
  double area = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    if ((*mesh.surface_of_face)[face] != surface) continue;
    area += grf::doubled_area_vector(*mesh.geometry, face, grf::Matrix44d()).length() / 2;
  }
  return area;
}

/// A sphere of latitudes and longitudes with its radius, of triangles.
grf::Mesh sphere(std::uint32_t n) {
  grf::MeshDraft mesh;
  const auto point = [n](std::uint32_t i, std::uint32_t k) {
    const double theta = std::numbers::pi * i / n;
    const double phi = 2 * std::numbers::pi * (k % (2 * n)) / (2 * n);
    const double r = i == 0 || i == n ? 0 : std::sin(theta);
    return grf::Vec3f(grf::Vec3d(r * std::cos(phi), r * std::sin(phi), std::cos(theta)));
  };
  const auto vertex = [n](std::uint32_t i, std::uint32_t k) { return i * 2 * n + k % (2 * n); };
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k < 2 * n; ++k) mesh.positions.push_back(point(i, k));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < 2 * n; ++k) {
      const std::array a = {vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1)};
      const std::array b = {vertex(i, k), vertex(i + 1, k + 1), vertex(i, k + 1)};
      if (i + 1 < n) mesh.add_face(a, 0);
      if (i > 0) mesh.add_face(b, 0);
    }
  }
  return mesh;
}

/// Each vertex of the one is one of the other, with all that it has.
void expect_vertices_of(const grf::Mesh& mesh, const grf::Mesh& original) {
  const auto key = [](const grf::Mesh& of, std::size_t i) {
    const grf::Vec3f p = of.geometry->positions[i];
    const grf::Vec3f n = of.geometry->normals.has(i) ? of.geometry->normals[i] : grf::Vec3f(0);
    const grf::Vec2f uv = of.geometry->uvs.has(i) ? of.geometry->uvs[i] : grf::Vec2f(-1);
    return std::array{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
  };
  std::set<std::array<float, 8>> known;
  for (std::size_t i = 0; i < original.geometry->positions.size(); ++i) known.insert(key(original, i));
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) EXPECT_TRUE(known.contains(key(mesh, i)));
}

TEST(Decimate, MakesAsManyTrianglesAsAsked) {
  const grf::Mesh ball = sphere(40);
  for (const double ratio : {0.5, 0.1, 0.02}) {
    const Decimated decimated = decimate(ball, ratio);
    EXPECT_EQ(decimated.triangles_before, ball.face_count());
    EXPECT_NEAR(static_cast<double>(decimated.mesh.face_count()),
                ratio * static_cast<double>(ball.face_count()), 1);
    EXPECT_EQ(decimated.triangles_left_alone, 0U);
    const grf::Topology topology = grf::topology_of(*decimated.mesh.geometry);
    EXPECT_EQ(topology.boundary_edges + topology.nonmanifold_edges + topology.nonmanifold_vertices, 0U);
    EXPECT_NEAR(area_of_surface(decimated.mesh, 0), 4 * std::numbers::pi, ratio > 0.05 ? 0.3 : 1.5);
    expect_vertices_of(decimated.mesh, ball);
  }
}

TEST(Decimate, KeepsAllWhereAllIsAsked) {
  const Decimated decimated = decimate(cube(), 1);
  EXPECT_EQ(decimated.mesh.face_count(), 12U) << "squares are cut";
  EXPECT_EQ(decimated.mesh.geometry->positions.size(), 8U);
}

TEST(Decimate, KeepsRimsAndBordersOfSurfaces) {
  const grf::Mesh before = sheet(16, true);
  const Decimated decimated = decimate(before, 0.001);
  EXPECT_LT(decimated.mesh.face_count(), 20U) << "a plane needs few";
  EXPECT_NEAR(area_of_surface(decimated.mesh, 0), 128, 1e-4);
  EXPECT_NEAR(area_of_surface(decimated.mesh, 1), 128, 1e-4);
  EXPECT_EQ(grf::topology_of(*decimated.mesh.geometry).boundary_loops, 1U);
  EXPECT_EQ(decimated.mesh.surfaces, before.surfaces);
}

TEST(Decimate, KeepsRimsThatAreCurved) {
  grf::MeshDraft disc;
  constexpr std::uint32_t Corners = 48;
  disc.positions.emplace_back(0);
  for (std::uint32_t i = 0; i < Corners; ++i) {
    const double phi = 2 * std::numbers::pi * i / Corners;
    disc.positions.emplace_back(float(std::cos(phi)), float(std::sin(phi)), 0.0F);
  }
  for (std::uint32_t i = 0; i < Corners; ++i) disc.add_face(std::array{0U, 1 + i, 1 + (i + 1) % Corners}, 0);
  const Decimated decimated = decimate(grf::MeshDraft(disc), 0.1);
  EXPECT_EQ(grf::topology_of(*decimated.mesh.geometry).boundary_edges, Corners);
  EXPECT_GT(decimated.mesh.face_count(), decimated.triangles_wanted);
  EXPECT_NEAR(area_of_surface(decimated.mesh, 0), area_of_surface(grf::MeshDraft(disc), 0), 1e-6);
}

// The texture is cut in the middle: both sides keep their own coordinates, and the cut stays straight.
TEST(Decimate, KeepsSeamsOfTextureCoordinates) {
  const grf::Mesh one = sheet(8);
  grf::MeshDraft mesh(one);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.uvs.set(i, {mesh.positions[i].x, 0});
  std::map<std::uint32_t, std::uint32_t> other_side;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    const bool is_right = std::any_of(corners.begin(), corners.end(),
                                      [&](std::uint32_t corner) { return mesh.positions[corner].x > 4; });
    for (std::uint32_t k = mesh.face_offsets[face]; is_right && k < mesh.face_offsets[face + 1]; ++k) {
      if (mesh.positions[mesh.corners[k]].x != 4) continue;
      const auto [known, is_new] = other_side.emplace(mesh.corners[k], 0);
      if (is_new) {
        known->second = mesh.copy_vertex(one, mesh.corners[k]);
        mesh.uvs.set(known->second, {14, 0});
      }
      mesh.corners[k] = known->second;
    }
  }
  ASSERT_EQ(other_side.size(), 9U);
  const Decimated decimated = decimate(grf::MeshDraft(mesh), 0.05);
  EXPECT_LT(decimated.mesh.face_count(), 30U);
  expect_vertices_of(decimated.mesh, grf::MeshDraft(mesh));
  for (std::size_t face = 0; face < decimated.mesh.face_count(); ++face) {
    float least = 100;
    float most = 0;
    for (const std::uint32_t corner : decimated.mesh.face(face)) {
      least = std::min(least, decimated.mesh.geometry->positions[corner].x);
      most = std::max(most, decimated.mesh.geometry->positions[corner].x);
      const float u = decimated.mesh.geometry->uvs[corner].x;
      EXPECT_TRUE(u == decimated.mesh.geometry->positions[corner].x || u == 14);
    }
    EXPECT_TRUE(most <= 4 || least >= 4) << "a face lies over the seam";
    for (const std::uint32_t corner : decimated.mesh.face(face)) {
      if (decimated.mesh.geometry->positions[corner].x == 4) {
        EXPECT_EQ(decimated.mesh.geometry->uvs[corner].x, most <= 4 ? 4 : 14);
      }
    }
  }
}

TEST(Decimate, KeepsNormalsAtCreases) {
  const grf::Mesh before = with_smooth_normals(cube(), 0.1);
  const Decimated decimated = decimate(before, 0.5);
  expect_vertices_of(decimated.mesh, before);
  EXPECT_EQ(decimated.mesh.face_count(), 12U) << "each corner has three sides: none can go";
}

TEST(Decimate, LeavesNonManifoldPartsAlone) {
  grf::MeshDraft mesh(sheet(12));
  // A fin on an edge in the middle, and a face with two corners at one place.
  const std::uint32_t a = 6 * 13 + 6;
  mesh.positions.emplace_back(6.5F, 6.0F, 1.0F);
  const auto tip = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  mesh.add_face(std::array{a, a + 1, tip}, 0);
  mesh.add_face(std::array{0U, 1U, 1U}, 0);
  const Decimated decimated = decimate(grf::MeshDraft(mesh), 0.1);
  EXPECT_EQ(decimated.triangles_left_alone, 5U) << "each with two faces of the sheet or one at its edge";
  EXPECT_LT(decimated.mesh.face_count(), 60U);
  const auto has = [&](const grf::Vec3f& position) {
    return std::count(decimated.mesh.geometry->positions.begin(), decimated.mesh.geometry->positions.end(),
                      position) == 1;
  };
  EXPECT_TRUE(has(mesh.positions[a]) && has(mesh.positions[a + 1]) && has(mesh.positions[tip]));
  EXPECT_EQ(grf::topology_of(*decimated.mesh.geometry).nonmanifold_edges, 2U);
  EXPECT_NEAR(area_of_surface(decimated.mesh, 0), 144 + 0.5, 1e-4);
}

TEST(Decimate, TakesAnyHeapOfTriangles) {
  grf::MeshDraft heap;
  for (std::uint32_t i = 0; i < 12; ++i)
    heap.positions.emplace_back(float(i * 7 % 5), float(i * 5 % 7), float(i % 3));
  std::uint32_t state = 1;
  for (int face = 0; face < 200; ++face) {
    std::array<std::uint32_t, 3> corners = {};
    for (std::uint32_t& corner : corners) {
      state = state * 1664525U + 1013904223U;
      corner = (state >> 16U) % 12;
    }
    heap.add_face(corners, 0);
  }
  const Decimated decimated = decimate(grf::MeshDraft(heap), 0.01);
  EXPECT_GT(decimated.triangles_left_alone, 150U);
  EXPECT_GE(decimated.mesh.face_count(), decimated.triangles_left_alone);
}

TEST(Decimate, OfNothingIsNothing) { EXPECT_EQ(decimate(grf::Mesh(), 0.5).mesh.face_count(), 0U); }

}  // namespace
}  // namespace convert
