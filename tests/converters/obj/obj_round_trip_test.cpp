// OBJ -> GRF -> OBJ and GRF -> OBJ -> GRF: what is kept, of generated meshes and of real files.
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "converters/obj/obj_writer.h"
#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/summary.h"
#include "grf/write.h"
#include "tests/converters/obj/reference_obj.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

namespace fs = std::filesystem;

/// All that a corner of a face has.
struct PlacedCorner {
  grf::Vec3f position;
  std::optional<grf::Vec3f> normal;
  std::optional<grf::Vec2f> uv;
  std::optional<grf::Colour> colour;

  bool operator==(const PlacedCorner&) const = default;
};

struct PlacedFace {
  std::string mesh;
  std::string material;
  std::vector<PlacedCorner> corners;

  bool operator==(const PlacedFace&) const = default;
};

template <class T>
std::optional<T> value_at(const grf::OptionalVertexValues<T>& values, std::uint32_t vertex) {
  return values.has(vertex) ? std::optional(values[vertex]) : std::nullopt;
}

std::vector<PlacedFace> faces_of(const grf::Scene& scene) {
  std::vector<PlacedFace> faces;
  for (const grf::Mesh& mesh : meshes_of(scene)) {
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      PlacedFace& face = faces.emplace_back();
      face.mesh = mesh.name;
      face.material = grf::from_identifier(material_of(mesh, i));
      for (const std::uint32_t v : mesh.face(i)) {
        face.corners.push_back({mesh.geometry->positions[v], value_at(mesh.geometry->normals, v),
                                value_at(mesh.geometry->uvs, v), value_at(mesh.geometry->colours, v)});
      }
    }
  }
  return faces;
}

/// The scene written as OBJ and read again.
grf::Scene through_obj(const grf::Scene& scene, const test::TemporaryFolder& folder) {
  grf::Diagnostics diagnostics;
  const std::string path = folder.path("again.obj");
  EXPECT_TRUE(write_obj(scene, path, diagnostics)) << diagnostics.to_text();
  const Reading reading = read_path(path);
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  return reading.scene.value_or(grf::Scene());
}

/// The scene written as GRF text and read again.
grf::Scene through_grf(const grf::Scene& scene, const test::TemporaryFolder& folder) {
  grf::Diagnostics diagnostics;
  auto again = grf::read_text(grf::to_text(scene), folder.path("scene.grf"), diagnostics);
  EXPECT_TRUE(again.has_value()) << diagnostics.to_text();
  return again.value_or(grf::Scene());
}

/// Any float but infinities and NaN.
rc::Gen<float> any_float() {
  return rc::gen::map(rc::gen::arbitrary<std::uint32_t>(), [](std::uint32_t bits) {
    const auto number = std::bit_cast<float>(bits);
    return std::isfinite(number) ? number : std::bit_cast<float>(bits & 0x7F000000U);
  });
}

float some_float() { return *any_float(); }

/// A mesh of polygons, of which some vertices are alike, with faces of some materials.
grf::Mesh some_mesh(const std::string& name) {
  grf::MeshDraft mesh;
  mesh.name = name;
  const auto vertices = *rc::gen::inRange<std::uint32_t>(3, 12);
  const bool has_normals = *rc::gen::arbitrary<bool>();
  const bool has_uvs = *rc::gen::arbitrary<bool>();
  const bool has_colours = *rc::gen::arbitrary<bool>();
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const bool repeats = i > 0 && *rc::gen::inRange(0, 4) == 0;
    mesh.positions.push_back(repeats ? mesh.positions[i - 1]
                                     : grf::Vec3f(some_float(), some_float(), some_float()));
    if (has_normals) mesh.normals.set(i, {some_float(), some_float(), some_float()});
    if (has_uvs) mesh.uvs.set(i, {some_float(), some_float()});
    if (has_colours)
      mesh.colours.set(i, {std::abs(some_float()), std::abs(some_float()), std::abs(some_float())});
  }
  grf::SurfaceIndex surfaces(mesh.surfaces);
  const auto faces = *rc::gen::inRange(1, 6);
  for (int i = 0; i < faces; ++i) {
    grf::Surface surface;
    const int material = *rc::gen::inRange(0, 4);
    if (material > 0) surface.brdf = grf::Reference{fmt::format("m$20${}", material), {}};
    std::vector<std::uint32_t> corners;
    const auto count = *rc::gen::inRange(3, 7);
    for (int k = 0; k < count; ++k) corners.push_back(*rc::gen::inRange<std::uint32_t>(0, vertices));
    mesh.add_face(corners, surfaces.index_of(surface));
  }
  return mesh;
}

grf::Scene some_scene() {
  grf::DefinitionScope scope;
  for (int i = 1; i < 4; ++i) {
    grf::BrdfModel brdf;
    brdf.keyword = *rc::gen::element<std::string>("diffuse", "ward", "lewis", "unheard_of");
    brdf.arguments = {{"kd", std::abs(some_float()), {}}};
    scope.definitions.push_back({fmt::format("m$20${}", i), brdf, {}, {}});
  }
  const auto meshes = *rc::gen::inRange(1, 4);
  for (int i = 0; i < meshes; ++i) {
    scope.body.blocks.push_back({grf::Shared<grf::Mesh>(some_mesh(i % 2 == 0 ? "" : "a # b \\")), {}, {}});
  }
  grf::Scene scene;
  scene.contents.blocks.push_back({std::move(scope), {}, {}});
  return scene;
}

/// A colour that is missing where other vertices of the file have one is written as 1.
void make_colours_explicit(std::vector<PlacedFace>& faces) {
  bool any = false;
  for (const PlacedFace& face : faces) {
    for (const PlacedCorner& corner : face.corners) any = any || corner.colour;
  }
  for (PlacedFace& face : faces) {
    for (PlacedCorner& corner : face.corners) {
      if (any && !corner.colour) corner.colour = grf::Colour(1);
    }
  }
}

/// Checks a property with fewer cases than others have: each waits for the disk.
void check(const char* name, void (*property)()) {
  rc::detail::TestMetadata metadata;
  metadata.id = name;
  metadata.description = name;
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess /= 10;
  const auto result = rc::detail::checkTestable(property, metadata, params);
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  EXPECT_TRUE(result.is<rc::detail::SuccessResult>()) << message.str();
}

void grf_to_obj_to_grf() {
  const grf::Scene scene = some_scene();
  const test::TemporaryFolder folder;
  const grf::Scene again = through_obj(scene, folder);
  std::vector<PlacedFace> expected = faces_of(scene);
  make_colours_explicit(expected);
  const std::vector<PlacedFace> faces = faces_of(again);
  RC_ASSERT(faces.size() == expected.size());
  for (std::size_t i = 0; i < faces.size(); ++i) RC_ASSERT(faces[i] == expected[i]);
  RC_ASSERT(definitions_of(again) == definitions_of(scene));
}

/// An OBJ file with numbers of any digits, and a second one made of it by way of GRF.
void obj_to_grf_to_obj() {
  std::string obj;
  const auto vertices = *rc::gen::inRange(3, 10);
  for (int i = 0; i < vertices; ++i) {
    obj += fmt::format("v {} {:.8e} {:.4f}\n", some_float(), some_float(), std::fmod(some_float(), 1000.0F));
  }
  const auto faces = *rc::gen::inRange(1, 6);
  for (int i = 0; i < faces; ++i) {
    if (*rc::gen::inRange(0, 3) == 0) obj += fmt::format("o object {}\n", i);
    if (*rc::gen::inRange(0, 3) == 0) obj += fmt::format("usemtl material {}\n", *rc::gen::inRange(0, 3));
    obj += 'f';
    const auto corners = *rc::gen::inRange(3, 7);
    for (int k = 0; k < corners; ++k) {
      const auto index = *rc::gen::inRange(1, vertices + 1);
      obj += fmt::format(" {}", *rc::gen::arbitrary<bool>() ? index : index - vertices - 1);
    }
    obj += '\n';
  }
  const test::TemporaryFolder folder;
  const std::string path = folder.add("original.obj", obj);
  const Reading reading = read_path(path);
  RC_ASSERT(reading.scene.has_value());
  through_obj(through_grf(*reading.scene, folder), folder);
  const ReferenceModel original = read_reference(path);
  const ReferenceModel again = read_reference(folder.path("again.obj"));
  RC_ASSERT(again.faces.size() == original.faces.size());
  for (std::size_t i = 0; i < original.faces.size(); ++i) {
    RC_ASSERT(again.faces[i].corners == original.faces[i].corners);
    RC_ASSERT(again.faces[i].material == original.faces[i].material);
  }
}

TEST(ObjRoundTrip, GrfToObjToGrfKeepsFacesBitForBit) { check("GRF to OBJ to GRF", &grf_to_obj_to_grf); }
TEST(ObjRoundTrip, ObjToGrfToObjKeepsPositionsBitForBit) { check("OBJ to GRF to OBJ", &obj_to_grf_to_obj); }

std::vector<std::string> real_files() {
  std::vector<std::string> paths;
  for (const char* folder : {"/usr/share/assimp/models/OBJ", "/usr/share/glmark2/models"}) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".obj") paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string readable_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !grf::is_word_character(c); }, '_');
  return name;
}

std::map<std::string, std::string> brdfs_of(const grf::Scene& scene) {
  std::map<std::string, std::string> brdfs;
  for (const grf::Definition& definition : definitions_of(scene)) {
    brdfs.emplace(grf::from_identifier(definition.name), brdf_text(definition));
  }
  return brdfs;
}

/// Faces and different positions as Assimp counts them.
std::pair<std::size_t, std::size_t> counts_by_assimp(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, 0);
  EXPECT_NE(scene, nullptr) << importer.GetErrorString();
  if (scene == nullptr) return {};
  std::size_t faces = 0;
  std::set<std::tuple<float, float, float>> positions;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& mesh = *scene->mMeshes[i];
    faces += mesh.mNumFaces;
    for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
      positions.emplace(mesh.mVertices[k].x, mesh.mVertices[k].y, mesh.mVertices[k].z);
    }
  }
  return {faces, positions.size()};
}

class RealObj : public testing::TestWithParam<std::string> {};

TEST_P(RealObj, ComesBackThroughGrfAsItWas) {
  const Reading reading = read_path(GetParam());
  if (!reading.scene) {  // obj_model_test knows which errors these are
    EXPECT_TRUE(reading.diagnostics.has_errors());
    return;
  }
  const test::TemporaryFolder folder;
  const grf::Scene grf = through_grf(*reading.scene, folder);
  const grf::Scene again = through_obj(grf, folder);
  const std::string path = folder.path("again.obj");
  std::vector<PlacedFace> expected = faces_of(*reading.scene);
  make_colours_explicit(expected);
  const std::vector<PlacedFace> faces = faces_of(again);
  ASSERT_EQ(faces.size(), expected.size());
  for (std::size_t i = 0; i < faces.size(); ++i) ASSERT_TRUE(faces[i] == expected[i]) << "face " << i;
  EXPECT_EQ(brdfs_of(again), brdfs_of(*reading.scene));

  const ReferenceModel reference = read_reference(path);
  const grf::Summary before = grf::summarize(*reading.scene);
  EXPECT_EQ(reference.faces.size(), before.faces);
  EXPECT_NEAR(reference.area(), before.area, 1e-5 * before.area);
  EXPECT_EQ(grf::summarize(again).bounds, before.bounds);
  EXPECT_EQ(counts_by_assimp(path), (std::pair{reference.faces.size(), reference.distinct_positions()}));
}

INSTANTIATE_TEST_SUITE_P(OfDebian, RealObj, testing::ValuesIn(real_files()), readable_name);

TEST(RealObjs, AreManyAndNearlyAllCanBeRead) {
  std::size_t readable = 0;
  for (const std::string& path : real_files()) readable += read_path(path).scene ? 1 : 0;
  EXPECT_GE(readable, 19U);
}

}  // namespace
}  // namespace convert
