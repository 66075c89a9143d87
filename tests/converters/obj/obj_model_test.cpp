// The OBJ models of Debian's packages assimp-testmodels and glmark2-data, against a second reading of them.
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/keywords.h"
#include "grf/summary.h"
#include "tests/converters/model_files.h"
#include "tests/converters/obj/reference_obj.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

/// The models that give an error, and a part of its text.
const std::map<std::string, std::string> Errors = {
    {"OBJ/number_formats.obj", "number_formats.obj:11:14: error: found '3.1+e2', expected a finite number"},
    {"OBJ/point_cloud.obj", "point_cloud.obj: error: the file has no faces"},
    {"OBJ/testline.obj", "testline.obj: error: the file has no faces"},
    {"OBJ/testpoints.obj", "testpoints.obj: error: the file has no faces"},
    {"invalid/empty.obj", "empty.obj: error: the file is empty, expected an OBJ model"},
    {"invalid/malformed.obj", "malformed.obj:28:3: error: found '0', expected a corner"},
    {"invalid/malformed2.obj", "malformed2.obj:23:1: error: a face without corners"},
    {"jellyfish.jobj", "jellyfish.jobj: error: the file has no faces"},
};

/// Files that the second reader cannot read, and others that hold the same model.
const std::map<std::string, std::string> Equals = {{"OBJ/box_UTF16BE.obj", "OBJ/box.obj"}};

/// The faces of all meshes, one after the other, as the second reader has them.
std::vector<ReferenceFace> reference_faces(const grf::Scene& scene) {
  std::vector<ReferenceFace> faces;
  for (const grf::Mesh& mesh : meshes_of(scene)) {
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      ReferenceFace face;
      for (const std::uint32_t vertex : mesh.face(i))
        face.corners.emplace_back(mesh.geometry->positions[vertex]);
      face.material = grf::from_identifier(material_of(mesh, i));
      faces.push_back(face);
    }
  }
  return faces;
}

bool agree(const grf::Vec3d& a, const grf::Vec3d& b) {
  return (a - b).length() <= 1e-6 * std::max(1.0, b.length());
}

class ObjModel : public testing::TestWithParam<std::string> {};

TEST_P(ObjModel, IsReadAsTheSecondReaderReadsItOrNotAtAll) {
  const std::string name = short_name(GetParam());
  const Reading reading = read_path(GetParam());
  if (const auto error = Errors.find(name); error != Errors.end()) {
    EXPECT_FALSE(reading.scene.has_value());
    EXPECT_THAT(reading.text(), HasSubstr(error->second));
    return;
  }
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_FALSE(reading.diagnostics.has_errors());
  const auto equal = Equals.find(name);
  const ReferenceModel reference =
      read_reference(equal == Equals.end() ? GetParam() : AssimpModels + equal->second);

  const std::vector<ReferenceFace> faces = reference_faces(*reading.scene);
  ASSERT_EQ(faces.size(), reference.faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const ReferenceFace& expected = reference.faces[i];
    ASSERT_EQ(faces[i].corners.size(), expected.corners.size()) << "face " << i;
    // One model has its names in Latin-1, which are UTF-8 in the scene.
    if (name != "OBJ/regr01.obj") {
      EXPECT_EQ(faces[i].material, expected.material) << "face " << i;
    }
    for (std::size_t k = 0; k < expected.corners.size(); ++k) {
      EXPECT_TRUE(agree(faces[i].corners[k], expected.corners[k])) << "face " << i << ", corner " << k;
    }
  }
  const grf::Summary summary = grf::summarize(*reading.scene);
  EXPECT_NEAR(summary.area, reference.area(), 1e-5 * reference.area());
  grf::Box3d bounds;
  for (const ReferenceFace& face : reference.faces) {
    for (const grf::Vec3d& corner : face.corners) bounds.extendBy(corner);
  }
  EXPECT_TRUE(agree(grf::Vec3d(summary.bounds.min), bounds.min));
  EXPECT_TRUE(agree(grf::Vec3d(summary.bounds.max), bounds.max));
  EXPECT_EQ((ReferenceModel{faces}.distinct_positions()), reference.distinct_positions());
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return test_name(info.param); }

INSTANTIATE_TEST_SUITE_P(OfDebian, ObjModel, testing::ValuesIn(model_files(formats_of_obj_models())),
                         name_of);

TEST(ObjModels, AreAllThere) { EXPECT_GE(model_files(formats_of_obj_models()).size(), 27U); }

TEST(ObjModels, TheBoxWithoutALastLineEndIsReadWithAWarningOfThatAlone) {
  const Reading reading = read_path(AssimpModels + "OBJ/box_without_lineending.obj");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_EQ(reading.diagnostics.warning_count(), 1U);
  EXPECT_THAT(reading.text(), HasSubstr("warning: the file does not end with a line end"));
}

TEST(ObjModels, NamesInLatin1BecomeUtf8) {
  const Reading reading = read_path(AssimpModels + "OBJ/regr01.obj");
  ASSERT_TRUE(reading.scene.has_value());
  std::set<std::string> names;
  for (const grf::Definition& definition : definitions_of(*reading.scene)) {
    names.insert(grf::from_identifier(definition.name));
  }
  EXPECT_TRUE(names.contains("Terraind\u00E6k"));
}

TEST(ObjModels, TheConcavePolygonStaysOneFace) {
  const Reading reading = read_path(AssimpModels + "OBJ/concave_polygon.obj");
  ASSERT_TRUE(reading.scene.has_value());
  const std::vector<grf::Mesh> meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 1U);
  ASSERT_EQ(meshes[0].face_count(), 1U);
  EXPECT_EQ(meshes[0].face(0).size(), 66U);
}

}  // namespace
}  // namespace convert
