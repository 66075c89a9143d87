// glTF has images for parameters of the BRDF `gltf`.
#pragma once

#include <array>
#include <string_view>

#include "grf/model.h"

namespace convert {

/// The image of a parameter, as a member of a material of glTF.
struct GltfMap {
  std::string_view parameter;  ///< of the BRDF `gltf`
  grf::ImageChannel channel = grf::ImageChannel::Red;
  std::string_view extension;  ///< its name after `KHR_materials_`; empty: pbrMetallicRoughness
  std::string_view texture;    ///< its member
};

/// The images that GRF and glTF share. That of the base colour is the texture of the faces in GRF. The
/// thickness of a film is here if the least one of the file is 0.
constexpr std::array<GltfMap, 10> GltfMaps = {{
    {"metallic", grf::ImageChannel::Blue, "", "metallicRoughnessTexture"},
    {"roughness", grf::ImageChannel::Green, "", "metallicRoughnessTexture"},
    {"specular", grf::ImageChannel::Alpha, "specular", "specularTexture"},
    {"specularColor", grf::ImageChannel::Rgb, "specular", "specularColorTexture"},
    {"clearcoat", grf::ImageChannel::Red, "clearcoat", "clearcoatTexture"},
    {"coatRoughness", grf::ImageChannel::Green, "clearcoat", "clearcoatRoughnessTexture"},
    {"sheenColor", grf::ImageChannel::Rgb, "sheen", "sheenColorTexture"},
    {"sheenRoughness", grf::ImageChannel::Alpha, "sheen", "sheenRoughnessTexture"},
    {"iridescence", grf::ImageChannel::Red, "iridescence", "iridescenceTexture"},
    {"filmThickness", grf::ImageChannel::Green, "iridescence", "iridescenceThicknessTexture"},
}};

}  // namespace convert
