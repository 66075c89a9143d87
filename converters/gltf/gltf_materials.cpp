#include "converters/gltf/gltf_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "converters/gltf/gltf_brdf.h"
#include "converters/gltf/gltf_maps.h"
#include "converters/mapping_helpers.h"
#include "converters/wording.h"
#include "grf/read.h"

namespace convert {
namespace {

using tinygltf::Value;

/// The `specularColor` that makes any reflectance at the default index of refraction, 0.04, at least 1.
constexpr double ColourOfFullReflectance = 25;

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

/// A texture of the file, with the coordinates by which it is read.
struct TextureUse {
  int index = -1;  ///< -1: there is none
  TextureLookup lookup;
};

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

/// Returns the texture that a member of an extension names.
TextureUse texture_use(const Value& extension, const std::string& name) {
  if (!extension.Has(name) || !extension.Get(name).Has("index")) return {};
  const Value& info = extension.Get(name);
  const Value* transform = nullptr;
  if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform"))
    transform = &info.Get("extensions").Get("KHR_texture_transform");
  const Value& index = info.Get("index");
  return {index.IsInt() ? index.Get<int>() : -1,
          lookup_of(static_cast<int>(number(info, "texCoord", 0)), transform)};
}

TextureUse texture_use(const tinygltf::TextureInfo& info) {
  const auto transform = info.extensions.find("KHR_texture_transform");
  return {info.index,
          lookup_of(info.texCoord, transform == info.extensions.end() ? nullptr : &transform->second)};
}

const Value* extension_of(const tinygltf::Material& material, const std::string& name) {
  const auto found = material.extensions.find("KHR_materials_" + name);
  return found == material.extensions.end() ? nullptr : &found->second;
}

std::string joined(const std::vector<double>& values) { return fmt::format("{}", fmt::join(values, " ")); }

/// Extensions of materials that are read.
constexpr std::array<std::string_view, 11> ReadExtensions = {"pbrSpecularGlossiness",
                                                             "unlit",
                                                             "emissive_strength",
                                                             "ior",
                                                             "specular",
                                                             "anisotropy",
                                                             "clearcoat",
                                                             "sheen",
                                                             "iridescence",
                                                             "transmission",
                                                             "volume"};

/// Converts one material of the file.
class Reading {
 public:
  Reading(const tinygltf::Material& source, const GltfImages& images) : source_(source), images_(images) {
    if (const Value* glossiness = extension_of(source_, "pbrSpecularGlossiness")) {
      read(*glossiness);
    } else {
      read(source_.pbrMetallicRoughness);
      read_dielectric();
      read_transmission();
    }
    read_layers();
    is_clamped_ = normalise(values_);
    if (values_.is_glass() && !values_.maps.empty()) lose(Loss::OtherMap);
    if (extension_of(source_, "unlit") != nullptr) {
      is_unlit_ = true;
      lose(Loss::Unlit);
      say("unlit");
    }
    read_emission();
    count_losses();
  }

  MappedMaterial material(const std::string& name, const std::string& path) const {
    MappedMaterial material = named_material(name, "glTF", said_);
    material.definition.location = grf::whole_file(path);
    material.losses = losses_;
    material.texture = map_;
    material.opacity = opacity();
    material.clamped = is_clamped_;
    material.definition.body =
        is_unlit_ ? make_brdf("diffuse", {{"kd", to_value(values_.base)}}) : to_brdf(values_);
    finish(emission_, material);
    return material;
  }

  TextureLookup lookup() const { return lookup_.value_or(TextureLookup()); }

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
      const auto is_called = [&name = name](const auto& read) {
        return name == fmt::format("KHR_materials_{}", read);
      };
      if (std::none_of(ReadExtensions.begin(), ReadExtensions.end(), is_called)) lost.push_back(name);
    }
    return lost;
  }

 private:
  const Value& grf_extras() const { return source_.extras.Has("grf") ? source_.extras.Get("grf") : nothing_; }

  // The material is unchanged if it is what would be written for the BRDF.
  bool fits(const grf::BrdfModel& brdf, const grf::Vec3d& colour) const {
    GltfBrdf written = nearest_gltf(brdf, {});
    written.base *= colour;
    normalise(written);
    return !is_unlit_ && is_nearly_equal(written, values_);
  }

  void read(const tinygltf::PbrMetallicRoughness& pbr) {
    if (pbr.baseColorFactor.size() == 4) {
      values_.base = first_three(pbr.baseColorFactor);
      alpha_ = pbr.baseColorFactor[3];
    }
    values_.metallic = pbr.metallicFactor;
    values_.roughness = pbr.roughnessFactor;
    say(fmt::format("baseColorFactor {}", joined(pbr.baseColorFactor)));
    say(fmt::format("metallicFactor {}", pbr.metallicFactor));
    say(fmt::format("roughnessFactor {}", pbr.roughnessFactor));
    map(texture_use(pbr.baseColorTexture));
    for (const GltfMap& map : GltfMaps) {
      if (map.extension.empty()) vary(map, texture_use(pbr.metallicRoughnessTexture));
    }
  }

  // A dielectric over a diffuse base says it exactly, also where its specular reflectance is a metal's.
  void read(const Value& glossiness) {
    const auto diffuse = numbers<4>(glossiness, "diffuseFactor", {1, 1, 1, 1});
    const auto specular = numbers<3>(glossiness, "specularFactor", {1, 1, 1});
    const double gloss = number(glossiness, "glossinessFactor", 1);
    say(fmt::format("diffuseFactor {}", fmt::join(diffuse, " ")));
    say(fmt::format("specularFactor {}", fmt::join(specular, " ")));
    say(fmt::format("glossinessFactor {}", gloss));
    values_.base = {diffuse[0], diffuse[1], diffuse[2]};
    alpha_ = diffuse[3];
    values_.specular_colour = to_vector(specular) * ColourOfFullReflectance;
    values_.roughness = 1 - gloss;
    map(texture_use(glossiness, "diffuseTexture"));
    lose_maps(glossiness, {"specularGlossinessTexture"});
  }

  // Reads KHR_materials_ior and KHR_materials_specular.
  void read_dielectric() {
    if (const Value* ior = extension_of(source_, "ior")) {
      values_.ior = number(*ior, "ior", values_.ior);
      say(fmt::format("ior {}", values_.ior));
    }
    if (const Value* specular = extension_of(source_, "specular")) {
      const auto colour = numbers<3>(*specular, "specularColorFactor", {1, 1, 1});
      values_.specular = number(*specular, "specularFactor", 1);
      values_.specular_colour = to_vector(colour);
      say(fmt::format("specularFactor {}; specularColorFactor {}", values_.specular, fmt::join(colour, " ")));
      vary_by(*specular, "specular");
    }
    move_ior_into_range();
  }

  // Only the product of the colour and the reflectance of the index, which an index of 0 makes 1, matters.
  void move_ior_into_range() {
    constexpr double LargestIor = 10;
    grf::Vec3d& colour = values_.specular_colour;
    const bool is_in_range = values_.ior != 0 && values_.ior <= LargestIor &&
                             std::max({colour.x, colour.y, colour.z}) <= ColourOfFullReflectance;
    if (is_in_range) return;
    const double ior = std::max(values_.ior, 1.0);
    const double root = values_.ior == 0 ? 1 : (ior - 1) / (ior + 1);
    for (int i = 0; i < 3; ++i) colour[i] = std::min(colour[i] * root * root, 1.0) * ColourOfFullReflectance;
    values_.ior = GltfBrdf().ior;
  }

  // Reads KHR_materials_transmission and KHR_materials_volume. What is neither clear nor opaque is taken for
  // the nearer of both.
  void read_transmission() {
    const Value* transmission = extension_of(source_, "transmission");
    if (transmission == nullptr) return;
    values_.transmission = number(*transmission, "transmissionFactor", 0);
    say(fmt::format("transmissionFactor {}", values_.transmission));
    lose_maps(*transmission, {"transmissionTexture"});
    constexpr double Smooth = 0.05;
    const bool is_rough = values_.roughness > Smooth || values_.metallic > 0;
    const bool is_partial = values_.transmission > 0 && values_.transmission < 1;
    if (is_partial || (values_.is_glass() && is_rough)) lose(Loss::Transmission);
    const Value* volume = extension_of(source_, "volume");
    if (volume == nullptr || !values_.is_glass()) return;
    values_.thickness = number(*volume, "thicknessFactor", 0);
    values_.attenuation_distance = number(*volume, "attenuationDistance", values_.attenuation_distance);
    values_.attenuation_colour = clamped(to_vector(numbers<3>(*volume, "attenuationColor", {1, 1, 1})));
    say(fmt::format("thicknessFactor {}; attenuationDistance {}", values_.thickness,
                    values_.attenuation_distance));
    lose_maps(*volume, {"thicknessTexture"});
    if (values_.thickness > 0 && values_.base != grf::Vec3d(1)) lose(Loss::Transmission);
  }

  static grf::Vec3d clamped(const grf::Vec3d& v) {
    return {std::clamp(v.x, 0.0, 1.0), std::clamp(v.y, 0.0, 1.0), std::clamp(v.z, 0.0, 1.0)};
  }

  // Reads KHR_materials_anisotropy, KHR_materials_clearcoat, KHR_materials_sheen and
  // KHR_materials_iridescence.
  void read_layers() {
    if (const Value* anisotropy = extension_of(source_, "anisotropy")) {
      values_.anisotropy = number(*anisotropy, "anisotropyStrength", 0);
      const double rotation = number(*anisotropy, "anisotropyRotation", 0);
      values_.rotation = std::remainder(rotation, 2 * std::numbers::pi);
      say(fmt::format("anisotropyStrength {}; anisotropyRotation {}", values_.anisotropy, rotation));
      lose_maps(*anisotropy, {"anisotropyTexture"});
    }
    if (const Value* coat = extension_of(source_, "clearcoat")) {
      values_.clearcoat = number(*coat, "clearcoatFactor", 0);
      values_.coat_roughness = number(*coat, "clearcoatRoughnessFactor", 0);
      say(fmt::format("clearcoatFactor {}; clearcoatRoughnessFactor {}", values_.clearcoat,
                      values_.coat_roughness));
      vary_by(*coat, "clearcoat");
      if (texture_use(*coat, "clearcoatNormalTexture").index >= 0) lose(Loss::NormalMap);
    }
    if (const Value* sheen = extension_of(source_, "sheen")) {
      constexpr double LeastRoughness = 0.01;
      const auto colour = numbers<3>(*sheen, "sheenColorFactor", {0, 0, 0});
      const double roughness = number(*sheen, "sheenRoughnessFactor", 0);
      values_.sheen_colour = to_vector(colour);
      // The range of glTF begins at 0.
      values_.sheen_roughness = roughness >= 0 ? std::max(roughness, LeastRoughness) : roughness;
      say(fmt::format("sheenColorFactor {}; sheenRoughnessFactor {}", fmt::join(colour, " "), roughness));
      vary_by(*sheen, "sheen");
    }
    if (const Value* film = extension_of(source_, "iridescence")) {
      values_.iridescence = number(*film, "iridescenceFactor", 0);
      values_.iridescence_ior = number(*film, "iridescenceIor", values_.iridescence_ior);
      // Without a map of it, this is the thickness.
      values_.film_thickness = number(*film, "iridescenceThicknessMaximum", values_.film_thickness);
      say(fmt::format("iridescenceFactor {}; iridescenceIor {}; iridescenceThicknessMaximum {}",
                      values_.iridescence, values_.iridescence_ior, values_.film_thickness));
      vary_by(*film, "iridescence");
      // The thickness lies between both, and a map of GRF is a factor.
      const bool is_product = number(*film, "iridescenceThicknessMinimum", 100) == 0;
      if (!is_product && values_.maps.erase("filmThickness") > 0) lose(Loss::OtherMap);
    }
  }

  void map(const TextureUse& use) {
    if (use.index < 0) return;
    map_ = image_of(use);
    if (map_) lookup_ = use.lookup;
  }

  std::optional<grf::Texture> image_of(const TextureUse& use) {
    auto image = images_.texture(use.index);
    if (!image) lose(Loss::TextureImage);
    if (image && !images_.repeats(use.index)) lose(Loss::TextureWrap);
    return image;
  }

  /// Lets an image vary a parameter. All images of a face have the same texture coordinates in GRF.
  void vary(const GltfMap& map, const TextureUse& use) {
    if (use.index < 0) return;
    if (lookup_ && *lookup_ != use.lookup) return lose(Loss::OtherMap);
    const auto image = image_of(use);
    if (!image) return;
    lookup_ = use.lookup;
    values_.maps[map.parameter] = {image->file, map.channel};
  }
  void vary_by(const Value& extension, std::string_view name) {
    for (const GltfMap& map : GltfMaps) {
      if (map.extension == name) vary(map, texture_use(extension, std::string(map.texture)));
    }
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
    emission_ = factor * times;
    if (source_.doubleSided) lose(Loss::BackEmission);
  }

  void count_losses() {
    if (source_.normalTexture.index >= 0) lose(Loss::NormalMap);
    if (source_.occlusionTexture.index >= 0) lose(Loss::OcclusionMap);
    if (source_.alphaMode != "OPAQUE") say("alphaMode " + printable(source_.alphaMode));
    if (source_.alphaMode == "MASK") say(fmt::format("alphaCutoff {}", source_.alphaCutoff));
    if (source_.doubleSided) say("doubleSided");
  }

  // A factor of alpha is the same as its inverse in the cutoff.
  std::optional<grf::Opacity> opacity() const {
    using Kind = grf::Opacity::Kind;
    const double alpha = std::clamp(alpha_, 0.0, 1.0);
    if (source_.alphaMode == "MASK") {
      const double cutoff = std::max(source_.alphaCutoff, 0.0);
      if (alpha < cutoff) return grf::Opacity{Kind::Number, 0};
      if (!map_ || cutoff == 0) return std::nullopt;
      return grf::Opacity{Kind::Mask, static_cast<float>(cutoff / alpha)};
    }
    if (source_.alphaMode != "BLEND") return std::nullopt;
    const grf::Opacity opacity{map_ ? Kind::Blend : Kind::Number, static_cast<float>(alpha)};
    return opacity == grf::Opacity() ? std::nullopt : std::optional(opacity);
  }

  static std::string printable(const std::string& text) {
    std::string printable;
    for (const char c : text) printable += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    return printable;
  }

  void say(std::string value) { said_.push_back(std::move(value)); }

  // Loses a feature once, since losses are counted by face.
  void lose(Loss loss) {
    if (std::find(losses_.begin(), losses_.end(), loss) == losses_.end()) losses_.push_back(loss);
  }
  void lose_maps(const Value& extension, std::initializer_list<const char*> names) {
    for (const char* name : names) {
      if (texture_use(extension, name).index >= 0) lose(Loss::OtherMap);
    }
  }

  const tinygltf::Material& source_;
  const GltfImages& images_;
  const Value nothing_;
  GltfBrdf values_;
  double alpha_ = 1;  ///< of the base colour
  bool is_clamped_ = false;
  bool is_unlit_ = false;
  grf::Vec3d emission_ = grf::Vec3d(0);  ///< radiance, W/(sr m2)
  std::optional<grf::Texture> map_;
  std::optional<TextureLookup> lookup_;  ///< of all images
  std::vector<std::string> said_;        ///< the values of the file
  std::vector<Loss> losses_;
};

}  // namespace

GltfMaterials::GltfMaterials(const GltfFile& file, const GltfImages& images, DefinitionNames& names)
    : file_(file), images_(images), materials_(names) {
  for (std::size_t i = 0; i < file_.model.materials.size(); ++i) add(file_.model.materials[i], i);
}

void GltfMaterials::add(const tinygltf::Material& source, std::size_t index) {
  const Reading reading(source, images_);
  std::string name = source.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r' || c == '\0'; }, ' ');
  if (name.empty()) name = fmt::format("material_{}", index);
  MappedMaterial mapped = reading.material(name, file_.path);
  grf::Colour colour(1);
  if (auto brdf = reading.exact_brdf(colour)) {
    mapped.definition.body = std::move(*brdf);
    if (reading.has_exact_colour()) mapped.colour = colour;
  } else if (reading.has_exact_brdf()) {
    changed_.push_back(name);
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

}  // namespace convert
