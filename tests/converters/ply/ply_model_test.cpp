// The PLY models of Debian's package assimp-testmodels, against a second reading of them, and written again
// and read by Assimp.
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/keywords.h"
#include "grf/summary.h"
#include "tests/converters/ply/reference_ply.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string Models = "/usr/share/assimp/models/PLY/";

/// The models that give an error, and a part of its text.
const std::map<std::string, std::string> Errors = {
    {"issue623.ply", "issue623.ply: error: the file is a cloud of 24 points: it has no faces"},
    {"points.ply", "points.ply: error: the file is a cloud of 4 points: it has no faces"},
    {"pond.0.ply", "pond.0.ply:3:1: error: the file is too short for 70051 elements 'vertex'"},
};

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(Models)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string readable_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !grf::is_word_character(c); }, '_');
  return name;
}

class PlyModel : public testing::TestWithParam<std::string> {};

TEST_P(PlyModel, IsReadAsTheSecondReaderReadsItOrNotAtAll) {
  const Reading reading = read_path(Models + GetParam());
  if (const auto error = Errors.find(GetParam()); error != Errors.end()) {
    EXPECT_FALSE(reading.scene.has_value());
    EXPECT_THAT(reading.text(), HasSubstr(error->second));
    return;
  }
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const ReferencePly expected = read_reference_ply(Models + GetParam());
  const std::vector<grf::Mesh> meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 1U);
  const grf::Mesh& mesh = meshes.front();
  EXPECT_EQ(mesh.positions, expected.positions) << "bit for bit, in the order of the file";
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

INSTANTIATE_TEST_SUITE_P(Debian, PlyModel, testing::ValuesIn(model_names()), readable_name);

TEST(PlyModels, KeepWhatElseTheyHave) {
  const Reading wuson = read_path(Models + "Wuson.ply");
  EXPECT_THAT(wuson.text(),
              HasSubstr("Wuson.ply:3:1: warning: found 'Created', expected a word of PLY headers"));
  const grf::Mesh mesh = meshes_of(*wuson.scene).front();
  EXPECT_TRUE(mesh.normals.has(0));
  EXPECT_TRUE(mesh.uvs.has(0));
  const Reading colours = read_path(Models + "float-color.ply");
  EXPECT_TRUE(meshes_of(*colours.scene).front().colours.has(2));
}

}  // namespace
}  // namespace convert
