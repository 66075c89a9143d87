#include "converters/material_mapping.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "converters/mapping_helpers.h"
#include "grf/keywords.h"

namespace convert {
namespace {

/// The smallest exponent of a mirror: exporters write 900 or 1000, the top of their scales.
constexpr double MirrorExponent = 900;
/// The highest exponent of `lewis`: a lobe a tenth of a degree wide.
constexpr double HighestExponent = 1e6;

class Mapping {
 public:
  explicit Mapping(const PhongMaterial& material)
      : material_(material), mapped_(named_material(material.name, material.source, material.source_values)) {
    mapped_.definition.location = material.location;
    mapped_.losses = material.losses;
    mapped_.texture = material.diffuse_map;
  }

  MappedMaterial run() {
    mapped_.definition.body = brdf();
    add_opacity();
    finish(material_.emission, mapped_);
    return std::move(mapped_);
  }

 private:
  void add_opacity() {
    const auto value = static_cast<float>(clamped(material_.opacity, 1, mapped_));
    const bool reads_alpha = material_.reads_alpha && material_.diffuse_map;
    const grf::Opacity opacity{reads_alpha ? grf::Opacity::Kind::Blend : grf::Opacity::Kind::Number, value};
    if (opacity != grf::Opacity()) mapped_.opacity = opacity;
  }

  grf::BrdfModel brdf() {
    if (material_.physically_based) {
      GltfBrdf values = *material_.physically_based;
      values.base = material_.diffuse;
      mapped_.clamped = normalise(values) || mapped_.clamped;
      return to_brdf(values);
    }
    const grf::Vec3d diffuse = clamped(material_.diffuse, 1, mapped_);
    const grf::Vec3d specular = clamped(material_.specular, 1, mapped_);
    if (material_.reflection == Reflection::None || specular == grf::Vec3d(0)) {
      return make_brdf("diffuse", {{"kd", to_value(diffuse)}});
    }
    return with_highlight(diffuse, specular);
  }

  grf::BrdfModel with_highlight(const grf::Vec3d& asked_diffuse, const grf::Vec3d& specular) {
    const grf::Vec3d diffuse = beside(specular, asked_diffuse);
    const bool mirror = material_.reflection == Reflection::Mirror &&
                        material_.exponent.value_or(MirrorExponent) >= MirrorExponent;
    if (mirror && diffuse == grf::Vec3d(0)) return make_brdf("specular", {{"ks", to_value(specular)}});
    std::vector<std::pair<std::string, grf::Value>> values;
    if (mirror) {
      values.emplace_back("n", static_cast<float>(HighestExponent));
    } else if (material_.exponent) {
      values.emplace_back("n", static_cast<float>(clamped(*material_.exponent, HighestExponent, mapped_)));
    }
    values.emplace_back("ks", to_value(specular));
    values.emplace_back("kd", to_value(diffuse));
    return make_brdf("lewis", values);
  }

  // The diffuse reflectance is limited to 1 minus the specular one, to conserve energy.
  grf::Vec3d beside(const grf::Vec3d& specular, const grf::Vec3d& diffuse) {
    const grf::Vec3d room = grf::Vec3d(1) - specular;
    const grf::Vec3d reduced(std::min(diffuse.x, room.x), std::min(diffuse.y, room.y),
                             std::min(diffuse.z, room.z));
    if (reduced != diffuse) {
      mapped_.definition.comments.before.emplace_back(
          " kd is smaller than the original, so that ks + kd is not over 1");
    }
    return reduced;
  }

  const PhongMaterial& material_;
  MappedMaterial mapped_;
};

}  // namespace

MappedMaterial map_material(const PhongMaterial& material) { return Mapping(material).run(); }

PhongMaterial phong_material(const BrdfLobes& lobes) {
  /// The exponent of a mirror in MTL files.
  constexpr double WrittenMirrorExponent = 1000;
  PhongMaterial material;
  material.diffuse = lobes.diffuse;
  material.specular = lobes.glossy;
  if (lobes.glossy == grf::Vec3d(0)) {
    material.reflection = Reflection::None;
  } else if (std::isinf(lobes.exponent)) {
    material.reflection = Reflection::Mirror;
    material.exponent = WrittenMirrorExponent;
  } else {
    material.exponent = std::min(to_phong_exponent(lobes.exponent), HighestExponent);
  }
  return material;
}

MappedMaterial unknown_material(const std::string& name, const grf::BrdfModel& brdf) {
  MappedMaterial material;
  material.definition.name = grf::to_identifier(name);
  material.definition.body = brdf;
  if (material.definition.name != name) material.definition.comments.before.push_back(" \"" + name + "\"");
  material.definition.comments.before.emplace_back(" defined in no material library");
  return material;
}

grf::BrdfModel default_brdf() { return make_brdf("diffuse", {{"kd", 0.5F}}); }

}  // namespace convert
