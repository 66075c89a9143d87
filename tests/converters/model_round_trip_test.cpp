// All models of Debian's packages assimp-testmodels and glmark2-data, by way of GRF to each format that is
// written, and back: what each corner of each face has.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "tests/converters/gltf/assimp_count.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

namespace fs = std::filesystem;

struct Corner {
  grf::Vec3d position;
  std::optional<grf::Vec3d> normal;  ///< of unit length
  grf::Vec2f uv = grf::Vec2f(0);
  grf::Colour colour = grf::Colour(1);
};

struct Face {
  std::vector<Corner> corners;
  grf::Colour colour = grf::Colour(1);
  std::string material;  ///< empty where there is none
  bool is_placed = false;
};

/// All faces of a scene where they stand in the world, by transforms of the test's own.
std::vector<Face> faces_of(const grf::Scene& scene) {
  std::vector<Face> faces;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const grf::Matrix44d& m = placement.to_world;
    const grf::Matrix44d of_normals = m.inverse().transposed();
    const bool is_mirrored = m.determinant() < 0;
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      Face& face = faces.emplace_back();
      face.is_placed = m != grf::Matrix44d();
      const grf::Surface& surface = mesh.surface(i);
      if (surface.brdf) face.material = grf::from_identifier(material_of(mesh, i));
      if (surface.colour) face.colour = std::get<grf::Colour>(*surface.colour);
      for (const std::uint32_t v : mesh.face(i)) {
        Corner& corner = face.corners.emplace_back();
        m.multVecMatrix(grf::Vec3d(mesh.geometry->positions[v]), corner.position);
        if (mesh.geometry->normals.has(v) && mesh.geometry->normals[v].length() > 0) {
          corner.normal.emplace();
          of_normals.multDirMatrix(grf::Vec3d(mesh.geometry->normals[v]), *corner.normal);
          corner.normal->normalize();
        }
        if (mesh.geometry->uvs.has(v)) corner.uv = mesh.geometry->uvs[v];
        if (mesh.geometry->colours.has(v)) corner.colour = mesh.geometry->colours[v];
      }
      // It is flat then, and OBJ has no face with normals at some corners.
      const bool is_smooth = std::all_of(face.corners.begin(), face.corners.end(),
                                         [](const Corner& corner) { return corner.normal.has_value(); });
      if (!is_smooth) {
        for (Corner& corner : face.corners) corner.normal.reset();
      }
      // A mirror turns a face over, and writers turn it back from its first corner on.
      if (is_mirrored) std::reverse(face.corners.begin() + 1, face.corners.end());
    }
  };
  grf::visit(scene, visitor);
  return faces;
}

bool agree(const Corner& a, const Corner& b, bool is_placed, double size) {
  const bool one_position =
      is_placed ? (a.position - b.position).length() <= 1e-6 * size : a.position == b.position;
  const bool one_normal = a.normal.has_value() == b.normal.has_value() &&
                          (!a.normal || (*a.normal - *b.normal).length() <= (is_placed ? 1e-5 : 1e-12));
  return one_position && one_normal && a.uv == b.uv && a.colour == b.colour;
}

/// The first face that is not the same; the number of faces if there is none.
std::size_t first_difference(const std::vector<Face>& faces, const std::vector<Face>& expected, double size) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Face& e = expected[i];
    const Face& f = faces[i];
    const auto same_corner = [&](const Corner& a, const Corner& b) { return agree(a, b, e.is_placed, size); };
    const bool same_corners =
        std::equal(f.corners.begin(), f.corners.end(), e.corners.begin(), e.corners.end(), same_corner);
    const bool same_material = e.material.empty() || f.material == e.material;
    if (!same_corners || !same_material || f.colour != e.colour) return i;
  }
  return expected.size();
}

std::vector<std::string> model_paths() {
  std::vector<std::string> paths;
  for (const char* folder : {"/usr/share/assimp/models", "/usr/share/glmark2/models"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string path = entry.path().string();
      if (entry.is_regular_file() && format_of_name(path) != nullptr) paths.push_back(path);
    }
  }
  std::sort(paths.begin(), paths.end());
  // Those that are no models are known by tests of each format.
  const auto is_unreadable = [](const std::string& path) { return !read_path(path).scene.has_value(); };
  paths.erase(std::remove_if(paths.begin(), paths.end(), is_unreadable), paths.end());
  EXPECT_GT(paths.size(), 300U) << "without models there is nothing to compare";
  return paths;
}

/// The model as GRF has it, named from a folder.
grf::Scene as_grf(const std::string& path, const test::TemporaryFolder& folder) {
  Reading reading = read_path(path);
  for (const EmbeddedFile& file : reading.files) folder.add(file.name, file.bytes);
  grf::relocate(*reading.scene, path, folder.path("model.grf"));
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(grf::write(*reading.scene, folder.path("model.grf"), diagnostics)) << diagnostics.to_text();
  const auto scene = grf::read(folder.path("model.grf"), diagnostics);
  EXPECT_TRUE(scene && *scene == *reading.scene) << diagnostics.to_text();
  return scene.value_or(grf::Scene());
}

grf::Scene through(const char* format, const std::string& file, const grf::Scene& scene) {
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(find_format(format)->write(scene, file, diagnostics)) << diagnostics.to_text();
  Reading again = read_path(file);
  EXPECT_TRUE(again.scene.has_value()) << again.text();
  return again.scene.value_or(grf::Scene());
}

void expect_same_faces(const std::string& path, const char* format, const std::string& file,
                       const grf::Scene& scene) {
  const std::vector<Face> expected = faces_of(scene);
  ASSERT_FALSE(expected.empty()) << path;
  const std::vector<Face> faces = faces_of(through(format, file, scene));
  ASSERT_EQ(faces.size(), expected.size()) << path << " by way of " << format;
  const ModelCount counted = count_of(scene);
  // What stands in the world is rounded: of the distance from its origin.
  const double size = std::max(counted.bounds.min.length(), counted.bounds.max.length());
  const std::size_t difference = first_difference(faces, expected, size);
  EXPECT_EQ(difference, expected.size()) << path << " by way of " << format;
  const auto by_assimp = assimp_count(file);
  ASSERT_TRUE(by_assimp.has_value()) << path << " by way of " << format;
  EXPECT_EQ(by_assimp->faces, expected.size()) << path << " by way of " << format;
}

TEST(ModelRoundTrip, ObjAndPlyKeepWhatCornersHave) {
  for (const std::string& path : model_paths()) {
    const test::TemporaryFolder folder;
    const grf::Scene scene = as_grf(path, folder);
    expect_same_faces(path, "obj", folder.path("again.obj"), scene);
    expect_same_faces(path, "ply", folder.path("again.ply"), scene);
    expect_same_faces(path, "ply-ascii", folder.path("again_ascii.ply"), scene);
  }
}

TEST(ModelRoundTrip, GltfKeepsTheScene) {
  for (const std::string& path : model_paths()) {
    const test::TemporaryFolder folder;
    const grf::Scene scene = as_grf(path, folder);
    EXPECT_TRUE(through("gltf", folder.path("again.gltf"), scene) == scene) << path;
    const auto by_assimp = assimp_count(folder.path("again.gltf"));
    ASSERT_TRUE(by_assimp.has_value()) << path;
    const grf::Box3d bounds = count_of(scene).bounds;
    const double size = std::max(bounds.min.length(), bounds.max.length());
    EXPECT_LE((by_assimp->bounds.min - bounds.min).length(), 1e-5 * size) << path;
    EXPECT_LE((by_assimp->bounds.max - bounds.max).length(), 1e-5 * size) << path;
  }
}

}  // namespace
}  // namespace convert
