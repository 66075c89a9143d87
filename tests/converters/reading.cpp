#include "tests/converters/reading.h"

#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace convert {

Reading read_path(const std::string& path, const ReadOptions& options) {
  Reading reading;
  if (const Format* format = recognise(path, reading.diagnostics)) {
    if (auto import = read(*format, path, options, reading.diagnostics)) {
      reading.scene = std::move(import->scene);
      reading.files = std::move(import->files);
      reading.cameras = std::move(import->cameras);
    }
  }
  return reading;
}

Reading read_bytes(const std::string& name, std::string_view bytes) {
  const test::TemporaryFolder folder;
  return read_path(folder.add(name, bytes));
}

Reading read_obj_text(std::string_view obj, std::string_view mtl, const ReadOptions& options) {
  const test::TemporaryFolder folder;
  if (!mtl.empty()) folder.add("model.mtl", mtl);
  return read_path(folder.add("model.obj", obj), options);
}

grf::Scene scene_of_grf(const std::string& text) {
  grf::Diagnostics diagnostics;
  auto scene = grf::read_text(text, "scene.grf", diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.to_text());
  return std::move(*scene);
}

std::vector<grf::Mesh> meshes_of(const grf::Scene& scene) {
  std::vector<grf::Mesh> meshes;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
    meshes.push_back(mesh);
  };
  grf::visit(scene, visitor);
  return meshes;
}

grf::Mesh only_mesh(const Reading& reading) {
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  const auto meshes = reading.scene ? meshes_of(*reading.scene) : std::vector<grf::Mesh>();
  EXPECT_EQ(meshes.size(), 1U);
  return meshes.empty() ? grf::Mesh() : meshes[0];
}

std::vector<grf::Definition> definitions_of(const grf::Scene& scene) {
  std::vector<grf::Definition> definitions;
  grf::SceneVisitor visitor;
  visitor.definition = [&](const grf::Definition& definition, const grf::Placement&) {
    definitions.push_back(definition);
  };
  grf::visit(scene, visitor);
  return definitions;
}

std::string brdf_text(const grf::Definition& definition) {
  return grf::to_text(std::get<grf::BrdfModel>(definition.body));
}

std::string material_of(const grf::Mesh& mesh, std::size_t face) {
  const auto& brdf = mesh.surface(face).brdf;
  return brdf ? std::get<grf::Reference>(*brdf).name : std::string();
}

}  // namespace convert
