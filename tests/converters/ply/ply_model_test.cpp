// The PLY models of Debian's package assimp-testmodels, against a second reading of them, and written again
// and read by Assimp.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/keywords.h"
#include "grf/summary.h"
#include "tests/converters/model_files.h"
#include "tests/converters/ply/reference_ply.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

/// The models that give an error, and a part of its text.
const std::map<std::string, std::string> Errors = {
    {"PLY/issue623.ply", "issue623.ply: error: the file is a cloud of 24 points: it has no faces"},
    {"PLY/points.ply", "points.ply: error: the file is a cloud of 4 points: it has no faces"},
    {"PLY/pond.0.ply", "pond.0.ply:3:1: error: the file is too short for 70051 elements 'vertex'"},
    {"invalid/empty.ply", "empty.ply: error: the file is empty"},
};

class PlyModel : public testing::TestWithParam<std::string> {};

TEST_P(PlyModel, IsReadAsTheSecondReaderReadsItOrNotAtAll) {
  const Reading reading = read_path(GetParam());
  if (const auto error = Errors.find(short_name(GetParam())); error != Errors.end()) {
    EXPECT_FALSE(reading.scene.has_value());
    EXPECT_THAT(reading.text(), HasSubstr(error->second));
    return;
  }
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const ReferencePly expected = read_reference_ply(GetParam());
  const std::vector<grf::Mesh> meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 1U);
  const grf::Mesh& mesh = meshes.front();
  EXPECT_EQ(mesh.geometry->positions, expected.positions) << "bit for bit, in the order of the file";
  ASSERT_EQ(mesh.face_count(), expected.faces.size());
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const auto face = mesh.face(i);
    EXPECT_TRUE(std::equal(face.begin(), face.end(), expected.faces[i].begin(), expected.faces[i].end()))
        << i;
  }
  const grf::Summary summary = grf::summarize(*reading.scene);
  EXPECT_EQ(summary.bounds, expected.bounds());
  EXPECT_NEAR(summary.area, expected.area(), 1e-5 * expected.area());
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return test_name(info.param); }

INSTANTIATE_TEST_SUITE_P(OfDebian, PlyModel, testing::ValuesIn(model_files(formats_of_ply_models())),
                         name_of);

TEST(PlyModels, AreAllThere) { EXPECT_GE(model_files(formats_of_ply_models()).size(), 9U); }

TEST(PlyModels, KeepWhatElseTheyHave) {
  const Reading wuson = read_path(AssimpModels + "PLY/Wuson.ply");
  EXPECT_THAT(wuson.text(),
              HasSubstr("Wuson.ply:3:1: warning: found 'Created', expected a keyword of PLY headers"));
  const grf::Mesh mesh = meshes_of(*wuson.scene).front();
  EXPECT_TRUE(mesh.geometry->normals.has(0));
  EXPECT_TRUE(mesh.geometry->uvs.has(0));
  const Reading colours = read_path(AssimpModels + "PLY/float-color.ply");
  EXPECT_TRUE(meshes_of(*colours.scene).front().geometry->colours.has(2));
}

}  // namespace
}  // namespace convert
