#include "converters/usd/exchange_material.h"

#include <utility>
#include <variant>

#include <fmt/format.h>

#include "converters/text_encoding.h"
#include "grf/keywords.h"
#include "grf/write.h"

namespace convert {
namespace {

std::string original_name(const grf::Surface& surface) {
  if (!surface.brdf) return surface.emission ? "light" : "default";
  if (const auto* reference = std::get_if<grf::Reference>(&*surface.brdf)) {
    return grf::from_identifier(reference->name);
  }
  return std::get<grf::BrdfModel>(*surface.brdf).keyword;
}

/// Returns the text of a BRDF with that of the BRDFs that it names.
std::string whole_text(const grf::BrdfModel& brdf, const grf::Scope& scope) {
  std::string text = grf::to_text(brdf);
  if (brdf.terms.empty()) return text;
  std::vector<std::string> names;
  for (const grf::CombineTerm& term : brdf.terms) names.push_back(term.brdf.name);
  for (const grf::Definition& definition : grf::definitions_needed(names, scope)) {
    const auto* named = std::get_if<grf::BrdfModel>(&definition.body);
    if (named != nullptr) text += fmt::format("\n{} = brdf {}", definition.name, grf::to_text(*named));
  }
  return text;
}

std::string rgb_text(const grf::Colour& c) { return fmt::format("({}, {}, {})", c.x, c.y, c.z); }

/// Returns the attributes of a surface as GRF text.
std::string grf_text(const grf::ResolvedSurface& surface) {
  std::string text;
  if (surface.colour != grf::Colour(1)) text += "rgb " + rgb_text(surface.colour) + "\n";
  if (surface.brdf != nullptr) text += "brdf " + whole_text(*surface.brdf, surface.brdf_scope) + "\n";
  if (surface.pdf != nullptr) text += "pdf " + grf::to_text(*surface.pdf) + "\n";
  if (surface.texture != nullptr) text += fmt::format("texture \"{}\"\n", surface.texture->file);
  if (surface.emission) text += "light rgb " + rgb_text(*surface.emission) + "\n";
  if (surface.opacity != grf::Opacity()) text += grf::to_text(surface.opacity) + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

bool is_black_light(const grf::Colour& c) { return !(c.x > 0 || c.y > 0 || c.z > 0); }

}  // namespace

std::string to_prim_name(std::string_view name, std::string_view otherwise) {
  std::string result;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool is_digit = c >= '0' && c <= '9';
    if (is_digit && result.empty()) result += '_';
    result += is_letter || is_digit ? c : '_';
  }
  return result.find_first_not_of('_') == std::string::npos ? std::string(otherwise) : result;
}

std::size_t ExchangeMaterials::add(ShadedSurface shaded, const std::string& original, std::string grf) {
  const std::string key =
      fmt::format("{}\n{}\n{}\n{}", original, grf, shaded.texture, shaded.has_vertex_colours);
  const auto [known, is_new] = index_of_key_.emplace(key, materials_.size());
  if (!is_new) return known->second;
  ExchangeMaterial material;
  material.name = names_.take(to_prim_name(original, "material"));
  material.original = to_utf8(original);
  const grf::ResolvedSurface& surface = shaded.surface;
  material.preview = surface.brdf != nullptr
                         ? nearest_gltf(*surface.brdf, surface.brdf_scope)
                         : nearest_gltf(BrdfLobes{.diffuse = grf::Vec3d(surface.emission ? 0 : 0.5)});
  material.preview.base *= grf::Vec3d(surface.colour);
  normalise(material.preview);
  material.graph = shading_graph_of(shaded);
  material.grf = to_utf8(grf);
  material.shaded = std::move(shaded);
  materials_.push_back(std::move(material));
  return known->second;
}

std::size_t ExchangeMaterials::index_of(const grf::Surface& surface, const grf::Scope& scope,
                                        bool has_vertex_colours, std::size_t faces, Losses& losses) {
  ShadedSurface shaded;
  shaded.surface = grf::resolve(surface, scope);
  const std::string text = grf_text(shaded.surface);
  const bool is_unlit = shaded.surface.brdf == nullptr && shaded.surface.emission.has_value();
  if (shaded.surface.texture != nullptr) shaded.texture = shaded.surface.texture->file;
  shaded.has_vertex_colours = has_vertex_colours && !is_unlit;
  if (shaded.surface.emission && is_black_light(*shaded.surface.emission) && !is_unlit)
    shaded.surface.emission.reset();
  if (shaded.surface.pdf != nullptr) losses.add(Loss::SamplingScheme, faces);
  if (shaded.surface.brdf != nullptr && has_maps(*shaded.surface.brdf)) losses.add(Loss::ParameterMap, faces);
  const std::size_t index = add(std::move(shaded), original_name(surface), text);
  if (!materials_[index].graph.is_exact) losses.add(Loss::BrdfNearest, faces);
  return index;
}

std::size_t ExchangeMaterials::index_of_lamp(const grf::Colour& radiance) {
  ShadedSurface shaded;
  shaded.surface.emission = radiance;
  return add(std::move(shaded), "light", "light rgb " + rgb_text(radiance));
}

}  // namespace convert
