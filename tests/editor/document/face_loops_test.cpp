#include "editor/document/face_loops.h"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace editor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using FaceCorners = std::vector<std::vector<std::uint32_t>>;

/// A scene of one mesh. Only the topology matters, so vertices are at arbitrary, distinct positions.
SceneObjects objects_with_faces(const FaceCorners& faces) {
  grf::MeshDraft draft;
  std::uint32_t vertices = 0;
  for (const auto& face : faces) {
    draft.add_face(face, 0);
    vertices = std::max(vertices, *std::ranges::max_element(face) + 1);
  }
  for (std::uint32_t i = 0; i < vertices; ++i)
    draft.positions.emplace_back(static_cast<float>(i), static_cast<float>(i * i % 17), 0.0F);
  grf::Scene scene;
  scene.contents.blocks.emplace_back().content = grf::Shared<grf::Mesh>(grf::Mesh(std::move(draft)));
  return objects_of(scene, "");
}

/// Squares of `columns` times `rows`, row by row. Corner 0 begins the lower edge of a face, 1 the right one.
FaceCorners grid_faces(std::uint32_t columns, std::uint32_t rows) {
  FaceCorners faces;
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t first = y * (columns + 1) + x;
      faces.push_back({first, first + 1, first + columns + 2, first + columns + 1});
    }
  }
  return faces;
}

/// A torus of `around` times `across` quadrilaterals; face i * across + k.
FaceCorners torus_faces(std::uint32_t around, std::uint32_t across) {
  FaceCorners faces;
  const auto vertex = [=](std::uint32_t i, std::uint32_t k) { return i % around * across + k % across; };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k)
      faces.push_back({vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1), vertex(i, k + 1)});
  }
  return faces;
}

std::vector<std::uint32_t> faces_of(const FaceSelection& selection) {
  std::vector<std::uint32_t> result;
  selection.for_each_face(0, [&](std::size_t face) { result.push_back(static_cast<std::uint32_t>(face)); });
  return result;
}

TEST(FaceLoops, CrossAGridFromBorderToBorder) {
  const SceneObjects objects = objects_with_faces(grid_faces(4, 3));
  for (const std::uint32_t corner : {0U, 2U}) {
    EXPECT_THAT(faces_of(face_loop(objects, {0, 6}, corner)), ElementsAre(2, 6, 10));
    EXPECT_THAT(faces_of(crossing_face_loop(objects, {0, 6}, corner)), ElementsAre(4, 5, 6, 7));
  }
  for (const std::uint32_t corner : {1U, 3U}) {
    EXPECT_THAT(faces_of(face_loop(objects, {0, 6}, corner)), ElementsAre(4, 5, 6, 7));
    EXPECT_THAT(faces_of(crossing_face_loop(objects, {0, 6}, corner)), ElementsAre(2, 6, 10));
  }
}

TEST(FaceLoops, StartAtTheBorder) {
  const SceneObjects objects = objects_with_faces(grid_faces(4, 3));
  EXPECT_THAT(faces_of(face_loop(objects, {0, 1}, 0)), ElementsAre(1, 5, 9));
  EXPECT_THAT(faces_of(face_loop(objects, {0, 7}, 1)), ElementsAre(4, 5, 6, 7));
}

TEST(FaceLoops, CloseOnATorus) {
  const SceneObjects objects = objects_with_faces(torus_faces(6, 4));
  for (std::uint32_t face = 0; face < 24; ++face) {
    // Across the edge from one ring to the next: around the tube, which has 4 faces.
    EXPECT_THAT(faces_of(face_loop(objects, {0, face}, 0)),
                ElementsAre(face / 4 * 4, face / 4 * 4 + 1, face / 4 * 4 + 2, face / 4 * 4 + 3));
    const std::uint32_t k = face % 4;
    EXPECT_THAT(faces_of(crossing_face_loop(objects, {0, face}, 0)),
                ElementsAre(k, k + 4, k + 8, k + 12, k + 16, k + 20));
  }
}

TEST(FaceLoops, GoAroundACube) {
  const SceneObjects objects = objects_with_faces(
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  // Between the faces 0 and 4 is the edge 0-2; the loop leaves out the two faces that it goes around.
  EXPECT_THAT(faces_of(face_loop(objects, {0, 0}, 0)), ElementsAre(0, 1, 4, 5));
  EXPECT_THAT(faces_of(crossing_face_loop(objects, {0, 0}, 0)), ElementsAre(0, 1, 2, 3));
}

TEST(FaceLoops, EndAtTriangles) {
  // A prism: two triangles and three quadrilaterals.
  const SceneObjects objects =
      objects_with_faces({{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
  EXPECT_THAT(faces_of(face_loop(objects, {0, 2}, 1)), ElementsAre(2, 3, 4)) << "around";
  EXPECT_THAT(faces_of(face_loop(objects, {0, 2}, 0)), ElementsAre(2)) << "between the triangles";
  EXPECT_THAT(faces_of(face_loop(objects, {0, 0}, 0)), ElementsAre(4)) << "from a triangle: beyond its edge";
}

TEST(FaceLoops, AreEmptyAmongTriangles) {
  const SceneObjects objects = objects_with_faces({{0, 1, 2}, {0, 2, 3}});
  EXPECT_THAT(faces_of(face_loop(objects, {0, 0}, 2)), IsEmpty());
}

TEST(FaceLoops, EndAtEdgesOfThreeFaces) {
  // A row of three squares, and a fourth that stands on the edge 2-5 between the second and the third.
  FaceCorners faces = grid_faces(3, 1);
  faces.push_back({2, 6, 8, 9});
  const SceneObjects objects = objects_with_faces(faces);
  EXPECT_THAT(faces_of(face_loop(objects, {0, 0}, 1)), ElementsAre(0, 1));
  EXPECT_THAT(faces_of(face_loop(objects, {0, 1}, 1)), ElementsAre(0, 1)) << "the side of the clicked face";
  EXPECT_THAT(faces_of(face_loop(objects, {0, 2}, 3)), ElementsAre(2));
}

TEST(FaceLoops, CrossSeams) {
  // Two squares whose common edge has two vertices at each end, as exporters write at a seam.
  grf::MeshDraft draft;
  for (const float x : {0.0F, 1.0F, 1.0F, 2.0F}) {
    for (const float y : {0.0F, 1.0F}) draft.positions.emplace_back(x, y, 0.0F);
  }
  draft.add_face(std::vector<std::uint32_t>{0, 2, 3, 1}, 0);
  draft.add_face(std::vector<std::uint32_t>{4, 6, 7, 5}, 0);
  grf::Scene scene;
  scene.contents.blocks.emplace_back().content = grf::Shared<grf::Mesh>(grf::Mesh(std::move(draft)));
  EXPECT_THAT(faces_of(face_loop(objects_of(scene, ""), {0, 0}, 1)), ElementsAre(0, 1));
}

}  // namespace
}  // namespace editor
