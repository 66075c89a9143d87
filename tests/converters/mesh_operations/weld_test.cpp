#include "converters/mesh_operations/weld.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/converters/mesh_operations/meshes.h"

namespace convert {
namespace {

using testing::ElementsAre;

TEST(Weld, MakesOneVertexOfThoseAtOnePlace) {
  const Welded welded = weld(torn(cube()), 0);
  EXPECT_EQ(welded.mesh.geometry->positions.size(), 8U);
  EXPECT_EQ(welded.mesh.face_count(), 6U);
  EXPECT_EQ(welded.merged_vertices, 16U);
  EXPECT_EQ(welded.collapsed_faces, 0U);
}

TEST(Weld, MergesWhatIsNearerAndNothingElse) {
  grf::MeshDraft mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0.09F, 0}, {0, 1.1F, 0}, {1, 1, 0}};
  mesh.add_face(std::array{0U, 1U, 2U}, 0);
  mesh.add_face(std::array{3U, 5U, 4U}, 0);
  const Welded welded = weld(grf::MeshDraft(mesh), 0.1);
  EXPECT_EQ(welded.merged_vertices, 1U) << "the distance itself is not nearer";
  EXPECT_THAT(welded.mesh.geometry->corners, ElementsAre(0, 1, 2, 1, 4, 3));
  EXPECT_EQ(welded.mesh.geometry->positions[1], grf::Vec3f(1, 0, 0)) << "the first stays where it was";
}

TEST(Weld, LeavesOutFacesThatCollapseAndCountsThem) {
  grf::MeshDraft mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.01F, 0, 0}};
  mesh.surfaces.emplace_back();
  mesh.surfaces[1].emission = grf::Colour(1);
  mesh.add_face(std::array{0U, 4U, 2U}, 0);
  mesh.add_face(std::array{0U, 4U, 1U, 2U}, 1);
  mesh.add_face(std::array{0U, 3U, 4U, 3U}, 0);
  const Welded welded = weld(grf::MeshDraft(mesh), 0.1);
  EXPECT_EQ(welded.collapsed_faces, 2U);
  ASSERT_EQ(welded.mesh.face_count(), 1U);
  EXPECT_EQ(welded.mesh.face(0).size(), 3U) << "a corner went";
  EXPECT_TRUE(welded.mesh.surface(0).emission.has_value());
}

TEST(Weld, KeepsSeamsAtOnePlace) {
  grf::MeshDraft mesh(torn(sheet(1)));
  mesh.positions[3].x += 0.01F;
  for (std::size_t i = 0; i < 6; ++i) mesh.uvs.set(i, grf::Vec2f(i < 3 ? 0.0F : 1.0F, 0));
  const Welded welded = weld(grf::MeshDraft(mesh), 0.1);
  EXPECT_EQ(welded.mesh.geometry->positions.size(), 6U) << "both sides have coordinates of their own";
  EXPECT_EQ(welded.mesh.geometry->positions[3], welded.mesh.geometry->positions[0]);
  EXPECT_EQ(welded.mesh.geometry->uvs, mesh.uvs);
}

TEST(Weld, KeepsIrradianceApart) {
  grf::MeshDraft mesh(torn(sheet(1)));
  mesh.irradiance.set(0, grf::Colour(1));
  EXPECT_EQ(weld(grf::MeshDraft(mesh), 0).mesh.geometry->positions.size(), 5U);
}

TEST(Weld, KeepsFacesOfNonManifoldEdges) {
  grf::MeshDraft draft;
  draft.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  for (const std::uint32_t tip : {2U, 3U, 4U, 2U}) draft.add_face(std::array{0U, 1U, tip}, 0);
  const grf::Mesh mesh = std::move(draft);
  EXPECT_EQ(weld(torn(mesh), 0.01).mesh, mesh);
}

RC_GTEST_PROP(Weld, LeavesNoTwoPlacesNearerAndMovesNoneFurther, ()) {
  const double distance = *rc::gen::inRange(1, 40) / 20.0;
  const auto points = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::array<int, 3>>>(
      rc::gen::container<std::array<int, 3>>(rc::gen::inRange(-30, 30))));
  grf::MeshDraft mesh;
  for (const auto& [x, y, z] : points) {
    mesh.positions.emplace_back(float(x) / 10, float(y) / 10, float(z) / 10);
  }
  // A fan in which each vertex is used, so that each is there afterwards.
  for (std::uint32_t i = 0; i + 2 < points.size(); ++i) mesh.add_face(std::array{i, i + 1, i + 2}, 0);
  const Welded welded = weld(grf::MeshDraft(mesh), distance);
  RC_ASSERT(welded.mesh.face_count() + welded.collapsed_faces == mesh.face_count());
  for (const grf::Vec3f& a : welded.mesh.geometry->positions) {
    for (const grf::Vec3f& b : welded.mesh.geometry->positions) {
      RC_ASSERT(&a == &b || (grf::Vec3d(a) - grf::Vec3d(b)).length() >= distance * (1 - 1e-12));
    }
  }
  std::size_t kept = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    if (kept == welded.mesh.face_count()) break;
    const auto before = mesh.face(face);
    const auto after = welded.mesh.face(kept);
    const bool is_this = std::equal(before.begin(), before.end(), after.begin(), [&](auto a, auto b) {
      return (grf::Vec3d(mesh.positions[a]) - grf::Vec3d(welded.mesh.geometry->positions[b])).length() <
             distance;
    });
    if (is_this) ++kept;
  }
  RC_ASSERT(kept == welded.mesh.face_count());
}

}  // namespace
}  // namespace convert
