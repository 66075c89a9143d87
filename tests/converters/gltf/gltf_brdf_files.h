// Files of glTF for tests of the BRDF `gltf`, and what is read of them.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "grf/write.h"
#include "tests/converters/gltf/gltf_maker.h"

namespace convert {

inline Reading read_material(const nlohmann::json& material) {
  return GltfMaker::with_material(material).read();
}

/// Makes a dielectric of half roughness with extensions: all its other values are defaults of the BRDF.
inline nlohmann::json dielectric(const nlohmann::json& extensions) {
  nlohmann::json material = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.5}}}};
  for (const auto& [name, values] : extensions.items()) {
    material["extensions"]["KHR_materials_" + name] = values;
  }
  return material;
}

inline grf::BrdfModel model_of(const Reading& reading) {
  if (!reading.scene) throw std::runtime_error(reading.text());
  return std::get<grf::BrdfModel>(definitions_of(*reading.scene).at(0).body);
}

/// Returns the BRDF of a material about which the reader warns of nothing.
inline std::string clean_brdf_of(const nlohmann::json& material) {
  const Reading reading = read_material(material);
  EXPECT_THAT(reading.text(), testing::IsEmpty()) << material;
  return grf::to_text(model_of(reading));
}

/// Returns a written file of a triangle with the attributes.
inline nlohmann::json written(const std::string& attributes) {
  const test::TemporaryFolder folder;
  const grf::Scene scene = scene_of_grf("begin mesh " + attributes +
                                        " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin "
                                        "faces (0, 1, 2) end faces end mesh");
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(find_format("gltf")->write(scene, folder.path("a.gltf"), diagnostics)) << diagnostics.to_text();
  nlohmann::json file = nlohmann::json::parse(test::bytes_of(folder.path("a.gltf")));
  // The buffer would be a file beside it.
  file["buffers"][0]["uri"] = "data:application/octet-stream;base64," + [&] {
    GltfMaker maker;
    maker.buffer = test::bytes_of(folder.path("a.bin"));
    return maker.base64();
  }();
  return file;
}

/// Reads a written file of which only the materials are left: no GRF scene, and no BRDF unless `keeps_brdf`.
inline Reading read_bare(nlohmann::json file, bool keeps_brdf = false) {
  file.erase("extras");
  if (!keeps_brdf) file["materials"][0].erase("extras");
  return GltfMaker::read_bytes("a.gltf", file.dump());
}

}  // namespace convert
