#include "converters/mesh_operations/orient.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

namespace convert {
namespace {

using grf::Vec3d;
using grf::Vec3f;

/// A cube about this centre whose faces point outward, but for those of which the bit is set.
void add_cube(grf::MeshDraft& mesh, const Vec3f& centre, unsigned reversed, bool is_open = false) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.push_back(
        centre + Vec3f(float(corner & 1), float(corner >> 1 & 1), float(corner >> 2 & 1)) - Vec3f(0.5F));
  }
  const std::array<std::array<std::uint32_t, 4>, 6> faces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (std::size_t i = 0; i < (is_open ? 5 : 6); ++i) {
    std::array<std::uint32_t, 4> face = faces[i];
    for (std::uint32_t& corner : face) corner += first;
    if ((reversed >> i & 1U) != 0) std::swap(face[1], face[3]);
    mesh.add_face(face, 0);
  }
}

TEST(Orientation, FindsTheFacesThatPointInward) {
  for (unsigned reversed = 0; reversed < 64; ++reversed) {
    grf::MeshDraft draft;
    add_cube(draft, Vec3f(3, -2, 5), reversed);
    const std::vector<bool> found = inward_faces(grf::Mesh(std::move(draft)).geometry);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_EQ(found[i], (reversed >> i & 1U) != 0) << reversed << ": " << i;
  }
}

TEST(Orientation, OrientsEachPartAndOpenOnesToo) {
  grf::MeshDraft draft;
  add_cube(draft, Vec3f(0), 63);
  add_cube(draft, Vec3f(9, 0, 0), 0);
  add_cube(draft, Vec3f(0, 9, 0), 0b11110, true);
  const std::vector<bool> found = inward_faces(grf::Mesh(std::move(draft)).geometry);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(found[i]) << i;
  for (std::size_t i = 6; i < 12; ++i) EXPECT_FALSE(found[i]) << i;
  EXPECT_FALSE(found[12]);
  for (std::size_t i = 13; i < 17; ++i) EXPECT_TRUE(found[i]) << i;
}

TEST(Orientation, LeavesMostOfAFlatPart) {
  grf::MeshDraft draft;
  draft.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 0, 0}, {3, 1, 0}};
  draft.add_face(std::array{0U, 1U, 4U, 3U}, 0);
  draft.add_face(std::array{1U, 4U, 5U, 2U}, 0);  // the other way
  draft.add_face(std::array{2U, 6U, 7U, 5U}, 0);
  EXPECT_EQ(inward_faces(grf::Mesh(std::move(draft)).geometry), (std::vector<bool>{false, true, false}));
}

TEST(Orientation, TurnsNormalsWithTheirFaces) {
  grf::MeshDraft draft;
  add_cube(draft, Vec3f(0), 63);
  for (std::uint32_t i = 0; i < 8; ++i)
    draft.normals.set(i, -draft.positions[i].normalized());  // inward, as its faces
  const grf::Mesh outward = oriented_outward(grf::Mesh(std::move(draft)));
  for (std::uint32_t i = 0; i < 8; ++i) {
    EXPECT_GT(outward.geometry->normals[i].dot(outward.geometry->positions[i]), 0);
  }
  for (std::size_t face = 0; face < 6; ++face) {
    const Vec3d normal = grf::doubled_area_vector(*outward.geometry, face, {});
    EXPECT_GT(normal.dot(Vec3d(outward.geometry->positions[outward.face(face)[0]])), 0);
  }
  // Right normals stay: only the winding was wrong.
  grf::MeshDraft wound;
  add_cube(wound, Vec3f(0), 63);
  for (std::uint32_t i = 0; i < 8; ++i) wound.normals.set(i, wound.positions[i].normalized());
  const grf::Mesh right = oriented_outward(grf::Mesh(std::move(wound)));
  EXPECT_GT(right.geometry->normals[0].dot(right.geometry->positions[0]), 0);
}

}  // namespace
}  // namespace convert
