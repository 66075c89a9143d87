#include "tests/converters/renderers/exported_scene.h"

#include <array>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/converters/reading.h"

namespace convert {

ExportedScene::ExportedScene(const std::string& grf, const std::string& op) {
  write(grf, op, folder_.path());
}

ExportedScene::ExportedScene(const std::string& grf, const std::string& op,
                             const test::TemporaryFolder& files) {
  for (const std::string& name : files.names()) folder_.add(name, test::bytes_of(files.path(name)));
  write(grf, op, folder_.path());
}

void ExportedScene::write(const std::string& grf, const std::string& op, const std::string& folder) {
  const grf::Scene scene = scene_of_grf(grf);
  folder_.add("scene.grf", grf);
  WriteOptions options;
  if (!op.empty()) options.op_file = folder_.add("view.op", op);
  const auto written = [&](const char* format, const std::string& path, std::string& warnings) {
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(find_format(format)->write_view(scene, path, options, diagnostics)) << diagnostics.to_text();
    warnings = diagnostics.to_text();
    return test::bytes_of(path);
  };
  pbrt_ = test::parse_pbrt(written("pbrt", folder_.path("out.pbrt"), pbrt_warnings_), folder);
  mitsuba_ = test::parse_mitsuba(written("mitsuba", folder_.path("out.xml"), mitsuba_warnings_), folder);
}

grf::Mesh ExportedScene::mesh(const std::string& name) const {
  grf::Diagnostics diagnostics;
  const auto import = read(*find_format("ply"), path(name), {}, diagnostics);
  EXPECT_TRUE(import.has_value()) << diagnostics.to_text();
  return import ? meshes_of(import->scene).at(0) : grf::Mesh();
}

image::Image ExportedScene::image(const std::string& name) const {
  grf::Diagnostics diagnostics;
  const auto image = image::read_image(path(name), diagnostics);
  EXPECT_TRUE(image.has_value()) << diagnostics.to_text();
  return image.value_or(image::Image());
}

std::vector<grf::Mesh> ExportedScene::pbrt_meshes() const {
  std::vector<grf::Mesh> meshes;
  for (const test::PbrtShape& shape : pbrt_.shapes) {
    EXPECT_EQ(shape.to_world, grf::Matrix44d());
    if (shape.object.empty()) meshes.push_back(mesh(shape.shape.string("filename")));
  }
  return meshes;
}

std::vector<grf::Mesh> ExportedScene::mitsuba_meshes() const {
  std::vector<grf::Mesh> meshes;
  for (const test::MitsubaElement& shape : mitsuba_.all("shape")) {
    EXPECT_EQ(shape.values.contains("flip_normals"), false);
    if (shape.type == "ply") meshes.push_back(mesh(shape.values.at("filename")));
  }
  return meshes;
}

std::string cube(const std::string& attributes, const std::vector<std::string>& of_faces) {
  constexpr std::array Faces = {"(0,2,3,1)", "(4,5,7,6)", "(0,1,5,4)", "(2,6,7,3)", "(0,4,6,2)", "(1,3,7,5)"};
  std::string text = "begin mesh \"cube\" " + attributes + " begin vertexs\n";
  for (int i = 0; i < 8; ++i)
    text += fmt::format("({}, {}, {})\n", i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1);
  text += "end vertexs begin faces\n";
  for (std::size_t i = 0; i < Faces.size(); ++i)
    text += (i < of_faces.size() ? of_faces[i] + " " : "") + Faces[i] + "\n";
  return text + "end faces end mesh\n";
}

double signed_volume(const grf::Mesh& mesh) {
  double volume = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    const auto at = [&](std::size_t k) { return grf::Vec3d(mesh.geometry->positions[corners[k]]); };
    for (std::size_t k = 2; k < corners.size(); ++k) volume += at(0).dot(at(k - 1).cross(at(k))) / 6;
  }
  return volume;
}

}  // namespace convert
