// The models of Debian's packages assimp-testmodels and glmark2-data in all formats that come in through
// Assimp, and in OFF: against figures of Assimp's scenes as Assimp has them, or against a second reader.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/summary.h"
#include "grf/write.h"
#include "tests/converters/assimp/golden_models.h"
#include "tests/converters/assimp/reference_models.h"
#include "tests/converters/model_files.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

using Position = std::tuple<float, float, float>;

/// What is compared: of faces of three corners or more.
struct Figures {
  std::size_t faces = 0;
  std::set<Position> positions;  ///< that faces use, before any transform
  double area = 0;
  grf::Box3d bounds;
};

Position position_of(const grf::Vec3f& p) { return {p.x + 0.0F, p.y + 0.0F, p.z + 0.0F}; }

grf::Vec3d to_vector(const aiVector3D& v) { return {v.x, v.y, v.z}; }

void add_face(Figures& figures, const aiMesh& mesh, const aiFace& face, const aiMatrix4x4& to_world) {
  if (face.mNumIndices < 3) return;
  ++figures.faces;
  grf::Vec3d doubled(0);
  grf::Vec3d origin(0);
  for (unsigned i = 0; i < face.mNumIndices; ++i) {
    const aiVector3D& a = mesh.mVertices[face.mIndices[i]];
    const grf::Vec3d p = to_vector(to_world * a);
    const grf::Vec3d q = to_vector(to_world * mesh.mVertices[face.mIndices[(i + 1) % face.mNumIndices]]);
    figures.positions.insert(position_of({a.x, a.y, a.z}));
    figures.bounds.extendBy(p);
    if (i == 0) origin = p;
    doubled += (p - origin).cross(q - origin);
  }
  figures.area += doubled.length() / 2;
}

void add_node(Figures& figures, const aiScene& scene, const aiNode& node, const aiMatrix4x4& to_world) {
  for (const unsigned index : std::span(node.mMeshes, node.mNumMeshes)) {
    const aiMesh& mesh = *scene.mMeshes[index];
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) add_face(figures, mesh, face, to_world);
  }
  for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) {
    if (child == nullptr) continue;  // as Assimp leaves them of RAW files
    add_node(figures, scene, *child, to_world * child->mTransformation);
  }
}

/// Assimp turns and scales scenes of these formats by their roots.
bool root_is_conversion(const std::string& format) {
  return format == "3ds" || format == "dxf" || format == "collada" || format == "fbx";
}

Figures figures_of_assimp(const std::string& path, const std::string& format) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_AC_EVAL_SUBDIVISION, false);
  const aiScene* scene = importer.ReadFile(path, 0);
  Figures figures;
  if (scene == nullptr) return figures;
  const aiNode& root = *scene->mRootNode;
  add_node(figures, *scene, root, root_is_conversion(format) ? aiMatrix4x4() : root.mTransformation);
  return figures;
}

Figures figures_of_reference(const ReferenceModel& model) {
  Figures figures;
  figures.faces = model.faces.size();
  figures.area = model.area();
  for (const ReferenceFace& face : model.faces) {
    for (const grf::Vec3d& p : face.corners) {
      figures.positions.insert(position_of(grf::Vec3f(p)));
      figures.bounds.extendBy(p);
    }
  }
  return figures;
}

std::set<Position> positions_of(const grf::Scene& scene) {
  std::set<Position> positions;
  for (const grf::Mesh& mesh : meshes_of(scene)) {
    for (const std::uint32_t corner : mesh.geometry->corners)
      positions.insert(position_of(mesh.geometry->positions[corner]));
  }
  for (const grf::Definition& definition : definitions_of(scene)) {
    const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body);
    if (mesh == nullptr) continue;
    for (const std::uint32_t corner : (*mesh)->geometry->corners) {
      positions.insert(position_of((*mesh)->geometry->positions[corner]));
    }
  }
  return positions;
}

/// Files that Assimp by itself cannot read, and others that hold the same model.
const std::map<std::string, std::string> Equals = {
    {"AC/SphereWithLight_UTF16LE.ac", "AC/SphereWithLight.ac"},
    {"Collada/cube_UTF16LE.dae", "Collada/cube_UTF8BOM.dae"},
};

class AssimpModel : public testing::TestWithParam<std::string> {};

TEST_P(AssimpModel, IsReadAsAssimpHasItOrNotAtAll) {
  const std::string path = GetParam();
  const std::string name = short_name(path);
  const Reading reading = read_path(path);
  if (const auto error = expected_errors().find(name); error != expected_errors().end()) {
    EXPECT_FALSE(reading.scene.has_value());
    EXPECT_THAT(reading.text(), HasSubstr("error: " + error->second));
    return;
  }
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  grf::Diagnostics diagnostics;
  const std::string format(recognise(path, diagnostics)->name);
  const auto equal = Equals.find(name);
  const Figures expected =
      format == "stl" ? figures_of_reference(read_reference_stl(path))
      : format == "off"
          ? figures_of_reference(read_reference_off(path))
          : figures_of_assimp(equal == Equals.end() ? path : AssimpModels + equal->second, format);
  const grf::Summary summary = grf::summarize(*reading.scene);
  EXPECT_EQ(summary.faces, expected.faces);
  const std::set<Position> positions = positions_of(*reading.scene);
  if (format == "stl") {
    EXPECT_EQ(positions.size(), expected.positions.size()) << "Assimp rounds some to the next float";
  } else {
    EXPECT_EQ(positions, expected.positions);
  }
  EXPECT_NEAR(summary.area, expected.area, 1e-5 * expected.area);
  const double size = expected.bounds.size().length();
  EXPECT_LE((grf::Vec3d(summary.bounds.min) - expected.bounds.min).length(), 1e-5 * size);
  EXPECT_LE((grf::Vec3d(summary.bounds.max) - expected.bounds.max).length(), 1e-5 * size);
}

class ReadableAssimpModel : public AssimpModel {};

TEST_P(ReadableAssimpModel, IsTheSameSceneOnceItIsWritten) {
  const Reading reading = read_path(GetParam());
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(grf::write(*reading.scene, folder.path("a.grf"), diagnostics));
  const auto again = grf::read(folder.path("a.grf"), diagnostics);
  ASSERT_TRUE(again.has_value()) << diagnostics.to_text();
  EXPECT_TRUE(*again == *reading.scene);
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return test_name(info.param); }

std::vector<std::string> readable_paths() {
  std::vector<std::string> paths = model_files(formats_of_assimp_models());
  const auto is_broken = [](const std::string& path) { return expected_errors().contains(short_name(path)); };
  paths.erase(std::remove_if(paths.begin(), paths.end(), is_broken), paths.end());
  return paths;
}

INSTANTIATE_TEST_SUITE_P(OfDebian, AssimpModel, testing::ValuesIn(model_files(formats_of_assimp_models())),
                         name_of);
INSTANTIATE_TEST_SUITE_P(OfDebian, ReadableAssimpModel, testing::ValuesIn(readable_paths()), name_of);

TEST(AssimpModels, AreAllThere) { EXPECT_GE(model_files(formats_of_assimp_models()).size(), 200U); }

}  // namespace
}  // namespace convert
