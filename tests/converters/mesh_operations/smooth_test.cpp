#include "converters/mesh_operations/smooth.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "converters/mesh_operations/subdivide.h"
#include "grf/topology.h"
#include "tests/converters/mesh_operations/meshes.h"

namespace convert {
namespace {

using grf::Vec3d;
using grf::Vec3f;

constexpr double Forth = 0.5;
constexpr double Back = 1 / (0.1 - 1 / Forth);

grf::MeshDraft closed_octahedron() {
  grf::MeshDraft mesh;
  mesh.positions = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    mesh.add_face(std::array{i, (i + 1) % 4, 4U}, 0);
    mesh.add_face(std::array{(i + 1) % 4, i, 5U}, 0);
  }
  return mesh;
}

grf::MeshDraft noisy(const grf::Mesh& mesh, float size) {
  grf::MeshDraft result(mesh);
  std::mt19937 random(20240501);
  std::uniform_real_distribution<float> offset(-size, size);
  for (Vec3f& p : result.positions) p += Vec3f(offset(random), offset(random), offset(random));
  return result;
}

/// The sum of the squares of what vertices are off the mean of their neighbours.
double laplacian_energy(const grf::Geometry& geometry) {
  std::vector<Vec3d> sums(geometry.positions.size(), Vec3d(0));
  std::vector<double> counts(geometry.positions.size());
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    const auto corners = geometry.face(face);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t a = corners[k];
      const std::uint32_t b = corners[(k + 1) % corners.size()];
      sums[a] += Vec3d(geometry.positions[b]);  // of a closed surface, each neighbour once
      counts[a] += 1;
    }
  }
  double energy = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (counts[i] > 0) energy += (sums[i] / counts[i] - Vec3d(geometry.positions[i])).length2();
  }
  return energy;
}

// The neighbours of an octahedron's vertex have their mean in the middle, those of a tetrahedron's at -P/3.
TEST(Smoothed, HasTheFactorOfATaubinStep) {
  const grf::Mesh eight = smoothed(closed_octahedron(), 1);
  for (const Vec3f& p : eight.geometry->positions) {
    EXPECT_NEAR(p.length(), (1 - Forth) * (1 - Back), 1e-6);
  }
  grf::MeshDraft four;
  four.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const auto& face : {std::array{0U, 1U, 2U}, {0U, 3U, 1U}, {0U, 2U, 3U}, {1U, 3U, 2U}})
    four.add_face(face, 0);
  const double factor = (1 - Forth * 4 / 3) * (1 - Back * 4 / 3);
  const grf::Mesh twice = smoothed(grf::MeshDraft(four), 2);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3f expected = four.positions[i] * static_cast<float>(factor * factor);
    EXPECT_LT((twice.geometry->positions[i] - expected).length(), 1e-6F);
  }
}

TEST(Smoothed, LosesNoiseButNotItsSize) {
  const grf::Mesh sphere = subdivided(closed_octahedron(), {SubdivisionScheme::Loop, 4});
  const grf::Mesh rough = noisy(sphere, 0.01F);
  const grf::Mesh smooth = smoothed(rough, 20);
  EXPECT_LT(laplacian_energy(*smooth.geometry), 0.1 * laplacian_energy(*rough.geometry));
  double radius = 0;
  double expected = 0;
  for (std::size_t i = 0; i < sphere.geometry->positions.size(); ++i) {
    radius += smooth.geometry->positions[i].length();
    expected += sphere.geometry->positions[i].length();
  }
  EXPECT_NEAR(radius / expected, 1, 0.01);
}

TEST(Smoothed, KeepsBoundariesAndAllElse) {
  grf::MeshDraft mesh = noisy(sheet(8, true), 0.2F);
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.uvs.set(i, grf::Vec2f(float(i), 1));
    mesh.colours.set(i, grf::Colour(float(i)));
    mesh.irradiance.set(i, grf::Colour(float(i)));
  }
  const grf::Mesh before = grf::MeshDraft(mesh);
  const grf::Mesh after = smoothed(before, 5);
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const std::uint32_t x = i % 9;
    const std::uint32_t y = i / 9;
    const bool is_inside = x > 0 && x < 8 && y > 0 && y < 8;
    const bool is_kept = after.geometry->positions[i] == before.geometry->positions[i];
    EXPECT_EQ(is_kept, !is_inside) << i;
  }
  grf::MeshDraft moved_back(after);
  moved_back.positions = mesh.positions;
  EXPECT_EQ(grf::Mesh(grf::MeshDraft(moved_back)), before);
}

TEST(Smoothed, KeepsWhatIsEvenAsItIs) {
  const grf::Mesh mesh = smoothed(sheet(8), 10);
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    EXPECT_LT((mesh.geometry->positions[i] - sheet(8).geometry->positions[i]).length(), 1e-5F);
  }
}

TEST(Smoothed, OpensNoSeams) {
  grf::MeshDraft mesh(torn(noisy(sheet(4), 0.2F)));
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.uvs.set(i, grf::Vec2f(float(i), 0));
  const grf::Mesh after = smoothed(grf::MeshDraft(mesh), 5);
  EXPECT_EQ(grf::topology_of(*after.geometry).boundary_edges, 16U);
}

TEST(Smoothed, KeepsNormalsSharedOrApart) {
  grf::MeshDraft hard(torn(cube()));
  grf::MeshDraft soft(torn(cube()));
  for (std::uint32_t i = 0; i < 24; ++i) {
    hard.normals.set(i, Vec3f(grf::doubled_area_vector(hard, i / 4, {})));
    soft.normals.set(i, hard.positions[i] - Vec3f(0.5F));
    soft.uvs.set(i, grf::Vec2f(float(i), 0));
  }
  const grf::Mesh with_edges = smoothed(grf::MeshDraft(hard), 3);
  const grf::Mesh without_edges = smoothed(grf::MeshDraft(soft), 3);
  for (std::uint32_t i = 0; i < 24; ++i) {
    EXPECT_LT((with_edges.geometry->normals[i] - hard.normals[i].normalized()).length(), 1e-6F);
    EXPECT_LT((without_edges.geometry->normals[i] - soft.normals[i].normalized()).length(), 1e-6F);
  }
  EXPECT_TRUE(smoothed(cube(), 3).geometry->normals.empty());
  grf::MeshDraft mixed(cube());
  mixed.normals.set(2, Vec3f(1, 0, 0));
  const grf::Mesh still_mixed = smoothed(grf::MeshDraft(mixed), 3);
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(still_mixed.geometry->normals.has(i), i == 2);
}

}  // namespace
}  // namespace convert
