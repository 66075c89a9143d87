#include "editor/document/face_query.h"

#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double Degree = std::numbers::pi / 180;

/// A box of 1 x 2 x 3 from the origin. Its faces, in order: -z, +z (area 2), -y, +y (area 3), -x, +x (area
/// 6). The first two have the BRDF steel_plate, then two Steel, two diffuse; the +y face is red.
const std::string Definitions =
    "def steel_plate = brdf ward Steel = brdf phong sum = brdf combine 0.5 Steel ";
const std::string Box = R"(
  begin mesh "box"
    begin vertexs
      (0, 0, 0) (1, 0, 0) (0, 2, 0) (1, 2, 0) (0, 0, 3) (1, 0, 3) (0, 2, 3) (1, 2, 3)
    end vertexs
    begin faces
      brdf steel_plate
      (0, 2, 3, 1) (4, 5, 7, 6)
      brdf Steel
      (0, 1, 5, 4)
      rgb (1, 0, 0)
      (2, 6, 7, 3)
      rgb (1, 1, 1)
      brdf diffuse
      (0, 4, 6, 2) (1, 3, 7, 5)
    end faces
  end mesh
)";

/// The indices of the faces of the first mesh.
std::vector<std::size_t> first_mesh_faces(const FaceSelection& selection) {
  std::vector<std::size_t> result;
  selection.for_each_face(0, [&](std::size_t face) { result.push_back(face); });
  return result;
}

class FaceQueries : public testing::Test {
 protected:
  void show(const std::string& text) {
    objects_ = objects_of(scene_of(Definitions + "begin " + text + " end"), "scene.grf");
    selected_ = FaceSelection(objects_);
  }

  std::vector<std::size_t> found(const FaceQuery& query) {
    return first_mesh_faces(find_faces(query, selected_, objects_));
  }
  std::vector<std::size_t> facing(const grf::Vec3d& axis, double degrees) {
    FaceQuery query;
    query.normal = DirectionRange{axis, degrees * Degree};
    return found(query);
  }
  std::vector<std::size_t> with_area(double least, double most) {
    FaceQuery query;
    query.area = {least, most};
    return found(query);
  }
  std::vector<std::size_t> between(double least, double most) {
    FaceQuery query;
    query.height = {least, most};
    return found(query);
  }
  std::vector<std::size_t> of_material(const std::string& pattern) {
    FaceQuery query;
    query.material = pattern;
    return found(query);
  }
  std::vector<std::size_t> similar(const Similarity& similarity) {
    return first_mesh_faces(select_similar(selected_, objects_, similarity));
  }

  SceneObjects objects_;
  FaceSelection selected_;
};

TEST_F(FaceQueries, WithoutConditionsFindAll) {
  show(Box);
  EXPECT_EQ(found({}).size(), 6U);
}

TEST_F(FaceQueries, CompareNormalsWithADirection) {
  show(Box);
  EXPECT_THAT(facing({0, 0, -1}, 0), ElementsAre(0));
  EXPECT_THAT(facing({0, 0, 1}, 1), ElementsAre(1));
  EXPECT_THAT(facing({0, 1, 0}, 89), ElementsAre(3));
  EXPECT_THAT(facing({1, 0, 0}, 91), ElementsAre(0, 1, 2, 3, 5)) << "all but the opposite";
}

TEST_F(FaceQueries, CompareAreas) {
  show(Box);
  EXPECT_THAT(with_area(2.5, 1e9), ElementsAre(2, 3, 4, 5));
  EXPECT_THAT(with_area(0, 2.5), ElementsAre(0, 1));
  EXPECT_THAT(with_area(2.5, 5), ElementsAre(2, 3));
}

TEST_F(FaceQueries, CompareHeightsOfAllCorners) {
  show(Box);
  EXPECT_THAT(between(-1, 0.5), ElementsAre(2));
  EXPECT_THAT(between(1, 2), ElementsAre(3));
  EXPECT_EQ(between(0, 2).size(), 6U);
  EXPECT_THAT(between(0.5, 1.5), IsEmpty());
}

TEST_F(FaceQueries, AreInWorldSpace) {
  // Twice as long along x, turned by 90 degrees about z (x becomes y), and raised by 10.
  show("transform scale (2, 1, 1) rotation (0, 0, 1.5707963) translation (0, 10, 0) begin " + Box + " end");
  EXPECT_THAT(facing({0, 1, 0}, 1), ElementsAre(5)) << "+x is now up";
  EXPECT_THAT(facing({-1, 0, 0}, 1), ElementsAre(3)) << "+y is now -x";
  EXPECT_THAT(with_area(3.9, 4.1), ElementsAre(0, 1)) << "2 x 2";
  EXPECT_THAT(with_area(5.9, 6.1), ElementsAre(2, 3, 4, 5)) << "2 x 3, and as it was";
  EXPECT_THAT(between(11.9, 12.1), ElementsAre(5));
  EXPECT_THAT(between(9.9, 10.1), ElementsAre(4));
}

TEST_F(FaceQueries, HoldInOneInstance) {
  objects_ =
      objects_of(scene_of(Definitions + "object = " + Box +
                          "begin use object transform translation (0, 10, 0) begin use object end end"),
                 "scene.grf");
  selected_ = FaceSelection(objects_);
  EXPECT_THAT(between(9.5, 10.5), ElementsAre(2));
  EXPECT_THAT(between(1.5, 10.5), ElementsAre(2, 3)) << "the lower's top, and the upper's bottom";
}

TEST_F(FaceQueries, MatchNamesOfMaterials) {
  show(Box);
  EXPECT_THAT(of_material("steel_plate"), ElementsAre(0, 1));
  EXPECT_THAT(of_material("STEEL*"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(of_material("steel"), ElementsAre(2, 3)) << "the whole name";
  EXPECT_THAT(of_material("*plate"), ElementsAre(0, 1));
  EXPECT_THAT(of_material("ph?ng"), ElementsAre(2, 3)) << "the model";
  EXPECT_THAT(of_material("diffuse"), ElementsAre(4, 5));
  EXPECT_THAT(of_material("gold"), IsEmpty());
}

TEST_F(FaceQueries, MatchTermsAndTheDefault) {
  const std::string face = "begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end";
  show("begin mesh brdf sum " + face + " end");
  EXPECT_THAT(of_material("sum"), ElementsAre(0));
  EXPECT_THAT(of_material("phong"), ElementsAre(0));
  show("begin mesh " + face + " end");
  EXPECT_THAT(of_material("diffuse"), ElementsAre(0)) << "without a BRDF";
  EXPECT_THAT(of_material("phong"), IsEmpty());
}

TEST_F(FaceQueries, CombineSimilaritiesByAnd) {
  show(Box);
  selected_.set({0, 3});
  EXPECT_THAT(similar({.brdf = true}), ElementsAre(2, 3));
  EXPECT_THAT(similar({.colour = true}), ElementsAre(3));
  EXPECT_THAT(similar({.brdf = true, .colour = true}), ElementsAre(3));
  EXPECT_EQ(similar({.pdf = true}).size(), 6U) << "none has one";
  EXPECT_THAT(similar({.area_fraction = 0.01}), ElementsAre(2, 3));
  EXPECT_THAT(similar({.area_fraction = 0.5}), ElementsAre(0, 1, 2, 3)) << "1.5 to 4.5";
  EXPECT_THAT(similar({.normal_radians = 1 * Degree}), ElementsAre(3));
  EXPECT_THAT(similar({.brdf = true, .normal_radians = 91 * Degree}), ElementsAre(3));
  EXPECT_THAT(similar({.normal_radians = 91 * Degree, .area_fraction = 1.1}), ElementsAre(0, 1, 3, 4, 5));
}

TEST_F(FaceQueries, CombineConditionsByAnd) {
  show(Box);
  selected_.set({0, 3});
  FaceQuery query;
  query.similarity.brdf = true;
  query.area = {2.5, 10};
  query.normal = DirectionRange{{0, -1, 0}, 1 * Degree};
  EXPECT_THAT(found(query), ElementsAre(2));
  query.material = "*plate";
  EXPECT_THAT(found(query), IsEmpty());
}

TEST_F(FaceQueries, CompareWithTheMeanOfSeveralFaces) {
  show(Box);
  selected_.set({0, 0});
  selected_.set({0, 4});
  EXPECT_THAT(similar({.area_fraction = 0.26}), ElementsAre(2, 3)) << "4 +- 1.04";
  // The mean normal is that of -z, area 2, and -x, area 6: 18.4 degrees from -x, 71.6 from -z.
  EXPECT_THAT(similar({.normal_radians = 18 * Degree}), IsEmpty());
  EXPECT_THAT(similar({.normal_radians = 19 * Degree}), ElementsAre(4));
  EXPECT_THAT(similar({.normal_radians = 72 * Degree}), ElementsAre(0, 4));
}

TEST_F(FaceQueries, FindNothingSimilarToNothing) {
  show(Box);
  EXPECT_THAT(similar({.brdf = true}), IsEmpty());
  EXPECT_THAT(similar({.normal_radians = 4}), IsEmpty());
}

TEST_F(FaceQueries, TellObjectsApart) {
  show(Box + Box);
  selected_.set({0, 3});
  EXPECT_EQ(select_similar(selected_, objects_, {.brdf = true}).count(), 4U);
  const FaceSelection in_object = select_similar(selected_, objects_, {.brdf = true, .object = true});
  EXPECT_THAT(first_mesh_faces(in_object), ElementsAre(2, 3));
  EXPECT_EQ(in_object.count(), 2U);
}

TEST(FaceQueriesByName, TellNamesOfTwoScopesApart) {
  const std::string face = " begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end end ";
  const std::string meshes =
      "begin begin mesh brdf a rgb c" + face + "begin mesh brdf combine 1 a" + face + "end ";
  const std::string first = "def a = brdf diffuse kd=0.1 c = rgb (1,0,0) " + meshes;
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(first + first + "def a = brdf diffuse kd=0.9 c = rgb (0,1,0) " + meshes,
                                    "scene.grf", diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  const SceneObjects objects = objects_of(*scene, "scene.grf");
  for (const Similarity& by :
       {Similarity{.brdf = true}, Similarity{.colour = true}, Similarity::of_surface()}) {
    FaceSelection selection(objects);
    selection.set({0, 0});
    EXPECT_THAT(select_similar(selection, objects, by).meshes(), ElementsAre(0, 2));
  }
  FaceSelection of_sum(objects);
  of_sum.set({1, 0});
  EXPECT_THAT(select_similar(of_sum, objects, {.brdf = true}).meshes(), ElementsAre(1, 3));
}

}  // namespace
}  // namespace editor
