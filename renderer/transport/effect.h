// A render consists of effects, which have names. This is a header only, because options use the names too.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace transport {

enum class Effect : std::uint8_t {
  AreaLights,
  Environment,
  Background,
  DiffuseInterreflection,
  GlossyInterreflection,
  MirrorReflection,
  Transmission,
  Anisotropy,
  Textures,
  Opacity,
  VertexColours,
  InterpolatedNormals,
  MeasuredData,
  Irradiance,
  DepthOfField,
  Instances,
};

struct EffectInfo {
  Effect effect;
  std::string_view name;
  /// The replacement in a render where the effect is switched off.
  std::string_view without;
};

constexpr std::array EffectInfos = {
    EffectInfo{Effect::AreaLights, "area_lights", "lights and faces emit nothing, but still occlude"},
    EffectInfo{Effect::Environment, "environment", "the constant background replaces the environment map"},
    EffectInfo{Effect::Background, "background", "black replaces the constant background and a backplate"},
    EffectInfo{Effect::DiffuseInterreflection, "diffuse_interreflection",
               "faces with neither a glossy nor a specular part reflect light only where the eye sees them, "
               "directly or in mirrors"},
    EffectInfo{Effect::GlossyInterreflection, "glossy_interreflection", "the same for all other faces"},
    EffectInfo{Effect::MirrorReflection, "mirror_reflection",
               "the specular (Dirac delta) part of BRDFs reflects nothing"},
    EffectInfo{Effect::Transmission, "transmission", "glass only reflects"},
    EffectInfo{Effect::Anisotropy, "anisotropy",
               "tangents follow the scene's axes instead of texture coordinates or the axis of the object"},
    EffectInfo{Effect::Textures, "textures", "the face has its own colour only"},
    EffectInfo{Effect::Opacity, "opacity", "all faces are opaque"},
    EffectInfo{Effect::VertexColours, "vertex_colours", "the face has its own colour only"},
    EffectInfo{Effect::InterpolatedNormals, "interpolated_normals", "flat shading by the polygons' normals"},
    EffectInfo{Effect::MeasuredData, "measured_data",
               "the default diffuse BRDF replaces each BRDF that reads a file"},
    EffectInfo{Effect::Irradiance, "irradiance",
               "light is estimated by path tracing, as without BPT_Irradiance"},
    EffectInfo{Effect::DepthOfField, "depth_of_field",
               "a pinhole camera replaces the thin lens: everything is sharp"},
    EffectInfo{Effect::Instances, "instances", "each instance has its own triangles; the image is the same"},
};

constexpr std::string_view name_of(Effect effect) {
  return EffectInfos[static_cast<std::size_t>(effect)].name;
}

class EffectSet {
 public:
  constexpr bool has(Effect effect) const { return (bits_ & bit(effect)) != 0; }
  constexpr void add(Effect effect) { bits_ |= bit(effect); }
  constexpr void remove(Effect effect) { bits_ &= ~bit(effect); }

  static constexpr EffectSet all() {
    EffectSet set;
    for (const EffectInfo& info : EffectInfos) set.add(info.effect);
    return set;
  }
  static constexpr EffectSet all_but(Effect effect) {
    EffectSet set = all();
    set.remove(effect);
    return set;
  }

  bool operator==(const EffectSet&) const = default;

 private:
  static constexpr std::uint32_t bit(Effect effect) { return 1U << static_cast<unsigned>(effect); }

  std::uint32_t bits_ = 0;
};

/// A named set of effects.
struct EffectGroup {
  std::string_view name;
  EffectSet effects;
};

constexpr std::array EffectGroups = [] {
  EffectGroup direct{"direct", EffectSet::all()};
  EffectGroup indirect{"indirect", {}};
  for (const Effect effect : {Effect::DiffuseInterreflection, Effect::GlossyInterreflection}) {
    indirect.effects.add(effect);
    direct.effects.remove(effect);
  }
  direct.effects.remove(Effect::MirrorReflection);
  direct.effects.remove(Effect::Irradiance);
  return std::array{direct, indirect};
}();

/// Returns the names of effects and groups.
inline std::vector<std::string_view> effect_words() {
  std::vector<std::string_view> words;
  for (const EffectInfo& info : EffectInfos) words.push_back(info.name);
  for (const EffectGroup& group : EffectGroups) words.push_back(group.name);
  return words;
}

/// Returns the union of the effects and groups that words of `effect_words` name.
template <class Words>
EffectSet effects_named(const Words& words) {
  EffectSet set;
  for (const std::string_view word : words) {
    for (const EffectInfo& info : EffectInfos) {
      if (info.name == word) set.add(info.effect);
    }
    for (const EffectGroup& group : EffectGroups) {
      if (group.name != word) continue;
      for (const EffectInfo& info : EffectInfos) {
        if (group.effects.has(info.effect)) set.add(info.effect);
      }
    }
  }
  return set;
}

}  // namespace transport
