// Expected coordinates are worked out by hand from the definitions in texture_coordinates.h.
#include "editor/document/texture_coordinates.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using grf::Vec2d;
using grf::Vec2f;
using grf::Vec3d;

/// A box on the corners of a cube of side 2 from (1, 1, 1); faces -z, +z, -y, +y, -x, +x.
const std::string SideTwo = R"(begin mesh
  begin vertexs
    (1, 1, 1) (3, 1, 1) (1, 3, 1) (3, 3, 1) (1, 1, 3) (3, 1, 3) (1, 3, 3) (3, 3, 3)
  end vertexs
  begin faces
    (0, 2, 3, 1) (4, 5, 7, 6) (0, 1, 5, 4) (2, 6, 7, 3) (0, 4, 6, 2) (1, 3, 7, 5)
  end faces
end mesh
)";

/// A square of side 1 that faces +z, seen upright.
const std::string Square = R"(begin mesh
  begin vertexs
    (0, 0, 0) (1, 0, 0) (1, 1, 0) (0, 1, 0)
  end vertexs
  begin faces
    (0, 1, 2, 3)
  end faces
end mesh
)";

class TextureCoordinates : public testing::Test {
 protected:
  void take(grf::Scene scene) {
    scene_ = std::move(scene);
    objects_ = objects_of(scene_, {});
    selection_ = FaceSelection(objects_);
    selection_.select_all();
  }
  void open(const std::string& text) { take(scene_of(text)); }
  void select_only(std::uint32_t face) {
    selection_.clear();
    selection_.set({0, face});
  }
  SelectedFaces selected() const { return {scene_, objects_, selection_}; }
  void project(UvProjection projection) {
    const FaceSelection kept = selection_;
    take(with_projected_uvs(selected(), projection));
    selection_ = kept;
  }
  const grf::Mesh& mesh(std::size_t number = 0) const { return *objects_.meshes[number].mesh; }
  Vec2f uv(std::size_t face, std::size_t corner, std::size_t number = 0) const {
    return mesh(number).geometry->uvs[mesh(number).face(face)[corner]];
  }
  /// The coordinates of a face's corner at this position.
  Vec2f uv_at(std::size_t face, const grf::Vec3f& position) const {
    for (const std::uint32_t corner : mesh().face(face)) {
      if (mesh().geometry->positions[corner] == position) return mesh().geometry->uvs[corner];
    }
    throw std::runtime_error("the face has no such corner");
  }

  grf::Scene scene_;
  SceneObjects objects_;
  FaceSelection selection_;
};

TEST_F(TextureCoordinates, OfABoxAreTheWholeImageOnEachSideOfACube) {
  open(SideTwo);
  project(UvProjection::Box);
  // From each side the lower left corner and the one to the right of it; y is up, and from above -z.
  EXPECT_EQ(uv_at(1, {1, 1, 3}), Vec2f(0, 0));
  EXPECT_EQ(uv_at(1, {3, 1, 3}), Vec2f(1, 0));
  EXPECT_EQ(uv_at(1, {3, 3, 3}), Vec2f(1, 1));
  EXPECT_EQ(uv_at(0, {3, 1, 1}), Vec2f(0, 0));
  EXPECT_EQ(uv_at(0, {1, 1, 1}), Vec2f(1, 0));
  EXPECT_EQ(uv_at(5, {3, 1, 3}), Vec2f(0, 0));
  EXPECT_EQ(uv_at(5, {3, 1, 1}), Vec2f(1, 0));
  EXPECT_EQ(uv_at(4, {1, 1, 1}), Vec2f(0, 0));
  EXPECT_EQ(uv_at(4, {1, 1, 3}), Vec2f(1, 0));
  EXPECT_EQ(uv_at(3, {1, 3, 3}), Vec2f(0, 0));
  EXPECT_EQ(uv_at(3, {3, 3, 1}), Vec2f(1, 1));
  EXPECT_EQ(uv_at(2, {1, 1, 1}), Vec2f(0, 0));
  EXPECT_EQ(uv_at(2, {3, 1, 3}), Vec2f(1, 1));
  // Another projection needs no seams, and leaves none.
  project(UvProjection::AlongZ);
  EXPECT_EQ(mesh().geometry->positions.size(), 8U);
  EXPECT_EQ(uv_at(0, {3, 1, 1}), Vec2f(1, 0));
}

TEST_F(TextureCoordinates, OfAPlaneAreSeenAlongItsNormal) {
  // 5 wide along (3, 0, -4) and 2.5 high.
  open(
      "begin mesh begin vertexs (0,0,0) (3,0,-4) (3,2.5,-4) (0,2.5,0) end vertexs begin faces (0,1,2,3) end "
      "faces end mesh");
  project(UvProjection::AlongNormal);
  const Vec2f expected[] = {{0, 0}, {1, 0}, {1, 0.5F}, {0, 0.5F}};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((uv(0, i) - expected[i]).length(), 1e-6F) << i;
  project(UvProjection::AlongX);  // 4 wide
  EXPECT_LT((uv(0, 2) - Vec2f(1, 0.625F)).length(), 1e-6F);
  project(UvProjection::AlongY);  // up is -z: no height
  EXPECT_LT((uv(0, 2) - Vec2f(0.75F, 1)).length(), 1e-6F);
}

TEST_F(TextureCoordinates, OfClosedMeshesWithoutAMeanNormalAreSeenFromTheFront) {
  open(SideTwo);
  project(UvProjection::AlongNormal);
  EXPECT_EQ(uv_at(5, {3, 3, 1}), Vec2f(1, 1));
  EXPECT_EQ(uv_at(5, {3, 3, 3}), Vec2f(1, 1));
}

// Two faces at 90 degrees have a mean cosine of 0.71 to their mean normal, two at 30 degrees one of 0.97.
TEST_F(TextureCoordinates, AreProjectedFromABoxOntoFacesThatAreNotFlat) {
  open(SideTwo);
  EXPECT_EQ(suitable_projection(selected()), UvProjection::Box);
  select_only(1);
  EXPECT_EQ(suitable_projection(selected()), UvProjection::AlongNormal);
  selection_.set({0, 3});
  EXPECT_EQ(suitable_projection(selected()), UvProjection::Box);
  open(
      "begin mesh begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) (0,1.866,-0.5) (1,1.866,-0.5) end vertexs "
      "begin faces (0,1,2,3) (3,2,5,4) end faces end mesh");
  EXPECT_EQ(suitable_projection(selected()), UvProjection::AlongNormal);
}

TEST_F(TextureCoordinates, AreProjectedInWorldSpace) {
  open("transform scale (4, 1, 1) begin\n" + Square + "end\n");
  project(UvProjection::AlongZ);
  EXPECT_EQ(uv(0, 2), Vec2f(1, 0.25F)) << "4 wide and 1 high";
  // Two meshes are seen together.
  open(Square + "transform translation (1, 0, 0) begin\n" + Square + "end\n");
  project(UvProjection::AlongZ);
  EXPECT_EQ(uv(0, 2, 0), Vec2f(0.5F, 0.5F));
  EXPECT_EQ(uv(0, 0, 1), Vec2f(0.5F, 0));
}

TEST_F(TextureCoordinates, OfASphereHaveNoFaceAcrossTheImage) {
  constexpr int Columns = 8, Rows = 4;
  std::ostringstream text;
  text << "begin mesh begin vertexs (5,1,0) (5,3,0)\n";
  for (int row = 1; row < Rows; ++row) {
    const double latitude = std::numbers::pi * (static_cast<double>(row) / Rows - 0.5);
    for (int column = 0; column < Columns; ++column) {
      const double turn = 2 * std::numbers::pi * (static_cast<double>(column) / Columns - 0.5);
      text << "(" << 5 + std::cos(latitude) * std::sin(turn) << "," << 2 + std::sin(latitude) << ","
           << std::cos(latitude) * std::cos(turn) << ")\n";
    }
  }
  text << "end vertexs begin faces\n";
  const auto vertex = [](int row, int column) { return 2 + (row - 1) * Columns + column % Columns; };
  for (int column = 0; column < Columns; ++column) {
    text << "(0," << vertex(1, column + 1) << "," << vertex(1, column) << ")\n"
         << "(" << vertex(3, column) << "," << vertex(3, column + 1) << ",1)\n";
    for (int row = 1; row < Rows - 1; ++row) {
      text << "(" << vertex(row, column) << "," << vertex(row, column + 1) << ","
           << vertex(row + 1, column + 1) << "," << vertex(row + 1, column) << ")\n";
    }
  }
  text << "end faces end mesh";
  open(text.str());
  project(UvProjection::Sphere);
  for (int face = 0; face < Columns * Rows; ++face) {
    SCOPED_TRACE(face);
    const int column = face / Rows;
    const double left = static_cast<double>(column) / Columns;
    const int kind = face % Rows;
    const double bottom = kind == 0 ? 0 : kind == 1 ? 0.75 : kind == 2 ? 0.25 : 0.5;
    for (std::size_t i = 0; i < mesh().face(face).size(); ++i) {
      const bool is_pole = kind == 0 ? i == 0 : kind == 1 && i == 2;
      const bool is_right = kind == 0 ? i == 1 : i == 1 || (kind > 1 && i == 2);
      const bool is_top = kind == 0 ? i > 0 : i >= 2;
      EXPECT_NEAR(uv(face, i).x, left + (is_pole ? 0.5 : is_right ? 1 : 0) / Columns, 1e-5);
      EXPECT_NEAR(uv(face, i).y, bottom + (is_top ? 0.25 : 0), 1e-5);
    }
  }
}

TEST_F(TextureCoordinates, OfACylinderGoAroundIt) {
  open(SideTwo);
  project(UvProjection::Cylinder);
  EXPECT_LT((uv_at(1, {1, 1, 3}) - Vec2f(0.375F, 0)).length(), 1e-6F);
  EXPECT_LT((uv_at(1, {3, 3, 3}) - Vec2f(0.625F, 1)).length(), 1e-6F);
  EXPECT_LT((uv_at(5, {3, 1, 1}) - Vec2f(0.875F, 0)).length(), 1e-6F);
  const float left = uv_at(0, {3, 1, 1}).x;
  EXPECT_NEAR(left - std::floor(left), 0.875F, 1e-6F);
  EXPECT_NEAR(uv_at(0, {1, 1, 1}).x - left, 0.25F, 1e-6F) << "over the seam";
  EXPECT_EQ(uv_at(3, {1, 3, 3}), Vec2f(0, 0)) << "a cap";
  EXPECT_EQ(uv_at(3, {3, 3, 1}), Vec2f(1, 1));
}

TEST_F(TextureCoordinates, OfOtherFacesStay) {
  open(SideTwo);
  select_only(1);
  project(UvProjection::AlongZ);
  EXPECT_EQ(uv_at(1, {3, 3, 3}), Vec2f(1, 1));
  EXPECT_EQ(mesh().geometry->positions.size(), 12U) << "its corners are split";
  for (const std::size_t face : {0, 2, 3, 4, 5}) {
    for (const std::uint32_t corner : mesh().face(face)) EXPECT_FALSE(mesh().geometry->uvs.has(corner));
  }
  select_only(5);
  project(UvProjection::AlongX);
  EXPECT_EQ(uv_at(1, {3, 3, 3}), Vec2f(1, 1));
  EXPECT_EQ(uv_at(5, {3, 3, 3}), Vec2f(0, 1));
  UvTransform move;
  move.offset = {0.5, 0.25};
  take(with_transformed_uvs(selected(), move));
  EXPECT_EQ(uv_at(5, {3, 3, 3}), Vec2f(0.5F, 1.25F));
  EXPECT_EQ(uv_at(1, {3, 3, 3}), Vec2f(1, 1));
}

TEST_F(TextureCoordinates, AreTransformedAboutThePivot) {
  UvTransform transform;
  transform.pivot = {1, 2};
  transform.scale = {2, -3};
  EXPECT_EQ(transform({2, 3}), Vec2d(3, -1));
  transform.rotation = 90;  // x to y, y to -x
  EXPECT_EQ(transform({2, 3}), Vec2d(4, 4));
  transform.offset = {0.5, 0};
  EXPECT_EQ(transform({2, 3}), Vec2d(4.5, 4));
  transform.rotation = 30;
  transform.scale = {1, 1};
  EXPECT_LT((transform({3, 2}) - Vec2d(1.5 + std::sqrt(3), 3)).length(), 1e-12);
}

TEST_F(TextureCoordinates, AreFittedToTheImage) {
  open(SideTwo);
  project(UvProjection::Cylinder);
  select_only(1);
  const UvBounds before = uv_bounds(objects_, selection_);
  EXPECT_NEAR(before.min.x, 0.375, 1e-6);
  EXPECT_NEAR(before.max.y, 1, 1e-6);
  take(with_transformed_uvs(selected(), fitted(before, {{0, 0}, {1, 1}})));
  EXPECT_LT((uv_at(1, {1, 1, 3}) - Vec2f(0, 0)).length(), 1e-6F);
  EXPECT_LT((uv_at(1, {3, 3, 3}) - Vec2f(1, 1)).length(), 1e-6F);
  const UvTransform of_line = fitted({{2, 3}, {2, 5}}, {{0, 0}, {1, 1}});
  EXPECT_EQ(of_line({2, 3}), Vec2d(0.5, 0)) << "no width";
  open(Square);
  EXPECT_TRUE(uv_bounds(objects_, selection_).isEmpty());
}

}  // namespace
}  // namespace editor
