#include "converters/assimp/assimp_materials.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>
#include <string>

#include <fmt/format.h>

#include "converters/assimp/assimp_import.h"
#include "converters/wording.h"

namespace convert {
namespace {

/// Returns the shortest decimal of a float as a double, so that 0.9 stays 0.9.
double as_written(float value) {
  const std::string text = fmt::format("{}", value);
  double number = value;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

std::optional<double> number_of(const aiMaterial& material, const char* key, unsigned type = 0,
                                unsigned index = 0) {
  float value = 0;
  if (material.Get(key, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value)) return {};
  return as_written(value);
}

std::optional<grf::Vec3d> colour_of(const aiMaterial& material, const char* key, unsigned type = 0,
                                    unsigned index = 0) {
  aiColor3D c;
  if (material.Get(key, type, index, c) != aiReturn_SUCCESS) return {};
  if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) return {};
  return grf::Vec3d(as_written(c.r), as_written(c.g), as_written(c.b));
}

// Assimp's data can be unaligned, and so is copied.
template <class T>
std::string numbers_text(const aiMaterialProperty& property) {
  constexpr std::size_t MostNumbers = 16;
  const std::size_t count = property.mDataLength / sizeof(T);
  std::string text;
  for (std::size_t i = 0; i < std::min(count, MostNumbers); ++i) {
    T value;
    std::memcpy(&value, property.mData + i * sizeof(T), sizeof(T));
    text += fmt::format(" {}", value);
  }
  return count > MostNumbers ? fmt::format("{} and {} more", text, count - MostNumbers) : text;
}

std::string value_text(const aiMaterial& material, const aiMaterialProperty& property) {
  switch (property.mType) {
    case aiPTI_Float:
      return numbers_text<float>(property);
    case aiPTI_Double:
      return numbers_text<double>(property);
    case aiPTI_Integer:
      return numbers_text<int>(property);
    case aiPTI_String: {
      aiString string;
      material.Get(property.mKey.C_Str(), property.mSemantic, property.mIndex, string);
      return " " + text_of(string);
    }
    default:
      return fmt::format(" ({})", counted(property.mDataLength, "byte", "bytes"));
  }
}

/// Formats a property, such as `diffuse 0.5 0.5 0.5` or `file Diffuse wood.png`: Assimp's name without its
/// prefix.
std::string property_text(const aiMaterial& material, const aiMaterialProperty& property) {
  std::string text = text_of(property.mKey);
  text.erase(0, text.find('.') == std::string::npos ? 0 : text.find('.') + 1);
  if (property.mSemantic != aiTextureType_NONE) {
    const auto type = static_cast<aiTextureType>(property.mSemantic);
    text += fmt::format(" {}", aiTextureTypeToString(type));
  }
  if (property.mIndex > 0) text += fmt::format(" [{}]", property.mIndex);
  return text + value_text(material, property);
}

std::vector<std::string> values_of(const aiMaterial& material) {
  std::vector<std::string> values;
  for (const aiMaterialProperty* property : std::span(material.mProperties, material.mNumProperties)) {
    const bool is_name = std::strcmp(property->mKey.C_Str(), "?mat.name") == 0;
    if (!is_name) values.push_back(property_text(material, *property));
  }
  return values;
}

int shading_of(const aiMaterial& material) {
  int shading = 0;
  material.Get(AI_MATKEY_SHADING_MODEL, shading);
  return shading;
}

/// Returns whether a shading model has a highlight: otherwise Assimp may have invented a specular colour.
bool has_highlight(int shading) {
  constexpr std::array<int, 5> Matt = {aiShadingMode_Flat, aiShadingMode_Gouraud, aiShadingMode_OrenNayar,
                                       aiShadingMode_Minnaert, aiShadingMode_NoShading};
  return std::find(Matt.begin(), Matt.end(), shading) == Matt.end();
}

/// Returns the losses of faces with a material, each kind once.
std::vector<Loss> losses_of(const aiMaterial& material) {
  std::vector<Loss> losses;
  const auto lose_if = [&losses](bool is_lost, Loss loss) {
    const bool is_known = std::find(losses.begin(), losses.end(), loss) != losses.end();
    if (is_lost && !is_known) losses.push_back(loss);
  };
  lose_if(number_of(material, AI_MATKEY_OPACITY).value_or(1) < 1, Loss::Transparency);
  for (int i = aiTextureType_DIFFUSE; i <= aiTextureType_TRANSMISSION; ++i) {
    const auto type = static_cast<aiTextureType>(i);
    const unsigned count = material.GetTextureCount(type);
    if (type == aiTextureType_DIFFUSE || type == aiTextureType_BASE_COLOR) {
      lose_if(count > 1, Loss::OtherMap);
    } else if (type == aiTextureType_HEIGHT || type == aiTextureType_NORMALS ||
               type == aiTextureType_NORMAL_CAMERA || type == aiTextureType_DISPLACEMENT) {
      lose_if(count > 0, Loss::BumpMap);
    } else if (type == aiTextureType_EMISSIVE || type == aiTextureType_EMISSION_COLOR) {
      lose_if(count > 0, Loss::EmissionMap);
    } else if (type == aiTextureType_OPACITY || type == aiTextureType_TRANSMISSION) {
      lose_if(count > 0, Loss::Transparency);
    } else {
      lose_if(count > 0, Loss::OtherMap);
    }
  }
  return losses;
}

void read_diffuse_map(const aiMaterial& material, AssimpMaterial& result) {
  for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
    aiString file;
    if (material.Get(AI_MATKEY_TEXTURE(type, 0), file) != aiReturn_SUCCESS || file.length == 0) continue;
    result.phong.diffuse_map = grf::Texture{text_of(file), {}};
    int uv_set = 0;
    material.Get(AI_MATKEY_UVWSRC(type, 0), uv_set);
    if (uv_set > 0) result.uv_set = static_cast<unsigned>(uv_set);
    aiUVTransform t;
    if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), t) == aiReturn_SUCCESS) {
      const UvPlacement placement = {
          {t.mTranslation.x, t.mTranslation.y}, {t.mScaling.x, t.mScaling.y}, t.mRotation};
      const bool moves =
          placement.offset != grf::Vec2f(0) || placement.scale != grf::Vec2f(1) || placement.angle != 0;
      if (moves) result.placement = placement;
    }
    return;
  }
}

/// The table of conversions by `read_material` and the mapping; examples are written as in comments.
constexpr std::array<MaterialRule, 13> AssimpMaterialRules = {{
    {"shading flat, Gouraud, Oren-Nayar, Minnaert or none, or no specular colour", "`diffuse kd=diffuse`",
     "AC3D: shadingm 2; diffuse 0.5; specular 0.25", "diffuse kd=0.5", ""},
    {"other shading or none given, specular colour times its strength > 0",
     "`lewis n=shininess ks=specular kd=diffuse`",
     "FBX: shadingm 3; diffuse 0.5; specular 0.5; shinpercent 0.5; shininess 20", "lewis n=20 ks=0.25 kd=0.5",
     ""},
    {"shading of Blinn, and all of AC3D and X, whose exponents are of the half vector", "`n` = shininess/4",
     "COLLADA: shadingm 4; diffuse 0.5; specular 0.25; shininess 20", "lewis n=5 ks=0.25 kd=0.5", ""},
    {"shininess of 3DS, a percentage p", "`n` = 2^(p/10), as in 3D Studio",
     "3DS: shadingm 3; diffuse 0.5; specular 0.25; shininess 50", "lewis n=32 ks=0.25 kd=0.5", ""},
    {"a diffuse map", "`texture`, which multiplies all of the BRDF", "LWO: diffuse 0.5; file wood.png",
     "diffuse kd=0.5 texture \"wood.png\"", ""},
    {"the same in 3DS, COLLADA and FBX", "replaces the diffuse colour", "FBX: diffuse 0.5; file wood.png",
     "diffuse kd=1 texture \"wood.png\"", ""},
    {"emissive colour > 0", "`light rgb` on the faces", "X: diffuse 0.5; emissive 3",
     "diffuse kd=0.5 light rgb (3, 3, 3)", ""},
    {"the same in 3DS", "a fraction of the diffuse colour", "3DS: diffuse 0.5; emissive 0.5",
     "diffuse kd=0.5 light rgb (0.25, 0.25, 0.25)", ""},
    {"no shading in COLLADA", "no reflection", "COLLADA: shadingm 9; diffuse 0.5; emissive 3",
     "diffuse kd=0 light rgb (3, 3, 3)", ""},
    {"opacity < 1", "lost", "3DS: diffuse 0.5; opacity 0.5", "diffuse kd=0.5", "transparency"},
    {"other maps", "lost", "3DS: diffuse 0.5; bump wood.png", "diffuse kd=0.5", "bump map"},
    {"metallic or roughness",
     "`gltf` with these, base colour, index, anisotropy, clear coat and sheen; the specular colour has no "
     "effect",
     "FBX: diffuse 0.5; roughnessFactor 0.25; metallicFactor 1",
     "gltf baseColor=0.5 metallic=1 roughness=0.25", ""},
    {"all others", "kept only in the comment", "3DS: diffuse 0.5; ambient 0.5", "diffuse kd=0.5", ""},
}};

/// 3D Studio's percentage of glossiness is a logarithm of the exponent, which goes up to 1024.
double exponent_of_percentage(double percentage) { return std::exp2(percentage / 10); }

/// Restores a percentage that Assimp converted in float, which makes 0.19999999 of 20.
double strength_of(const aiMaterial& material) {
  constexpr double Digits = 1e6;
  return std::round(number_of(material, AI_MATKEY_SHININESS_STRENGTH).value_or(1) * Digits) / Digits;
}

void read_reflection(const aiMaterial& material, const AssimpRules& rules, PhongMaterial& phong) {
  const int shading = shading_of(material);
  if (!has_highlight(shading)) phong.reflection = Reflection::None;
  phong.specular =
      colour_of(material, AI_MATKEY_COLOR_SPECULAR).value_or(grf::Vec3d(0)) * strength_of(material);
  phong.exponent = number_of(material, AI_MATKEY_SHININESS);
  if (phong.exponent && rules.shininess_is_percentage) {
    phong.exponent = exponent_of_percentage(*phong.exponent);
  } else if (phong.exponent && (shading == aiShadingMode_Blinn || rules.exponent_is_of_half_vector)) {
    phong.exponent = to_phong_exponent(*phong.exponent);
  }
  if (shading == aiShadingMode_NoShading && rules.unlit_has_no_reflection) phong.diffuse = grf::Vec3d(0);
}

/// Reads physically based parameters, if the material has a roughness or is metallic.
std::optional<GltfBrdf> physically_based(const aiMaterial& material) {
  const auto metallic = number_of(material, AI_MATKEY_METALLIC_FACTOR);
  const auto roughness = number_of(material, AI_MATKEY_ROUGHNESS_FACTOR);
  if (!metallic && !roughness) return std::nullopt;
  GltfBrdf values;
  const auto assign = [](double& target, std::optional<double> value) { target = value.value_or(target); };
  assign(values.metallic, metallic);
  assign(values.roughness, roughness);
  assign(values.anisotropy, number_of(material, AI_MATKEY_ANISOTROPY_FACTOR));
  assign(values.clearcoat, number_of(material, AI_MATKEY_CLEARCOAT_FACTOR));
  assign(values.coat_roughness, number_of(material, AI_MATKEY_CLEARCOAT_ROUGHNESS_FACTOR));
  assign(values.sheen_roughness, number_of(material, AI_MATKEY_SHEEN_ROUGHNESS_FACTOR));
  values.sheen_colour = colour_of(material, AI_MATKEY_SHEEN_COLOR_FACTOR).value_or(values.sheen_colour);
  const auto index = number_of(material, AI_MATKEY_REFRACTI);
  if (index.value_or(0) > 1) values.ior = *index;
  return values;
}

}  // namespace

grf::Vec2f UvPlacement::operator()(const grf::Vec2f& uv) const {
  const grf::Vec2f centre(0.5F);
  const grf::Vec2f p = uv + offset - centre;
  const grf::Vec2f turned(std::cos(angle) * p.x - std::sin(angle) * p.y,
                          std::sin(angle) * p.x + std::cos(angle) * p.y);
  return scale * turned + centre;
}

AssimpMaterial read_material(const aiMaterial& material, const AssimpRules& rules) {
  AssimpMaterial result;
  PhongMaterial& phong = result.phong;
  phong.name = text_of(material.GetName());
  if (phong.name.empty()) phong.name = "material";
  phong.source = rules.source;
  phong.source_values = values_of(material);
  phong.losses = losses_of(material);
  if (const auto diffuse = colour_of(material, AI_MATKEY_COLOR_DIFFUSE)) {
    phong.diffuse = *diffuse;
  } else if (const auto base = colour_of(material, AI_MATKEY_BASE_COLOR)) {
    phong.diffuse = *base;
  }
  phong.emission = colour_of(material, AI_MATKEY_COLOR_EMISSIVE).value_or(grf::Vec3d(0)) *
                   number_of(material, AI_MATKEY_EMISSIVE_INTENSITY).value_or(1);
  if (rules.emission_is_of_diffuse) phong.emission *= phong.diffuse;
  read_diffuse_map(material, result);
  if (phong.diffuse_map && rules.map_replaces_diffuse) phong.diffuse = grf::Vec3d(1);
  read_reflection(material, rules, phong);
  phong.physically_based = physically_based(material);
  return result;
}

bool is_invented(const aiMaterial& material, const AssimpRules& rules) {
  if (!rules.has_materials) return true;
  const std::string name = text_of(material.GetName());
  // A file may have a material of the first name, which then has more properties than a name and a colour.
  return (name == AI_DEFAULT_MATERIAL_NAME && material.mNumProperties <= 2) || name == "%%%DEFAULT";
}

std::span<const MaterialRule> assimp_material_rules() { return AssimpMaterialRules; }

}  // namespace convert
