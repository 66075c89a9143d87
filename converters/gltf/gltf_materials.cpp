#include "converters/gltf/gltf_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "converters/wording.h"
#include "grf/read.h"

namespace convert {
namespace {

using tinygltf::Value;

/// Returns a member of an extension as a number, if it is finite.
double number(const Value& object, const std::string& name, double otherwise) {
  if (!object.Has(name) || !object.Get(name).IsNumber()) return otherwise;
  const double value = object.Get(name).GetNumberAsDouble();
  return std::isfinite(value) ? value : otherwise;
}

template <std::size_t Size>
std::array<double, Size> numbers(const Value& object, const std::string& name,
                                 std::array<double, Size> values) {
  if (!object.Has(name) || object.Get(name).ArrayLen() != Size) return values;
  for (std::size_t i = 0; i < Size; ++i) {
    const Value& item = object.Get(name).Get(static_cast<int>(i));
    if (item.IsNumber() && std::isfinite(item.GetNumberAsDouble())) values[i] = item.GetNumberAsDouble();
  }
  return values;
}

grf::Vec3d to_vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
grf::Vec3d first_three(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

/// Returns the texture that a member of an extension names; -1 if there is none.
int texture_index(const Value& extension, const std::string& name) {
  if (!extension.Has(name) || !extension.Get(name).Has("index")) return -1;
  const Value& index = extension.Get(name).Get("index");
  return index.IsInt() ? index.Get<int>() : -1;
}

const Value* extension_of(const tinygltf::Material& material, const std::string& name) {
  const auto found = material.extensions.find("KHR_materials_" + name);
  return found == material.extensions.end() ? nullptr : &found->second;
}

TextureLookup lookup_of(int set, const Value* transform) {
  TextureLookup lookup;
  lookup.set = set;
  if (transform == nullptr) return lookup;
  lookup.set = static_cast<int>(number(*transform, "texCoord", set));
  lookup.offset = numbers(*transform, "offset", lookup.offset);
  lookup.scale = numbers(*transform, "scale", lookup.scale);
  lookup.rotation = number(*transform, "rotation", 0);
  return lookup;
}

std::string joined(const std::vector<double>& values) { return fmt::format("{}", fmt::join(values, " ")); }

/// The table of conversions by `Reading` and the mapping.
constexpr std::array<MaterialRule, 15> GltfRules = {{
    {"metallic = 1, or D = 0 of specular-glossiness", "`torrance rough=a nreal=1 nimag=100 ks=F0 kd=0`",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 0.5, 0.25, 1], \"roughnessFactor\": 0.5}",
     "torrance rough=0.25 nreal=1 nimag=100 ks=(1, 0.5, 0.25) kd=0", ""},
    {"the same, a < 0.0001", "`specular ks=F0`", "\"pbrMetallicRoughness\": {\"roughnessFactor\": 0}",
     "specular ks=1", ""},
    {"others", "`ashikhmin ex=2/a^2-2 Rs=F0 Rd=D`",
     "\"pbrMetallicRoughness\": {\"metallicFactor\": 0, \"roughnessFactor\": 0.5}",
     "ashikhmin ex=30 Rs=0.04 Rd=1", ""},
    {"the same, where `ex` would pass 1000000", "`coupled Rm=D R0=F0`",
     "\"pbrMetallicRoughness\": {\"metallicFactor\": 0.5, \"roughnessFactor\": 0}", "coupled Rm=0.5 R0=0.52",
     ""},
    {"`KHR_materials_ior`, `KHR_materials_specular`", "they change the 0.04",
     "\"extensions\": {\"KHR_materials_ior\": {\"ior\": 3}}, \"pbrMetallicRoughness\": {\"metallicFactor\": "
     "0, \"roughnessFactor\": 0.5}",
     "ashikhmin ex=30 Rs=0.25 Rd=1", ""},
    {"`KHR_materials_pbrSpecularGlossiness`", "read instead of metallic-roughness",
     "\"extensions\": {\"KHR_materials_pbrSpecularGlossiness\": {\"specularFactor\": [0.25, 0.25, 0.25], "
     "\"glossinessFactor\": 0.5}}",
     "ashikhmin ex=30 Rs=0.25 Rd=1", ""},
    {"F0 = 0", "`diffuse kd=D`",
     "\"extensions\": {\"KHR_materials_specular\": {\"specularFactor\": 0}}, \"pbrMetallicRoughness\": "
     "{\"metallicFactor\": 0}",
     "diffuse kd=1", ""},
    {"`KHR_materials_unlit`", "`diffuse kd=D`, lost",
     "\"extensions\": {\"KHR_materials_unlit\": {}}, \"pbrMetallicRoughness\": {\"metallicFactor\": 0}",
     "diffuse kd=1", "unlit shading"},
    {"`baseColorTexture`", "`texture`, which multiplies all of the BRDF",
     "\"pbrMetallicRoughness\": {\"metallicFactor\": 0, \"baseColorTexture\": {\"index\": 0}}",
     "ashikhmin ex=0 Rs=0.04 Rd=1 texture \"wood.png\"", ""},
    {"`emissiveFactor` times `emissiveStrength` > 0", "`light rgb` on the faces",
     "\"emissiveFactor\": [1, 0.5, 0], \"extensions\": {\"KHR_materials_emissive_strength\": "
     "{\"emissiveStrength\": 8}}",
     "torrance rough=1 nreal=1 nimag=100 ks=1 kd=0 light rgb (8, 4, 0)", ""},
    {"`emissiveTexture`", "lost, and the emission with it",
     "\"emissiveFactor\": [1, 1, 1], \"emissiveTexture\": {\"index\": 0}",
     "torrance rough=1 nreal=1 nimag=100 ks=1 kd=0", "map of emission"},
    {"alpha", "lost", "\"alphaMode\": \"BLEND\"", "torrance rough=1 nreal=1 nimag=100 ks=1 kd=0",
     "transparency"},
    {"other maps", "lost", "\"normalTexture\": {\"index\": 0}",
     "torrance rough=1 nreal=1 nimag=100 ks=1 kd=0", "normal map"},
    {"other extensions", "lost", "\"extensions\": {\"KHR_materials_sheen\": {}}",
     "torrance rough=1 nreal=1 nimag=100 ks=1 kd=0", "what KHR_materials_sheen says"},
    {"`extras` with a BRDF, and the values that were written with it", "exactly that BRDF",
     "\"extras\": {\"grf\": {\"brdf\": \"oren r=0.5\"}}, \"pbrMetallicRoughness\": {\"baseColorFactor\": "
     "[0.5, 0.5, 0.5, 1], \"metallicFactor\": 0}",
     "oren r=0.5", ""},
}};

/// Converts one material of the file to the input of the mapping.
class Reading {
 public:
  Reading(const tinygltf::Material& source, const GltfImages& images) : source_(source), images_(images) {}

  MicrofacetMaterial run() {
    material_.name = source_.name;
    material_.source = "glTF";
    if (const Value* glossiness = extension_of(source_, "pbrSpecularGlossiness")) {
      read(*glossiness);
    } else {
      read(source_.pbrMetallicRoughness);
    }
    if (extension_of(source_, "unlit") != nullptr) {
      material_.specular = grf::Vec3d(0);
      lose(Loss::Unlit);
      say("unlit");
    }
    read_emission();
    count_losses();
    return std::move(material_);
  }

  const TextureLookup& lookup() const { return lookup_; }

  /// Returns the BRDF of GRF in the extras of the material; nothing if there is none or it does not match.
  std::optional<grf::BrdfModel> exact_brdf(grf::Colour& colour) const {
    const Value& extras = grf_extras();
    if (!extras.Has("brdf") || !extras.Get("brdf").IsString()) return std::nullopt;
    grf::Diagnostics ignored_diagnostics;
    auto brdf = grf::read_brdf(extras.Get("brdf").Get<std::string>(), source_.name, ignored_diagnostics);
    const auto rgb = numbers<3>(extras, "rgb", {1, 1, 1});
    colour = grf::Colour(to_vector(rgb));
    if (!brdf || !fits(*brdf, to_vector(rgb))) return std::nullopt;
    return brdf;
  }
  bool has_exact_brdf() const { return grf_extras().Has("brdf"); }
  bool has_exact_colour() const { return grf_extras().Has("rgb"); }

  /// Collects unsupported extensions.
  std::vector<std::string> lost_extensions() const {
    std::vector<std::string> lost;
    for (const auto& [name, extension] : source_.extensions) {
      const bool is_read = name == "KHR_materials_pbrSpecularGlossiness" || name == "KHR_materials_unlit" ||
                           name == "KHR_materials_emissive_strength" || name == "KHR_materials_ior" ||
                           name == "KHR_materials_specular";
      if (!is_read) lost.push_back(name);
    }
    return lost;
  }

 private:
  const Value& grf_extras() const { return source_.extras.Has("grf") ? source_.extras.Get("grf") : nothing_; }

  // The material is unchanged if it is what would be written for the BRDF.
  bool fits(const grf::BrdfModel& brdf, const grf::Vec3d& colour) const {
    constexpr double Rounding = 3e-6;
    const tinygltf::PbrMetallicRoughness& pbr = source_.pbrMetallicRoughness;
    const MetallicRoughness values = metallic_roughness(microfacet_values(brdf_lobes(brdf)));
    bool same = std::abs(values.metallic - pbr.metallicFactor) < Rounding &&
                std::abs(values.roughness - pbr.roughnessFactor) < Rounding &&
                pbr.baseColorFactor.size() == 4;
    for (int i = 0; i < 3 && same; ++i) {
      const double base = std::clamp(values.base_colour[i] * colour[i], 0.0, 1.0);
      same = std::abs(base - pbr.baseColorFactor[static_cast<std::size_t>(i)]) < Rounding;
    }
    return same;
  }

  void read(const tinygltf::PbrMetallicRoughness& pbr) {
    MetallicRoughness values;
    if (pbr.baseColorFactor.size() == 4) values.base_colour = first_three(pbr.baseColorFactor);
    values.metallic = pbr.metallicFactor;
    values.roughness = pbr.roughnessFactor;
    say(fmt::format("baseColorFactor {}", joined(pbr.baseColorFactor)));
    say(fmt::format("metallicFactor {}", pbr.metallicFactor));
    say(fmt::format("roughnessFactor {}", pbr.roughnessFactor));
    const MicrofacetValues facets = microfacet_values(values, dielectric());
    material_.diffuse = facets.diffuse;
    material_.specular = facets.specular;
    material_.slope = facets.slope;
    material_.is_metal = values.metallic >= 1;
    const auto transform = pbr.baseColorTexture.extensions.find("KHR_texture_transform");
    map(pbr.baseColorTexture.index, pbr.baseColorTexture.texCoord,
        transform == pbr.baseColorTexture.extensions.end() ? nullptr : &transform->second);
    if (pbr.metallicRoughnessTexture.index >= 0) lose(Loss::OtherMap);
  }

  void read(const Value& glossiness) {
    const auto diffuse = numbers<4>(glossiness, "diffuseFactor", {1, 1, 1, 1});
    const auto specular = numbers<3>(glossiness, "specularFactor", {1, 1, 1});
    const double rough = 1 - number(glossiness, "glossinessFactor", 1);
    say(fmt::format("diffuseFactor {}", fmt::join(diffuse, " ")));
    say(fmt::format("specularFactor {}", fmt::join(specular, " ")));
    say(fmt::format("glossinessFactor {}", 1 - rough));
    material_.diffuse = {diffuse[0], diffuse[1], diffuse[2]};
    material_.specular = to_vector(specular);
    material_.slope = rough * rough;
    material_.is_metal = material_.diffuse == grf::Vec3d(0);
    const int texture = texture_index(glossiness, "diffuseTexture");
    if (texture >= 0) {
      const Value& info = glossiness.Get("diffuseTexture");
      const Value* transform = nullptr;
      if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform")) {
        transform = &info.Get("extensions").Get("KHR_texture_transform");
      }
      map(texture, static_cast<int>(number(info, "texCoord", 0)), transform);
    }
    if (texture_index(glossiness, "specularGlossinessTexture") >= 0) lose(Loss::OtherMap);
  }

  // Reads KHR_materials_ior and KHR_materials_specular.
  grf::Vec3d dielectric() {
    grf::Vec3d reflectance(0.04);
    if (const Value* ior = extension_of(source_, "ior")) {
      const double index = number(*ior, "ior", 1.5);
      say(fmt::format("ior {}", index));
      const double root = index == 0 ? 1 : (index - 1) / (index + 1);
      reflectance = grf::Vec3d(root * root);
    }
    if (const Value* specular = extension_of(source_, "specular")) {
      const auto colour = numbers<3>(*specular, "specularColorFactor", {1, 1, 1});
      const double factor = number(*specular, "specularFactor", 1);
      say(fmt::format("specularFactor {}; specularColorFactor {}", factor, fmt::join(colour, " ")));
      reflectance *= to_vector(colour);
      for (int i = 0; i < 3; ++i) reflectance[i] = std::min(reflectance[i], 1.0) * factor;
      const bool has_map = texture_index(*specular, "specularTexture") >= 0 ||
                           texture_index(*specular, "specularColorTexture") >= 0;
      if (has_map) lose(Loss::OtherMap);
    }
    return reflectance;
  }

  void map(int texture, int set, const Value* transform) {
    if (texture < 0) return;
    material_.map = images_.texture(texture);
    if (!material_.map) return lose(Loss::TextureImage);
    lookup_ = lookup_of(set, transform);
    if (!images_.repeats(texture)) lose(Loss::TextureWrap);
  }

  // An emissive map is mostly dark as a rule: such faces do not emit at all.
  void read_emission() {
    if (source_.emissiveFactor.size() != 3) return;
    const grf::Vec3d factor = first_three(source_.emissiveFactor);
    const Value* strength = extension_of(source_, "emissive_strength");
    const double times = strength == nullptr ? 1 : number(*strength, "emissiveStrength", 1);
    if (factor == grf::Vec3d(0)) return;
    say(fmt::format("emissiveFactor {}", joined(source_.emissiveFactor)));
    if (strength != nullptr) say(fmt::format("emissiveStrength {}", times));
    if (source_.emissiveTexture.index >= 0) return lose(Loss::EmissionMap);
    material_.emission = factor * times;
    if (source_.doubleSided) lose(Loss::BackEmission);
  }

  void count_losses() {
    if (source_.normalTexture.index >= 0) lose(Loss::NormalMap);
    if (source_.occlusionTexture.index >= 0) lose(Loss::OcclusionMap);
    if (source_.alphaMode != "OPAQUE") {
      lose(Loss::Transparency);
      say("alphaMode " + printable(source_.alphaMode));
    }
    if (source_.doubleSided) say("doubleSided");
  }

  static std::string printable(const std::string& text) {
    std::string printable;
    for (const char c : text) printable += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    return printable;
  }

  void say(std::string value) { material_.source_values.push_back(std::move(value)); }
  void lose(Loss loss) { material_.losses.push_back(loss); }

  const tinygltf::Material& source_;
  const GltfImages& images_;
  const Value nothing_;
  MicrofacetMaterial material_;
  TextureLookup lookup_;
};

}  // namespace

GltfMaterials::GltfMaterials(const GltfFile& file, const GltfImages& images, DefinitionNames& names)
    : file_(file), images_(images), materials_(names) {
  for (std::size_t i = 0; i < file_.model.materials.size(); ++i) add(file_.model.materials[i], i);
}

void GltfMaterials::add(const tinygltf::Material& source, std::size_t index) {
  Reading reading(source, images_);
  MicrofacetMaterial material = reading.run();
  std::replace_if(
      material.name.begin(), material.name.end(), [](char c) { return c == '\n' || c == '\r' || c == '\0'; },
      ' ');
  if (material.name.empty()) material.name = fmt::format("material_{}", index);
  material.location = grf::whole_file(file_.path);
  MappedMaterial mapped = map_material(material);
  grf::Colour colour(1);
  if (auto brdf = reading.exact_brdf(colour)) {
    mapped.definition.body = std::move(*brdf);
    if (reading.has_exact_colour()) mapped.colour = colour;
  } else if (reading.has_exact_brdf()) {
    changed_.push_back(material.name);
  }
  materials_.add(std::move(mapped));
  lookups_.push_back(reading.lookup());
  lost_extensions_.push_back(reading.lost_extensions());
}

grf::Surface GltfMaterials::surface(int material, std::size_t faces, Losses& losses) {
  if (material < 0) return {};
  const auto index = static_cast<std::size_t>(material);
  for (const std::string& extension : lost_extensions_[index]) lost_[extension] += faces;
  return materials_.surface(index, faces, losses);
}

TextureLookup GltfMaterials::lookup(int material) const {
  return material < 0 ? TextureLookup() : lookups_[static_cast<std::size_t>(material)];
}

void GltfMaterials::report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const {
  materials_.report(location, diagnostics);
  if (!changed_.empty()) {
    diagnostics.warning(
        location, fmt::format("{} changed since BRDFs of GRF were written with them: {}",
                              counted(changed_.size(), "material was", "materials were"), listed(changed_)));
  }
  for (const auto& [extension, faces] : lost_) {
    if (faces == 0) continue;
    diagnostics.warning(location, fmt::format("{} what {} says of their material: no BRDF of GRF has it",
                                              counted(faces, "face lost", "faces lost"), extension));
  }
}

std::span<const MaterialRule> gltf_material_rules() { return GltfRules; }

}  // namespace convert
