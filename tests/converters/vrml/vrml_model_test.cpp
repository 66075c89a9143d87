// The VRML files of Debian's package assimp-testmodels, against a plain count of what they hold.
#include <cstdlib>
#include <set>
#include <tuple>

#include <gmock/gmock.h>

#include "grf/summary.h"
#include "tests/converters/model_files.h"
#include "tests/converters/vrml/vrml_reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string Models = "/usr/share/assimp/models/WRL/";

/// The numbers of each list behind a field's name, in their order.
std::vector<std::vector<double>> lists_of(const std::string& text, const std::string& field) {
  std::vector<std::vector<double>> lists;
  const std::string name = field + " [";
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    std::string list = text.substr(at + name.size(), text.find(']', at) - at - name.size());
    for (char& c : list) c = c == ',' ? ' ' : c;
    std::vector<double>& numbers = lists.emplace_back();
    const char* position = list.c_str();
    for (char* end = nullptr;; position = end) {
      const double number = std::strtod(position, &end);
      if (end == position) break;
      numbers.push_back(number);
    }
  }
  return lists;
}

struct Counts {
  std::size_t faces = 0;
  std::set<std::tuple<float, float, float>> positions;
  double area = 0;
};

/// Of files that list each mesh's points before its faces, as these do.
Counts counts_of_mesh(const std::vector<double>& points, const std::vector<double>& indices) {
  Counts counts;
  std::vector<grf::Vec3d> face;
  const auto end_face = [&] {
    if (face.empty()) return;
    ++counts.faces;
    grf::Vec3d sum(0);
    for (std::size_t k = 1; k + 1 < face.size(); ++k) sum += (face[k] - face[0]).cross(face[k + 1] - face[0]);
    counts.area += sum.length() / 2;
    face.clear();
  };
  for (const double index : indices) {
    if (index < 0) {
      end_face();
      continue;
    }
    const auto i = static_cast<std::size_t>(index) * 3;
    face.emplace_back(points[i], points[i + 1], points[i + 2]);
    counts.positions.emplace(static_cast<float>(points[i]), static_cast<float>(points[i + 1]),
                             static_cast<float>(points[i + 2]));
  }
  end_face();
  return counts;
}

void expect_counts(const std::string& name, std::size_t mesh_count) {
  const std::string text = test::bytes_of(Models + name);
  const auto points = lists_of(text, "point");
  const auto indices = lists_of(text, "coordIndex");
  ASSERT_EQ(points.size(), mesh_count);
  ASSERT_EQ(indices.size(), mesh_count);
  const Reading reading = read_path(Models + name);
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const auto meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), mesh_count);
  for (std::size_t i = 0; i < mesh_count; ++i) {
    const Counts expected = counts_of_mesh(points[i], indices[i]);
    std::set<std::tuple<float, float, float>> positions;
    for (const grf::Vec3f& p : meshes[i].geometry->positions) positions.emplace(p.x, p.y, p.z);
    EXPECT_EQ(meshes[i].face_count(), expected.faces);
    EXPECT_EQ(positions, expected.positions);
    EXPECT_NEAR(area_of(meshes[i]), expected.area, 1e-5 * expected.area);
    EXPECT_GT(expected.faces, 10U);
  }
}

TEST(VrmlModels, TheModelOfBlendersExporterIsRead) {
  expect_counts("Wuson.wrl", 1);
  const Reading reading = read_path(Models + "Wuson.wrl");
  EXPECT_EQ(meshes_of(*reading.scene)[0].name, "ME_Mesh");
  EXPECT_THAT(reading.text(), HasSubstr("1 camera was left out"));
  EXPECT_THAT(reading.text(), HasSubstr("1 light was left out"));
}

TEST(VrmlModels, TheModelOf3dsMaxIsRead) {
  expect_counts("MotionCaptureROM.WRL",
                lists_of(test::bytes_of(Models + "MotionCaptureROM.WRL"), "point").size());
  const Reading reading = read_path(Models + "MotionCaptureROM.WRL");
  EXPECT_THAT(reading.text(), HasSubstr("PositionInterpolator nodes were skipped: GRF scenes are static"));
  EXPECT_THAT(reading.text(), HasSubstr("ROUTEs were skipped"));
  for (const grf::Mesh& mesh : meshes_of(*reading.scene)) {
    EXPECT_FALSE(mesh.geometry->normals.empty());
    EXPECT_FALSE(material_of(mesh, 0).empty());
    EXPECT_THAT(mesh.name, HasSubstr("-FACES"));
  }
}

TEST(VrmlModels, AreTheseTwo) {
  EXPECT_THAT(model_files(formats_of_vrml_models()),
              ElementsAre(Models + "MotionCaptureROM.WRL", Models + "Wuson.wrl"));
}

}  // namespace
}  // namespace convert
