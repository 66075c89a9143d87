#include "editor/document/face_selection.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"

namespace editor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A strip of five squares along x, of which the last two are bent upwards by 45 and 90 degrees; the fourth
/// and fifth are diffuse. Behind it stands a separate triangle.
const std::string Strip = R"(
  begin mesh "strip"
    brdf ward
    begin vertexs
      (0, 0, 0) (0, 0, 1) (1, 0, 0) (1, 0, 1) (2, 0, 0) (2, 0, 1) (3, 0, 0) (3, 0, 1)
      (4, 1, 0) (4, 1, 1) (4, 2, 0) (4, 2, 1) (9, 0, 0) (9, 0, 1) (10, 0, 0)
    end vertexs
    begin faces
      (0, 1, 3, 2) (2, 3, 5, 4) (4, 5, 7, 6)
      brdf diffuse
      (6, 7, 9, 8) (8, 9, 11, 10)
      brdf ward
      (12, 13, 14)
    end faces
  end mesh
  begin mesh "other"
    brdf diffuse
    begin vertexs
      (0, 5, 0) (0, 5, 1) (1, 5, 0)
    end vertexs
    begin faces
      (0, 1, 2)
    end faces
  end mesh
)";

class Selecting : public testing::Test {
 protected:
  Selecting() {
    grf::Diagnostics diagnostics;
    const auto scene = grf::read_text(Strip, "strip.grf", diagnostics);
    if (!scene) throw std::runtime_error(diagnostics.to_text());
    objects_ = objects_of(*scene, "strip.grf");
    selection_ = FaceSelection(objects_);
  }

  static std::vector<std::uint32_t> faces(const FaceSelection& selection, std::uint32_t mesh = 0) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 0; i < selection.of_mesh(mesh).size(); ++i) {
      if (selection.has({mesh, i})) result.push_back(i);
    }
    return result;
  }

  SceneObjects objects_;
  FaceSelection selection_;
};

TEST_F(Selecting, Counts) {
  EXPECT_TRUE(selection_.empty());
  selection_.set({0, 2});
  selection_.set({0, 2});
  EXPECT_EQ(selection_.count(), 1U);
  selection_.invert();
  EXPECT_EQ(selection_.count(), 6U);
  selection_.set_mesh(0);
  EXPECT_EQ(selection_.count(), 7U);
  selection_.set({1, 0}, false);
  EXPECT_EQ(selection_.count(), 6U);
  selection_.clear();
  EXPECT_TRUE(selection_.empty());
  selection_.select_all();
  EXPECT_EQ(selection_.count(), 7U);
}

TEST_F(Selecting, AddsAndRemoves) {
  selection_.set({0, 1});
  FaceSelection other(objects_);
  other.set({0, 1});
  other.set({1, 0});
  selection_.add(other);
  EXPECT_EQ(selection_.count(), 2U);
  other.set({0, 1}, false);
  selection_.remove(other);
  EXPECT_THAT(faces(selection_), ElementsAre(1));
  EXPECT_THAT(faces(selection_, 1), IsEmpty());
}

TEST_F(Selecting, Intersects) {
  selection_.set({0, 1});
  selection_.set({0, 2});
  selection_.set({1, 0});
  FaceSelection other(objects_);
  other.set({0, 2});
  other.set({0, 3});
  selection_.intersect(other);
  EXPECT_THAT(faces(selection_), ElementsAre(2));
  EXPECT_THAT(faces(selection_, 1), IsEmpty());
  EXPECT_EQ(selection_.count(), 1U);
}

TEST_F(Selecting, GrowsAndShrinks) {
  selection_.set({0, 1});
  const FaceSelection grown_once = grown(selection_, objects_);
  EXPECT_THAT(faces(grown_once), ElementsAre(0, 1, 2));
  EXPECT_THAT(faces(shrunk(grown_once, objects_)), ElementsAre(0, 1));
  EXPECT_THAT(faces(shrunk(selection_, objects_)), IsEmpty());
}

TEST_F(Selecting, FollowsWhatHangsTogether) {
  selection_.set({0, 4});
  EXPECT_THAT(faces(connected(selection_, objects_)), ElementsAre(0, 1, 2, 3, 4));
}

TEST_F(Selecting, FollowsWhatIsFlat) {
  selection_.set({0, 0});
  EXPECT_THAT(faces(coplanar(selection_, objects_, 0.01)), ElementsAre(0, 1, 2));
  EXPECT_THAT(faces(coplanar(selection_, objects_, 0.8)), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(faces(coplanar(selection_, objects_, 1.6)), ElementsAre(0, 1, 2, 3, 4));
}

}  // namespace
}  // namespace editor
