#include "converters/mapping_helpers.h"

#include <algorithm>
#include <limits>

#include "grf/keywords.h"

namespace convert {
namespace {

/// Appends texts to a comment, wrapped into lines.
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

}  // namespace

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

MappedMaterial named_material(const std::string& name, std::string_view source,
                              const std::vector<std::string>& source_values) {
  MappedMaterial material;
  material.definition.name = grf::to_identifier(name);
  std::vector<std::string>& comments = material.definition.comments.before;
  if (material.definition.name != name && !name.empty()) comments.push_back(" \"" + name + "\"");
  if (!source_values.empty()) append_wrapped(comments, " " + std::string(source) + ":", source_values);
  return material;
}

double clamped(double value, double maximum, MappedMaterial& material) {
  const double inside = std::clamp(value, 0.0, maximum);
  material.clamped = material.clamped || inside != value;
  return inside;
}

grf::Vec3d clamped(const grf::Vec3d& v, double maximum, MappedMaterial& material) {
  return {clamped(v.x, maximum, material), clamped(v.y, maximum, material), clamped(v.z, maximum, material)};
}

void finish(const grf::Vec3d& emission, MappedMaterial& material) {
  if (material.clamped) {
    material.definition.comments.before.emplace_back(" values out of range were clamped");
  }
  const grf::Vec3d radiance = clamped(emission, std::numeric_limits<float>::max(), material);
  if (radiance != grf::Vec3d(0)) material.emission = grf::Colour(radiance);
}

}  // namespace convert
