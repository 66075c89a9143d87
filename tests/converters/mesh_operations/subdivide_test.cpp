#include "converters/mesh_operations/subdivide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grf/topology.h"
#include "tests/converters/mesh_operations/meshes.h"

namespace convert {
namespace {

using grf::Vec2f;
using grf::Vec3f;

constexpr Subdivision Loop{SubdivisionScheme::Loop, 1};
constexpr Subdivision CatmullClark{SubdivisionScheme::CatmullClark, 1};

Subdivision times(Subdivision subdivision, int levels) { return {subdivision.scheme, levels}; }

grf::MeshDraft mesh_of(const std::vector<Vec3f>& positions,
                       const std::vector<std::vector<std::uint32_t>>& faces) {
  grf::MeshDraft mesh;
  mesh.positions = positions;
  for (const auto& face : faces) mesh.add_face(face, 0);
  return mesh;
}

/// From -1 to 1.
grf::MeshDraft centred_cube() {
  grf::MeshDraft mesh(cube());
  for (Vec3f& position : mesh.positions) position = 2.0F * position - Vec3f(1);
  return mesh;
}

grf::MeshDraft octahedron() {
  return mesh_of({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                 {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

/// Whether a vertex is near a position.
bool has(const grf::Mesh& mesh, const Vec3f& position, float tolerance = 1e-6F) {
  const auto& all = mesh.geometry->positions;
  return std::any_of(all.begin(), all.end(),
                     [&](const Vec3f& other) { return (other - position).length() <= tolerance; });
}

/// All ways to give the coordinates signs and another order.
std::vector<Vec3f> mirrored(const Vec3f& position) {
  std::vector<Vec3f> all;
  std::array<float, 3> values = {position.x, position.y, position.z};
  std::sort(values.begin(), values.end());
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      const auto sign = [&](unsigned axis) { return (signs >> axis & 1U) != 0 ? -1.0F : 1.0F; };
      all.emplace_back(values[0] * sign(0), values[1] * sign(1), values[2] * sign(2));
    }
  } while (std::next_permutation(values.begin(), values.end()));
  return all;
}

TEST(CatmullClark, OfACubeHasThePositionsOfItsMasks) {
  const grf::Mesh mesh = subdivided(centred_cube(), CatmullClark);
  EXPECT_EQ(mesh.geometry->positions.size(), 26U);
  ASSERT_EQ(mesh.face_count(), 24U);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(mesh.face(i).size(), 4U);
  for (const Vec3f& p : mirrored(Vec3f(5) / 9.0F)) EXPECT_TRUE(has(mesh, p)) << p;  // (F + 2 R)/3
  for (const Vec3f& p : mirrored(Vec3f(0.75F, 0.75F, 0))) EXPECT_TRUE(has(mesh, p)) << p;
  for (const Vec3f& p : mirrored(Vec3f(1, 0, 0))) EXPECT_TRUE(has(mesh, p)) << p;
  EXPECT_EQ(grf::topology_of(*mesh.geometry).boundary_edges, 0U);
  for (std::size_t i = 0; i < 24; ++i) {
    const Vec3f outwards(grf::doubled_area_vector(*mesh.geometry, i, {}));
    EXPECT_GT(outwards.dot(mesh.geometry->positions[mesh.face(i)[0]]), 0) << "fronts stay fronts";
  }
}

// The limit of a vertex among n quadrilaterals is (n^2 P + 4 sum of edges' ends + sum of corners across)/(n
// (n + 5)) (Halstead, Kass and DeRose 1993): of the cube's, (9 + 4 - 1)/24.
TEST(CatmullClark, OfACubeApproachesTheLimit) {
  const grf::Mesh mesh = subdivided(centred_cube(), times(CatmullClark, 5));
  EXPECT_EQ(mesh.face_count(), 6U * 1024U);
  for (const Vec3f& p : mirrored(Vec3f(0.5F))) EXPECT_TRUE(has(mesh, p, 2e-4F)) << p;
}

TEST(CatmullClark, MakesAQuadrilateralOfEachCorner) {
  const grf::Mesh mesh = subdivided(mesh_of({{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, {{0, 1, 2}}), CatmullClark);
  EXPECT_EQ(mesh.face_count(), 3U);
  EXPECT_TRUE(has(mesh, {1, 1, 1})) << "the face's middle";
  EXPECT_TRUE(has(mesh, {1.5F, 1.5F, 0}));
  EXPECT_TRUE(has(mesh, {18 / 8.0F, 3 / 8.0F, 3 / 8.0F}));
}

TEST(LoopSubdivision, OfATetrahedronHasThePositionsOfItsMasks) {
  const grf::Mesh mesh = subdivided(mesh_of({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                            {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}),
                                    Loop);
  EXPECT_EQ(mesh.geometry->positions.size(), 10U);
  EXPECT_EQ(mesh.face_count(), 16U);
  // beta = 3/16, and the three neighbours add up to -P.
  for (const Vec3f& p : {Vec3f(1, 1, 1), Vec3f(1, -1, -1), Vec3f(-1, 1, -1), Vec3f(-1, -1, 1)})
    EXPECT_TRUE(has(mesh, p / 4.0F)) << p;
  for (const Vec3f& p : mirrored({0.5F, 0, 0})) EXPECT_TRUE(has(mesh, p)) << p;
  EXPECT_EQ(grf::topology_of(*mesh.geometry).boundary_edges, 0U);
}

TEST(LoopSubdivision, OfAnOctahedronHasThePositionsOfItsMasks) {
  const grf::Mesh mesh = subdivided(octahedron(), Loop);
  EXPECT_EQ(mesh.geometry->positions.size(), 18U);
  EXPECT_EQ(mesh.face_count(), 32U);
  for (const Vec3f& p : mirrored({33 / 64.0F, 0, 0})) EXPECT_TRUE(has(mesh, p)) << p;  // beta = 31/256
  for (const Vec3f& p : mirrored({0.375F, 0.375F, 0})) EXPECT_TRUE(has(mesh, p)) << p;
}

// 1 - n/(3/(8 beta) + n) of the vertex, since its neighbours add up to 0 (Loop 1987).
TEST(LoopSubdivision, OfAnOctahedronApproachesTheLimit) {
  const grf::Mesh mesh = subdivided(octahedron(), times(Loop, 6));
  for (const Vec3f& p : mirrored({24 / 55.0F, 0, 0})) EXPECT_TRUE(has(mesh, p, 1e-4F)) << p;
}

TEST(LoopSubdivision, CutsPolygonsIntoTrianglesFirst) {
  EXPECT_EQ(subdivided(cube(), Loop).face_count(), 48U);
  EXPECT_EQ(faces_after(cube(), times(Loop, 2)), 192);
}

class Schemes : public testing::TestWithParam<Subdivision> {};
INSTANTIATE_TEST_SUITE_P(All, Schemes, testing::Values(Loop, CatmullClark));

// A bent strip: cubic B-splines are halved by (1, 6, 1)/8 and (4, 4)/8, and go to (1, 4, 1)/6.
TEST_P(Schemes, MakeBoundariesBSplines) {
  const std::vector<Vec3f> rim = {{0, 0, 0}, {1, 0, 3}, {2, 0, -1}, {3, 0, 2}};
  std::vector<Vec3f> positions = rim;
  for (const Vec3f& p : rim) positions.emplace_back(p.x, 5, 0);
  const grf::MeshDraft strip = mesh_of(positions, {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}});
  const grf::Mesh mesh = subdivided(grf::MeshDraft(strip), GetParam());
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_TRUE(has(mesh, (rim[i - 1] + 6.0F * rim[i] + rim[i + 1]) / 8.0F));
    EXPECT_TRUE(has(mesh, (rim[i - 1] + rim[i]) / 2.0F));
    EXPECT_TRUE(has(subdivided(grf::MeshDraft(strip), times(GetParam(), 6)),
                    (rim[i - 1] + 4.0F * rim[i] + rim[i + 1]) / 6.0F, 1e-3F));
  }
  EXPECT_TRUE(has(mesh, (6.0F * rim[0] + rim[1] + positions[4]) / 8.0F)) << "a corner is part of the curve";
}

TEST_P(Schemes, KeepTheSurfacesOfFaces) {
  grf::MeshDraft mesh(sheet(4, true));
  const grf::Mesh result = subdivided(grf::MeshDraft(mesh), times(GetParam(), 2));
  EXPECT_EQ(static_cast<double>(result.face_count()),
            faces_after(grf::MeshDraft(mesh), times(GetParam(), 2)));
  EXPECT_EQ(result.surfaces, mesh.surfaces);
  const std::size_t children = result.face_count() / mesh.face_count();
  for (std::size_t i = 0; i < result.face_count(); ++i) {
    EXPECT_EQ((*result.surface_of_face)[i], mesh.surface_of_face[i / children]);
    for (const std::uint32_t corner : result.face(i)) {
      const float x = result.geometry->positions[corner].x;
      EXPECT_TRUE((*result.surface_of_face)[i] == 0 ? x <= 2 : x >= 2) << i << " " << x;
    }
  }
}

/// A sheet of n x n unit squares in the plane z = 0.
grf::MeshDraft squares(std::uint32_t n) {
  grf::MeshDraft mesh;
  mesh.positions = sheet(n).geometry->positions;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const std::uint32_t a = i / n * (n + 1) + i % n;
    mesh.add_face(std::array{a, a + 1, a + n + 2, a + n + 1}, 0);
  }
  return mesh;
}

/// Gives each face vertices of its own and texture coordinates, of its number and its vertices.
grf::MeshDraft with_uvs(const grf::Mesh& mesh, const std::function<Vec2f(std::size_t, const Vec3f&)>& uv) {
  grf::MeshDraft apart(torn(mesh));
  for (std::size_t face = 0; face < apart.face_count(); ++face) {
    for (const std::uint32_t corner : apart.face(face))
      apart.uvs.set(corner, uv(face, apart.positions[corner]));
  }
  return apart;
}

// Masks reproduce what is linear, and at boundaries do the same to texture coordinates as to positions.
TEST_P(Schemes, CarryTextureCoordinatesAlong) {
  const auto uv = [](const Vec3f& p) { return Vec2f(0.125F * p.x + 0.25F, 0.5F * p.y - 0.25F * p.x); };
  const grf::Mesh result = subdivided(with_uvs(sheet(4), [&](std::size_t, const Vec3f& p) { return uv(p); }),
                                      times(GetParam(), 3));
  ASSERT_EQ(result.geometry->positions.size(),
            subdivided(sheet(4), times(GetParam(), 3)).geometry->positions.size())
      << "without seams";
  EXPECT_FALSE(has(result, {0, 0, 0})) << "corners are rounded";
  for (std::uint32_t i = 0; i < result.geometry->positions.size(); ++i) {
    EXPECT_LT((result.geometry->uvs[i] - uv(result.geometry->positions[i])).length(), 1e-6F);
  }
}

// Of uv = x^2 at whole x, the cubic B-spline of these is x^2 + 1/3.
TEST(CatmullClark, SmoothsTextureCoordinatesInside) {
  const grf::Mesh result =
      subdivided(with_uvs(squares(8), [](std::size_t, const Vec3f& p) { return Vec2f(p.x * p.x, 0); }),
                 times(CatmullClark, 6));
  bool is_found = false;
  for (std::uint32_t i = 0; i < result.geometry->positions.size(); ++i) {
    if ((result.geometry->positions[i] - Vec3f(4, 4, 0)).length() > 1e-5F) continue;
    is_found = true;
    EXPECT_NEAR(result.geometry->uvs[i].x, 16 + 1 / 3.0F, 1e-3F);
  }
  EXPECT_TRUE(is_found);
}

TEST_P(Schemes, KeepSeamsOfTextureCoordinates) {
  // Of two charts, left and right of x = 2; the right one lies elsewhere.
  const auto uv = [](bool is_right, const Vec3f& p) {
    return is_right ? Vec2f(0.5F - 0.125F * p.x, 0.75F + p.y / 16) : Vec2f(p.x / 8, p.y / 8);
  };
  const grf::MeshDraft mesh =
      with_uvs(squares(4), [&](std::size_t face, const Vec3f& p) { return uv(face % 4 >= 2, p); });
  const grf::Mesh result = subdivided(grf::MeshDraft(mesh), times(GetParam(), 2));
  const std::size_t children = result.face_count() / mesh.face_count();
  std::size_t seam_corners = 0;
  for (std::size_t i = 0; i < result.face_count(); ++i) {
    const bool is_right = i / children % 4 >= 2;
    for (const std::uint32_t corner : result.face(i)) {
      const Vec3f& p = result.geometry->positions[corner];
      seam_corners += p.x == 2;
      EXPECT_LT((result.geometry->uvs[corner] - uv(is_right, p)).length(), 1e-6F) << p << is_right;
    }
  }
  EXPECT_GT(seam_corners, 0U);
  EXPECT_EQ(grf::topology_of(*result.geometry).boundary_edges, 16U * 4U) << "no gap opened";
}

// Each face of the cube has a chart of its own: the surface is that of a cube without charts.
TEST(CatmullClark, DoesNotMindWhereTextureCoordinatesAre) {
  const auto uv = [](std::size_t i) {
    return Vec2f(float(i % 4 == 1 || i % 4 == 2) + 2 * float(i / 4), float(i % 4 >= 2));
  };
  grf::MeshDraft mesh(torn(centred_cube()));
  for (std::uint32_t i = 0; i < 24; ++i) mesh.uvs.set(i, uv(i));
  const grf::Mesh result = subdivided(grf::MeshDraft(mesh), CatmullClark);
  ASSERT_EQ(result.face_count(), 24U);
  EXPECT_EQ(result.geometry->positions.size(), 6U * 9U);
  const grf::Mesh twice = subdivided(grf::MeshDraft(mesh), times(CatmullClark, 2));
  const grf::Mesh plain_twice = subdivided(centred_cube(), times(CatmullClark, 2));
  for (std::size_t i = 0; i < 96; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(twice.geometry->positions[twice.face(i)[k]],
                plain_twice.geometry->positions[plain_twice.face(i)[k]]);
    }
  }
  for (std::size_t i = 0; i < 24; ++i) {
    const std::size_t next = i / 4 * 4 + (i + 1) % 4;
    EXPECT_EQ(result.geometry->uvs[result.face(i)[0]], uv(i));
    EXPECT_EQ(result.geometry->uvs[result.face(i)[1]], (uv(i) + uv(next)) / 2.0F);
    EXPECT_EQ(result.geometry->uvs[result.face(i)[2]], (uv(i / 4 * 4) + uv(i / 4 * 4 + 2)) / 2.0F);
  }
}

TEST_P(Schemes, GiveAllVerticesWhatSomeHave) {
  grf::MeshDraft mesh = octahedron();
  mesh.colours.set(0, grf::Colour(0.25F));
  mesh.uvs.set(0, Vec2f(4, 4));
  const grf::Mesh result = subdivided(grf::MeshDraft(mesh), times(GetParam(), 2));
  float least = 1;
  float least_uv = 4;
  for (std::size_t i = 0; i < result.geometry->positions.size(); ++i) {
    ASSERT_TRUE(result.geometry->colours.has(i));
    ASSERT_TRUE(result.geometry->uvs.has(i));
    least_uv = std::min(least_uv, result.geometry->uvs[i].x);
    least = std::min(least, result.geometry->colours[i].x);
    EXPECT_TRUE(result.geometry->colours[i].x >= 0.25F && result.geometry->colours[i].x <= 1);
  }
  EXPECT_LT(least, 0.8F);
  EXPECT_EQ(least_uv, 0) << "on the other side";
}

TEST_P(Schemes, GiveNewNormalsWhereThereWereSome) {
  EXPECT_TRUE(subdivided(octahedron(), GetParam()).geometry->normals.empty());
  grf::MeshDraft mesh = octahedron();
  mesh.normals.set(0, Vec3f(0, 1, 0));
  const grf::Mesh result = subdivided(grf::MeshDraft(mesh), times(GetParam(), 2));
  for (std::size_t i = 0; i < result.geometry->positions.size(); ++i) {
    ASSERT_TRUE(result.geometry->normals.has(i));
    EXPECT_NEAR(result.geometry->normals[i].length(), 1, 1e-6F);
    const Vec3f& p = result.geometry->positions[i];
    EXPECT_GT(result.geometry->normals[i].dot(p.normalized()), 0.9F);
    const bool is_on_axis = std::abs(p.y) + std::abs(p.z) < 1e-6F;
    EXPECT_TRUE(!is_on_axis || (result.geometry->normals[i] - p.normalized()).length() < 1e-5F) << p;
  }
}

// Three pages of two sheets each along a bent spine.
TEST(CatmullClark, TreatsEdgesOfThreeFacesLikeBoundaries) {
  std::vector<Vec3f> positions = {{0, 0, 0}, {0, 0.8F, 1}, {0, 0, 2}};
  std::vector<std::vector<std::uint32_t>> faces;
  for (const Vec3f& page : {Vec3f(5, 0, 0), Vec3f(-5, 3, 0), Vec3f(-5, -3, 0)}) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t i = 0; i < 3; ++i) positions.emplace_back(positions[i] + page);
    for (std::uint32_t i = 0; i < 2; ++i) faces.push_back({i, i + 1, first + i + 1, first + i});
  }
  const grf::Mesh mesh = subdivided(mesh_of(positions, faces), CatmullClark);
  EXPECT_TRUE(has(mesh, {0, 0.6F, 1})) << "(1, 6, 1)/8";
  EXPECT_TRUE(has(mesh, {0, 0.4F, 0.5F})) << "(4, 4)/8";
  EXPECT_TRUE(has(mesh, {0, 0, 0})) << "where more than two sharp edges meet";
  EXPECT_EQ(grf::topology_of(*mesh.geometry).nonmanifold_edges, 4U);
}

// The first two pages share texture coordinates, and so do the others.
TEST(CatmullClark, HasASeamOfTextureCoordinatesAtAnEdgeOfFourFaces) {
  grf::MeshDraft mesh = mesh_of({{0, 0, 0}, {0, 0, 2}}, {});
  for (const Vec3f& page : {Vec3f(5, 0, 0), Vec3f(-5, 0, 0), Vec3f(0, 5, 0), Vec3f(0, -5, 0)}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i < 2; ++i) mesh.positions.emplace_back(mesh.positions[i] + page);
    mesh.add_face(std::array{0U, 1U, first + 1, first}, 0);
  }
  const auto uv = [](std::size_t face, const Vec3f& p) {
    return Vec2f(std::abs(p.x) + 10 * float(face / 2), p.z);
  };
  const grf::Mesh result = subdivided(with_uvs(grf::MeshDraft(mesh), uv), CatmullClark);
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < result.geometry->positions.size(); ++i) {
    if (result.geometry->positions[i] != Vec3f(0, 0, 1)) continue;
    ++found;
    EXPECT_TRUE(result.geometry->uvs[i] == Vec2f(0, 1) || result.geometry->uvs[i] == Vec2f(10, 1));
  }
  EXPECT_EQ(found, 2U);
}

TEST(CatmullClark, KeepsACornerTwice) {
  const grf::Mesh mesh = subdivided(mesh_of({{1, 1, 1}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 1, 2}}), CatmullClark);
  ASSERT_EQ(mesh.face_count(), 4U);
  EXPECT_EQ(mesh.face(1)[0], mesh.face(1)[1]);
  EXPECT_EQ(mesh.face(1)[0], mesh.face(2)[0]);
}

TEST_P(Schemes, KeepNameAndComments) {
  grf::MeshDraft mesh = octahedron();
  mesh.name = "gem";
  mesh.comments.end = {"# the end"};
  EXPECT_EQ(subdivided(grf::MeshDraft(mesh), GetParam()).name, "gem");
  EXPECT_EQ(subdivided(grf::MeshDraft(mesh), GetParam()).comments, mesh.comments);
}

TEST_P(Schemes, KeepVerticesWherePartsOfASurfaceMeet) {
  grf::MeshDraft mesh = octahedron();
  for (std::size_t i = 0; i < 6; ++i) mesh.positions.push_back(mesh.positions[i] / 2.0F + Vec3f(1.5F, 0, 0));
  const grf::MeshDraft one = octahedron();
  for (std::size_t face = 0; face < one.face_count(); ++face) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t corner : one.face(face)) corners.push_back(corner + 6);
    mesh.add_face(corners, 0);
  }
  EXPECT_TRUE(has(subdivided(grf::MeshDraft(mesh), times(GetParam(), 3)), {1, 0, 0}));
  EXPECT_FALSE(has(subdivided(grf::MeshDraft(mesh), times(GetParam(), 3)), {-1, 0, 0}, 0.1F));
}

// Two squares that meet in one corner, each with texture coordinates of its own.
TEST_P(Schemes, KeepTextureCoordinatesWherePartsOfASurfaceMeet) {
  const grf::MeshDraft mesh =
      with_uvs(mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}},
                       {{0, 1, 2, 3}, {0, 4, 5, 6}}),
               [](std::size_t face, const Vec3f& p) { return Vec2f(p.x + 5 * float(face), p.y); });
  const grf::Mesh result = subdivided(grf::MeshDraft(mesh), GetParam());
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < result.geometry->positions.size(); ++i) {
    if (result.geometry->positions[i] != Vec3f(0)) continue;
    ++found;
    EXPECT_TRUE(result.geometry->uvs[i] == Vec2f(0, 0) || result.geometry->uvs[i] == Vec2f(5, 0));
  }
  EXPECT_EQ(found, 2U);
}

TEST_P(Schemes, DoNothingInNoLevels) {
  EXPECT_EQ(subdivided(sheet(3), times(GetParam(), 0)), sheet(3));
  EXPECT_EQ(faces_after(sheet(3), times(GetParam(), 0)), 18);
}

TEST_P(Schemes, LeaveOutIrradiance) {
  grf::MeshDraft mesh(torn(octahedron()));
  mesh.irradiance.set(0, grf::Colour(1));
  const grf::Mesh result = subdivided(grf::MeshDraft(mesh), GetParam());
  EXPECT_TRUE(result.irradiance->empty());
  EXPECT_EQ(result.geometry->positions.size(),
            subdivided(octahedron(), GetParam()).geometry->positions.size());
}

/// Faces of a few vertices, which can be of any kind: with a vertex twice, on each other, at one place.
grf::MeshDraft any_tangle() {
  grf::MeshDraft mesh;
  const auto vertices = *rc::gen::inRange<std::uint32_t>(3, 9);
  const bool has_uvs = *rc::gen::arbitrary<bool>();
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const auto coordinate = [] { return static_cast<float>(*rc::gen::inRange(0, 3)); };
    mesh.positions.emplace_back(coordinate(), coordinate(), coordinate());
    if (has_uvs && *rc::gen::arbitrary<bool>()) mesh.uvs.set(i, Vec2f(coordinate(), coordinate()));
  }
  mesh.surfaces.emplace_back();
  mesh.surfaces.back().colour = grf::Colour(1, 0, 0);
  const int faces = *rc::gen::inRange(1, 8);
  for (int i = 0; i < faces; ++i) {
    std::vector<std::uint32_t> corners;
    const int count = *rc::gen::inRange(3, 6);
    for (int k = 0; k < count; ++k) corners.push_back(*rc::gen::inRange<std::uint32_t>(0, vertices));
    mesh.add_face(corners, static_cast<std::uint32_t>(i % 2));
  }
  return mesh;
}

// All masks are convex: nothing gets out of the box, be the mesh as it may.
RC_GTEST_PROP(SubdivisionProperty, AnyTangleStaysInItsBox, ()) {
  const grf::MeshDraft mesh = any_tangle();
  const Subdivision subdivision = times(*rc::gen::element(Loop, CatmullClark), *rc::gen::inRange(1, 4));
  grf::Box3f box;
  for (const Vec3f& position : mesh.positions) box.extendBy(position);
  const grf::Mesh result = subdivided(grf::MeshDraft(mesh), subdivision);
  RC_ASSERT(static_cast<double>(result.face_count()) == faces_after(grf::MeshDraft(mesh), subdivision));
  for (const Vec3f& p : result.geometry->positions) {
    for (int i = 0; i < 3; ++i) RC_ASSERT(p[i] >= box.min[i] - 1e-5F && p[i] <= box.max[i] + 1e-5F);
  }
  for (std::size_t i = 0; i < result.geometry->positions.size(); ++i) {
    RC_ASSERT(result.geometry->uvs.has(i) == !mesh.uvs.empty());
    if (!mesh.uvs.empty()) {
      const Vec2f& uv = result.geometry->uvs[i];
      RC_ASSERT(uv.x >= -1e-5F && uv.x <= 2 + 1e-5F && uv.y >= -1e-5F && uv.y <= 2 + 1e-5F);
    }
  }
}

}  // namespace
}  // namespace convert
