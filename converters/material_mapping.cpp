#include "converters/material_mapping.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "grf/keywords.h"

namespace convert {
namespace {

/// Exporters write a mirror's exponent as 900 or 1000, the top of their scales.
constexpr double MirrorExponent = 900;
/// The highest that `lewis` has: a lobe of a tenth of a degree.
constexpr double HighestExponent = 1e6;

grf::Value to_value(const grf::Vec3d& v) {
  if (v.x == v.y && v.y == v.z) return static_cast<float>(v.x);
  return grf::Colour(v);
}

grf::BrdfModel make_brdf(std::string keyword, const std::vector<std::pair<std::string, grf::Value>>& values) {
  grf::BrdfModel brdf;
  brdf.keyword = std::move(keyword);
  for (const auto& [name, value] : values) brdf.arguments.push_back({name, value, {}});
  return brdf;
}

/// The lines of a comment, each of them as many of the texts as go on it.
void append_wrapped(std::vector<std::string>& lines, std::string heading,
                    const std::vector<std::string>& texts) {
  constexpr std::size_t LongestLine = 100;
  constexpr std::string_view Separator = "; ";
  std::string line = std::move(heading);
  bool empty = true;
  for (const std::string& text : texts) {
    if (!empty && line.size() + Separator.size() + text.size() > LongestLine) {
      lines.push_back(line + ";");
      line = "  ";
      empty = true;
    }
    line.append(empty ? " " : Separator).append(text);
    empty = false;
  }
  lines.push_back(line);
}

class Mapping {
 public:
  explicit Mapping(const PhongMaterial& material) : material_(material) {
    mapped_.definition.name = grf::to_identifier(material.name);
    mapped_.definition.location = material.location;
    mapped_.losses = material.losses;
    mapped_.texture = material.diffuse_map;
  }

  MappedMaterial run() {
    const bool is_named_otherwise = mapped_.definition.name != material_.name && !material_.name.empty();
    if (is_named_otherwise) note(" \"" + material_.name + "\"");
    if (!material_.source_values.empty())
      append_wrapped(comments(), " " + std::string(material_.source) + ":", material_.source_values);
    mapped_.definition.body = brdf();
    if (mapped_.clamped) note(" values out of range were clamped");
    const grf::Vec3d emission = clamped(material_.emission, std::numeric_limits<float>::max());
    if (emission != grf::Vec3d(0)) mapped_.emission = grf::Colour(emission);
    return std::move(mapped_);
  }

 private:
  grf::BrdfModel brdf() {
    const grf::Vec3d diffuse = clamped(material_.diffuse, 1);
    const grf::Vec3d specular = clamped(material_.specular, 1);
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
      values.emplace_back("n", static_cast<float>(clamped(*material_.exponent, HighestExponent)));
    }
    values.emplace_back("ks", to_value(specular));
    values.emplace_back("kd", to_value(diffuse));
    return make_brdf("lewis", values);
  }

  // The diffuse reflectance as far as the specular one leaves room for it: together they reflect no more than
  // comes in.
  grf::Vec3d beside(const grf::Vec3d& specular, const grf::Vec3d& diffuse) {
    const grf::Vec3d room = grf::Vec3d(1) - specular;
    const grf::Vec3d reduced(std::min(diffuse.x, room.x), std::min(diffuse.y, room.y),
                             std::min(diffuse.z, room.z));
    if (reduced != diffuse) note(" kd is smaller than the original, so that ks + kd is not over 1");
    return reduced;
  }

  double clamped(double value, double maximum) {
    const double inside = std::clamp(value, 0.0, maximum);
    mapped_.clamped = mapped_.clamped || inside != value;
    return inside;
  }
  grf::Vec3d clamped(const grf::Vec3d& v, double maximum) {
    return {clamped(v.x, maximum), clamped(v.y, maximum), clamped(v.z, maximum)};
  }

  std::vector<std::string>& comments() { return mapped_.definition.comments.before; }
  void note(std::string comment) { comments().push_back(std::move(comment)); }

  const PhongMaterial& material_;
  MappedMaterial mapped_;
};

}  // namespace

MappedMaterial map_material(const PhongMaterial& material) { return Mapping(material).run(); }

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
