#include "converters/gltf/gltf_material_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "converters/gltf/gltf_images.h"
#include "converters/material_mapping.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"
#include "grf/keywords.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace convert {
namespace {

using nlohmann::json;

/// Clamps a factor to glTF's range, 0 to 1.
double in_unit(double x) { return std::isfinite(x) ? std::clamp(x, 0.0, 1.0) : 0.0; }

json factors(const grf::Vec3d& v) {
  return {rounded_factor(in_unit(v.x)), rounded_factor(in_unit(v.y)), rounded_factor(in_unit(v.z))};
}

void extend(json& material, json& root, const char* name, json values) {
  material["extensions"][name] = std::move(values);
  json& used = root["extensionsUsed"];
  if (!used.is_array()) used = json::array();
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

void emit(json& material, json& root, const grf::Colour& radiance) {
  const grf::Vec3d r(std::max(radiance.x, 0.0F), std::max(radiance.y, 0.0F), std::max(radiance.z, 0.0F));
  const double strength = std::max({r.x, r.y, r.z});
  if (strength <= 0) return;
  if (strength <= 1) {
    material["emissiveFactor"] = factors(r);
    return;
  }
  material["emissiveFactor"] = factors(r / strength);
  extend(material, root, "KHR_materials_emissive_strength", {{"emissiveStrength", strength}});
}

/// The table of conversions by `GltfMaterialWriter::material`.
constexpr std::array<MaterialRule, 6> GltfWriterRules = {{
    {"a diffuse lobe m under a glossy lobe g",
     "D = m/(1 - g) and F0 = g, solved for base colour and metallic", "brdf ashikhmin ex=30 Rs=0.04 Rd=0.5",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [0.5, 0.5, 0.5, 1], \"metallicFactor\": 0, "
     "\"roughnessFactor\": 0.5}",
     ""},
    {"the glossy lobe's exponent h",
     "`roughnessFactor` = (2/(h + 2))^(1/4); 0 for perfect specular reflection", "brdf specular ks=0.5",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [0.5, 0.5, 0.5, 1], \"metallicFactor\": 1, "
     "\"roughnessFactor\": 0}",
     ""},
    {"no highlight", "`roughnessFactor` 1, and `KHR_materials_specular` with `specularFactor` 0",
     "brdf diffuse kd=0.25",
     "\"extensions\": {\"KHR_materials_specular\": {\"specularFactor\": 0}}, \"pbrMetallicRoughness\": "
     "{\"baseColorFactor\": [0.25, 0.25, 0.25, 1], \"metallicFactor\": 0, \"roughnessFactor\": 1}",
     ""},
    {"`rgb` of a face", "a factor of `baseColorFactor`", "rgb (0.5, 1, 1) brdf diffuse kd=0.5",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [0.25, 0.5, 0.5, 1]}", ""},
    {"`light rgb` of a face, lights", "`emissiveFactor`, and `emissiveStrength` where it is over 1",
     "light rgb (4, 2, 1)",
     "\"emissiveFactor\": [1, 0.5, 0.25], \"extensions\": {\"KHR_materials_emissive_strength\": "
     "{\"emissiveStrength\": 4}}, \"doubleSided\": false",
     ""},
    {"`texture`", "`baseColorTexture`", "brdf diffuse kd=0.5 texture \"wood.png\"",
     "\"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}", ""},
}};

/// Returns the name of a surface's material: that of its BRDF's definition, or the model's.
std::string name_of(const grf::Surface& surface) {
  if (!surface.brdf) return surface.emission ? "light" : "";
  if (const auto* reference = std::get_if<grf::Reference>(&*surface.brdf)) {
    return grf::from_identifier(reference->name);
  }
  return std::get<grf::BrdfModel>(*surface.brdf).keyword;
}

}  // namespace

int GltfMaterialWriter::add(json material) {
  const auto [known, is_new] = materials_.emplace(material.dump(), 0);
  if (is_new) known->second = document_.append("materials", std::move(material));
  return known->second;
}

int GltfMaterialWriter::material(const grf::Surface& surface, const grf::Scope& scope) {
  const grf::ResolvedSurface resolved = grf::resolve(surface, scope);
  MicrofacetValues facets{grf::Vec3d(resolved.emission ? 0 : 0.5), grf::Vec3d(0), 1};
  if (resolved.brdf != nullptr) facets = microfacet_values(brdf_lobes(*resolved.brdf, resolved.brdf_scope));
  MetallicRoughness values = metallic_roughness(facets);
  values.base_colour *= grf::Vec3d(resolved.colour);
  json material;
  const std::string name = name_of(surface);
  if (!name.empty()) material["name"] = to_utf8(name);
  json base = factors(values.base_colour);
  base.push_back(1);
  json& pbr = material["pbrMetallicRoughness"];
  pbr = {{"baseColorFactor", base},
         {"metallicFactor", rounded_factor(values.metallic)},
         {"roughnessFactor", rounded_factor(values.roughness)}};
  if (resolved.texture != nullptr) {
    const int place = texture(resolved.texture->file);
    if (place >= 0) pbr["baseColorTexture"] = {{"index", place}};
  }
  // Without this, diffuse materials would have a specular reflectance of 0.04.
  if (facets.specular == grf::Vec3d(0)) {
    extend(material, document_.json(), "KHR_materials_specular", {{"specularFactor", 0}});
  }
  // Reflectance is two-sided in GRF, and emission is not.
  material["doubleSided"] = !resolved.emission;
  if (resolved.emission) emit(material, document_.json(), *resolved.emission);
  if (resolved.brdf != nullptr && resolved.brdf->terms.empty()) {
    json& exact = material["extras"]["grf"];
    exact["brdf"] = to_utf8(grf::to_text(*resolved.brdf));
    if (surface.colour) exact["rgb"] = {resolved.colour.x, resolved.colour.y, resolved.colour.z};
  }
  return add(std::move(material));
}

int GltfMaterialWriter::light_material(const grf::Surface& surface, const grf::Scope& scope) {
  return light_material(grf::resolve(surface, scope).colour);
}

int GltfMaterialWriter::light_material(const grf::Colour& radiance) {
  json material = {{"name", "light"},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}}};
  emit(material, document_.json(), radiance);
  return add(std::move(material));
}

int GltfMaterialWriter::texture(const std::string& file) {
  const auto [known, is_new] = textures_.emplace(file, -1);
  if (!is_new || file.empty()) return known->second;
  json source = image(file);
  if (source.is_null()) return -1;
  const int place = document_.append("images", std::move(source));
  return known->second = document_.append("textures", {{"source", place}});
}

json GltfMaterialWriter::image(const std::string& file) {
  if (!embeds_images_) {
    const std::string extension = grf::lower_case(std::filesystem::path(file).extension().string());
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") unknown_.push_back(file);
    return {{"uri", to_uri(file)}};
  }
  grf::Diagnostics ignored_diagnostics;
  const auto bytes = grf::read_file(grf::path_beside(path_, file), ignored_diagnostics);
  if (!bytes) {
    unreadable_.push_back(file);
    return nullptr;
  }
  const std::string_view kind = image_extension(*bytes);
  if (kind != ".png" && kind != ".jpg") {
    unknown_.push_back(file);
    return nullptr;
  }
  const std::string name = to_utf8(names_.take(std::filesystem::path(file).filename().string(), kind));
  embedded_.emplace(file, name);
  return {{"name", name},
          {"mimeType", kind == ".png" ? "image/png" : "image/jpeg"},
          {"bufferView", document_.add_view(*bytes)}};
}

void GltfMaterialWriter::report() const {
  const auto warn = [this](const std::vector<std::string>& files, const char* one, const char* many) {
    if (files.empty()) return;
    std::vector<std::string> paths;
    for (const std::string& file : files) {
      paths.push_back(std::filesystem::path(grf::path_beside(path_, file)).lexically_normal().string());
    }
    diagnostics_.warning(grf::whole_file(path_),
                         fmt::format("{}: faces lose their texture in other programs than Granada ({})",
                                     counted(files.size(), one, many), listed(paths)));
  };
  warn(unreadable_, "image cannot be read", "images cannot be read");
  warn(unknown_, "image is neither PNG nor JPEG, the formats of glTF",
       "images are neither PNG nor JPEG, the formats of glTF");
}

std::span<const MaterialRule> gltf_material_writer_rules() { return GltfWriterRules; }

}  // namespace convert
