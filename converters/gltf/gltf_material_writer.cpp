#include "converters/gltf/gltf_material_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "converters/gltf/gltf_brdf.h"
#include "converters/gltf/gltf_images.h"
#include "converters/gltf/gltf_maps.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"
#include "grf/keywords.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace convert {
namespace {

using nlohmann::json;

json factors(const grf::Vec3d& v) { return {rounded_factor(v.x), rounded_factor(v.y), rounded_factor(v.z)}; }

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

/// Adds the extensions for values that metallic-roughness alone does not have.
void add_extensions(json& material, json& root, const GltfBrdf& values) {
  const GltfBrdf defaults;
  if (values.ior != defaults.ior) {
    extend(material, root, "KHR_materials_ior", {{"ior", rounded_factor(values.ior)}});
  }
  json specular = json::object();
  if (values.specular != 1) specular["specularFactor"] = rounded_factor(values.specular);
  if (values.specular_colour != grf::Vec3d(1)) {
    specular["specularColorFactor"] = factors(values.specular_colour);
  }
  const bool varies = values.maps.contains("specular") || values.maps.contains("specularColor");
  if (!specular.empty() || varies) extend(material, root, "KHR_materials_specular", specular);
  if (values.anisotropy > 0) {
    // Rounding pi up would turn the direction round.
    const double rotation = std::clamp(rounded_factor(values.rotation), -std::numbers::pi, std::numbers::pi);
    extend(material, root, "KHR_materials_anisotropy",
           {{"anisotropyStrength", rounded_factor(values.anisotropy)}, {"anisotropyRotation", rotation}});
  }
  if (values.clearcoat > 0) {
    extend(material, root, "KHR_materials_clearcoat",
           {{"clearcoatFactor", rounded_factor(values.clearcoat)},
            {"clearcoatRoughnessFactor", rounded_factor(values.coat_roughness)}});
  }
  if (values.sheen_colour != grf::Vec3d(0)) {
    extend(material, root, "KHR_materials_sheen",
           {{"sheenColorFactor", factors(values.sheen_colour)},
            {"sheenRoughnessFactor", rounded_factor(values.sheen_roughness)}});
  }
  if (values.iridescence > 0) {
    extend(material, root, "KHR_materials_iridescence",
           {{"iridescenceFactor", rounded_factor(values.iridescence)},
            {"iridescenceIor", rounded_factor(values.iridescence_ior)},
            {"iridescenceThicknessMaximum", rounded_factor(values.film_thickness)}});
    if (values.maps.contains("filmThickness"))
      material["extensions"]["KHR_materials_iridescence"]["iridescenceThicknessMinimum"] = 0;
  }
  if (!values.is_glass()) return;
  extend(material, root, "KHR_materials_transmission", {{"transmissionFactor", 1}});
  if (!(values.thickness > 0)) return;
  json volume = {{"thicknessFactor", rounded_factor(values.thickness)}};
  if (std::isfinite(values.attenuation_distance)) {
    volume["attenuationDistance"] = rounded_factor(values.attenuation_distance);
    volume["attenuationColor"] = factors(values.attenuation_colour);
  }
  extend(material, root, "KHR_materials_volume", volume);
}

void add_opacity(json& material, const grf::Opacity& opacity) {
  if (opacity == grf::Opacity()) return;
  const double value = std::clamp(grf::shortest(opacity.value), 0.0, 1.0);
  if (opacity.kind == grf::Opacity::Kind::Mask) {
    material["alphaMode"] = "MASK";
    material["alphaCutoff"] = value;
  } else {
    material["alphaMode"] = "BLEND";
    material["pbrMetallicRoughness"]["baseColorFactor"][3] = value;
  }
}

/// Returns the values of a surface's material. Without a BRDF it is grey, or black if it emits.
GltfBrdf values_of(const grf::ResolvedSurface& surface) {
  GltfBrdf values = surface.brdf != nullptr
                        ? nearest_gltf(*surface.brdf, surface.brdf_scope)
                        : nearest_gltf(BrdfLobes{.diffuse = grf::Vec3d(surface.emission ? 0 : 0.5)});
  values.base *= grf::Vec3d(surface.colour);
  normalise(values);
  return values;
}

/// The table of conversions by `GltfMaterialWriter::material`.
constexpr std::array<MaterialRule, 13> GltfWriterRules = {{
    {"`gltf`", "exactly its values", "brdf gltf baseColor=(1, 0.5, 0.25) metallic=0.5 roughness=0.25",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 0.5, 0.25, 1], \"metallicFactor\": 0.5, "
     "\"roughnessFactor\": 0.25}",
     ""},
    {"its other values, if they are not defaults",
     "`KHR_materials_ior`, `KHR_materials_specular`, `KHR_materials_anisotropy`, `KHR_materials_clearcoat`, "
     "`KHR_materials_sheen`, `KHR_materials_iridescence`",
     "brdf gltf ior=3 specular=0.5 specularColor=(1, 2, 4) anisotropy=0.5 rotation=-0.25 clearcoat=0.5 "
     "coatRoughness=0.25 sheenColor=0.5 sheenRoughness=0.75 iridescence=0.5 iridescenceIor=1.5 "
     "filmThickness=250",
     "\"extensions\": {\"KHR_materials_ior\": {\"ior\": 3}, \"KHR_materials_specular\": {\"specularFactor\": "
     "0.5, \"specularColorFactor\": [1, 2, 4]}, \"KHR_materials_anisotropy\": {\"anisotropyStrength\": 0.5, "
     "\"anisotropyRotation\": -0.25}, \"KHR_materials_clearcoat\": {\"clearcoatFactor\": 0.5, "
     "\"clearcoatRoughnessFactor\": 0.25}, \"KHR_materials_sheen\": {\"sheenColorFactor\": [0.5, 0.5, 0.5], "
     "\"sheenRoughnessFactor\": 0.75}, \"KHR_materials_iridescence\": {\"iridescenceFactor\": 0.5, "
     "\"iridescenceIor\": 1.5, \"iridescenceThicknessMaximum\": 250}}",
     ""},
    {"images of its parameters",
     "the textures of `metallicFactor` and so on, if they have the channel of glTF, and those of `metallic` "
     "and `roughness` are one file",
     "brdf gltf metallic=texture \"wood.png\" b roughness=texture \"wood.png\" g",
     "\"pbrMetallicRoughness\": {\"metallicRoughnessTexture\": {\"index\": 0}}", ""},
    {"`glass thin=true`", "`KHR_materials_transmission`; the base colour is that of the pane",
     "brdf glass colour=(1, 0.5, 0.25) thin=true",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 0.5, 0.25, 1], \"metallicFactor\": 0, "
     "\"roughnessFactor\": 0}, \"extensions\": {\"KHR_materials_transmission\": {\"transmissionFactor\": 1}}",
     ""},
    {"`glass`", "the same with `KHR_materials_volume`", "brdf glass ior=2 colour=0.5 distance=0.25",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 1, 1, 1], \"metallicFactor\": 0, "
     "\"roughnessFactor\": "
     "0}, \"extensions\": {\"KHR_materials_ior\": {\"ior\": 2}, \"KHR_materials_transmission\": "
     "{\"transmissionFactor\": 1}, \"KHR_materials_volume\": {\"thicknessFactor\": 1, "
     "\"attenuationDistance\": "
     "0.25, \"attenuationColor\": [0.5, 0.5, 0.5]}}",
     ""},
    {"others, a diffuse lobe m under a glossy lobe g",
     "m = 0.96 x base colour x (1 - metallic) and g = 0.04 x (1 - metallic) + base colour x metallic, solved "
     "for both",
     "brdf ashikhmin ex=30 Rs=0.04 Rd=0.5",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [0.5, 0.5, 0.5, 1], \"metallicFactor\": 0, "
     "\"roughnessFactor\": 0.5}",
     ""},
    {"others, the glossy lobe's exponent h",
     "`roughnessFactor` = (2/(h + 2))^(1/4); 0 for perfect specular reflection", "brdf specular ks=0.5",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [0.5, 0.5, 0.5, 1], \"metallicFactor\": 1, "
     "\"roughnessFactor\": 0}",
     ""},
    {"others, no highlight", "`roughnessFactor` 1, and `KHR_materials_specular` with `specularFactor` 0",
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
    {"`opacity` with a number or `blend`", "`alphaMode` `BLEND`, and the alpha of `baseColorFactor`",
     "brdf diffuse kd=0.5 opacity 0.25",
     "\"alphaMode\": \"BLEND\", \"pbrMetallicRoughness\": {\"baseColorFactor\": [0.5, 0.5, 0.5, 0.25]}", ""},
    {"`opacity` with `mask`", "`alphaMode` `MASK`, `alphaCutoff`",
     "brdf diffuse kd=0.5 texture \"wood.png\" opacity mask 0.75",
     "\"alphaMode\": \"MASK\", \"alphaCutoff\": 0.75", ""},
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

/// Adds the images of parameters. Metallic and roughness are channels of one image, of which one may be
/// without effect.
void GltfMaterialWriter::add_maps(json& material, const GltfBrdf& values, bool has_texture) {
  const auto file_of = [&](std::string_view parameter) {
    const auto found = values.maps.find(parameter);
    return found == values.maps.end() ? std::string() : found->second.file;
  };
  const std::string metallic = file_of("metallic");
  const std::string roughness = file_of("roughness");
  const bool is_one = metallic == roughness || (roughness.empty() && values.roughness == 0) ||
                      (metallic.empty() && values.metallic == 0);
  for (const auto& [parameter, map] : values.maps) {
    const auto row = std::ranges::find(GltfMaps, parameter, &GltfMap::parameter);
    const bool is_base = parameter == "baseColor" && map.channel == grf::ImageChannel::Rgb && !has_texture;
    const bool is_known =
        row != GltfMaps.end() && row->channel == map.channel && (!row->extension.empty() || is_one);
    const int place = is_base || is_known ? texture(map.file) : -1;
    if (!is_base && !is_known) lost_maps_.emplace_back(parameter);
    if (place < 0) continue;
    json& owner = is_base || row->extension.empty()
                      ? material["pbrMetallicRoughness"]
                      : material["extensions"][fmt::format("KHR_materials_{}", row->extension)];
    owner[is_base ? "baseColorTexture" : std::string(row->texture)] = {{"index", place}};
  }
}

int GltfMaterialWriter::material(const grf::Surface& surface, const grf::Scope& scope) {
  const grf::ResolvedSurface resolved = grf::resolve(surface, scope);
  const GltfBrdf values = values_of(resolved);
  json material;
  const std::string name = name_of(surface);
  if (!name.empty()) material["name"] = to_utf8(name);
  json base = factors(values.base);
  base.push_back(1);
  json& pbr = material["pbrMetallicRoughness"];
  pbr = {{"baseColorFactor", base},
         {"metallicFactor", rounded_factor(values.metallic)},
         {"roughnessFactor", rounded_factor(values.roughness)}};
  if (resolved.texture != nullptr) {
    const int place = texture(resolved.texture->file);
    if (place >= 0) pbr["baseColorTexture"] = {{"index", place}};
  }
  add_opacity(material, resolved.opacity);
  add_extensions(material, document_.json(), values);
  add_maps(material, values, resolved.texture != nullptr);
  if (resolved.brdf != nullptr && has_maps(*resolved.brdf) && values.maps.empty())
    lost_maps_.push_back(resolved.brdf->keyword);
  // Reflectance is two-sided in GRF, and emission is not.
  material["doubleSided"] = !resolved.emission;
  if (resolved.emission) emit(material, document_.json(), *resolved.emission);
  // Names of images in extras would not follow the images.
  if (resolved.brdf != nullptr && resolved.brdf->terms.empty() && !has_maps(*resolved.brdf)) {
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
  if (!lost_maps_.empty()) {
    diagnostics_.warning(
        grf::whole_file(path_),
        fmt::format("{} of an image that glTF has not, or by another channel: {}",
                    counted(lost_maps_.size(), "material lost a parameter", "materials lost a parameter"),
                    listed(lost_maps_)));
  }
  warn(unreadable_, "image cannot be read", "images cannot be read");
  warn(unknown_, "image is neither PNG nor JPEG, the formats of glTF",
       "images are neither PNG nor JPEG, the formats of glTF");
}

std::span<const MaterialRule> gltf_material_writer_rules() { return GltfWriterRules; }

}  // namespace convert
