#include "converters/returned_surface.h"

#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "converters/gltf/gltf_brdf.h"
#include "converters/losses.h"
#include "converters/renderers/mitsuba_text.h"
#include "converters/renderers/pbrt_text.h"
#include "converters/renderers/written_material.h"
#include "converters/text_encoding.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/write.h"
#include "renderer/reflectance/brdf_maker.h"

namespace convert {
namespace {

using Base = WrittenMaterial::Base;

std::string colour_text(const grf::Colour& c) { return fmt::format("({}, {}, {})", c.x, c.y, c.z); }

/// Returns the text of a scene of one triangle with this reflection.
std::string scene_text(const ReflectingSurface& surface) {
  const std::string mesh = fmt::format(
      "begin mesh rgb {} brdf {} begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end end\n",
      colour_text(surface.colour), surface.brdf);
  return surface.definitions.empty() ? mesh : fmt::format("def\n{}begin\n{}end\n", surface.definitions, mesh);
}

/// Returns the reflection of the first face of a scene with absolute names.
std::optional<ReflectingSurface> first_surface(const grf::Scene& scene, grf::Diagnostics& diagnostics) {
  std::optional<ReflectingSurface> found;
  bool is_first = true;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    if (mesh.face_count() == 0 || !std::exchange(is_first, false)) return;
    found = reflecting_surface(grf::resolve(mesh.surface(0), placement.scope), diagnostics);
  };
  grf::visit(scene, visitor);
  if (is_first) diagnostics.error({}, "the format keeps no face");
  return found;
}

std::optional<ReflectingSurface> made(ReflectingSurface surface, grf::Diagnostics& diagnostics) {
  const auto scene = grf::read_text(scene_text(surface), "surface", diagnostics);
  const auto read = scene ? first_surface(*scene, diagnostics) : std::nullopt;
  if (!read) return std::nullopt;
  surface.model = read->model;
  surface.made = read->made;
  return surface;
}

/// Returns the material of a renderer as GRF has it.
ReflectingSurface of_renderer(const WrittenMaterial& material, const std::string& name,
                              const std::string& folder) {
  ReflectingSurface surface;
  std::string base;
  switch (material.base) {
    case Base::Black:
      base = "diffuse kd=0";
      break;
    case Base::Diffuse:
      base = "diffuse kd=" + colour_text(material.reflectance);
      break;
    case Base::Conductor:
      base = fmt::format("ggx alpha={} nreal={} nimag={} scattering=single", material.facets.alpha,
                         material.facets.real_index, material.facets.imaginary_index);
      break;
    case Base::Glass:
      base = fmt::format("glass ior={} thin={} colour={}", material.index, material.is_pane,
                         colour_text(material.is_pane ? material.pane_colour : grf::Colour(1)));
      break;
    case Base::Measured:
      base = fmt::format("rgl \"{}\"", (std::filesystem::path(folder) / material.table).string());
      break;
  }
  const std::string mirror = "specular ks=" + colour_text(material.mirror);
  if (material.mirror_share <= 0) {
    surface.brdf = base;
  } else if (material.mirror_share >= 1) {
    surface.brdf = mirror;
  } else {
    surface.definitions = fmt::format("{0}_base = brdf {1}\n{0}_mirror = brdf {2}\n", name, base, mirror);
    surface.brdf = fmt::format("combine {0} {1}_base, {2} {1}_mirror", 1 - material.mirror_share, name,
                               material.mirror_share);
  }
  return surface;
}

std::optional<ReflectingSurface> by_renderer(const ReflectingSurface& original,
                                             const grf::ResolvedSurface& surface, const RenderTarget& target,
                                             const std::string& name, const std::string& folder,
                                             grf::Diagnostics& diagnostics) {
  RenderMaterial material;
  material.name = surface.brdf != nullptr ? surface.brdf->keyword : "diffuse";
  material.brdf = original.made;
  material.colour = original.colour;
  SceneFolder files((std::filesystem::path(folder) / (name + ".scene")).string(), target.suffix);
  Losses losses;
  const auto written = write_material(material, target.material, files, losses, diagnostics);
  return written ? made(of_renderer(*written, name, folder), diagnostics) : std::nullopt;
}

std::optional<ReflectingSurface> by_reader(const ReflectingSurface& original, const Format& format,
                                           const std::string& name, const std::string& folder,
                                           grf::Diagnostics& diagnostics) {
  const auto scene = grf::read_text(scene_text(original), "surface", diagnostics);
  const std::string path =
      (std::filesystem::path(folder) / (name + "." + std::string(format.extensions.front()))).string();
  grf::Diagnostics ignored;  // what one surface loses, all files of the format lose
  if (!scene || !format.write(*scene, path, ignored)) {
    diagnostics.error(grf::whole_file(path), "a surface cannot be written: " + ignored.to_text());
    return std::nullopt;
  }
  const auto import = format.read(path, {}, ignored);
  if (!import) {
    diagnostics.error(grf::whole_file(path), "a written surface cannot be read: " + ignored.to_text());
    return std::nullopt;
  }
  return first_surface(grf::with_absolute_names(import->scene, path), diagnostics);
}

}  // namespace

std::string ReflectingSurface::text() const {
  std::string text = brdf;
  if (colour != grf::Colour(1)) text += fmt::format(" times {}", colour_text(colour));
  std::string named = definitions;
  for (char& c : named) c = c == '\n' ? ';' : c;
  return named.empty() ? text : text + " where " + named.substr(0, named.size() - 1);
}

std::optional<ReflectingSurface> reflecting_surface(const grf::ResolvedSurface& surface,
                                                    grf::Diagnostics& diagnostics) {
  const grf::BrdfModel fallback = reflectance::default_model();
  const bool is_unlit = surface.brdf == nullptr && surface.emission.has_value();
  const grf::BrdfModel& model = surface.brdf != nullptr ? *surface.brdf : fallback;
  ReflectingSurface reflecting;
  reflecting.brdf = grf::to_text(model);
  reflecting.model = model;
  reflecting.colour = is_unlit ? grf::Colour(0) : surface.colour;
  std::vector<std::string> names;
  for (const grf::CombineTerm& term : model.terms) names.push_back(term.brdf.name);
  for (const grf::Definition& definition : grf::definitions_needed(names, surface.brdf_scope)) {
    const auto* named = std::get_if<grf::BrdfModel>(&definition.body);
    if (named != nullptr)
      reflecting.definitions += fmt::format("{} = brdf {}\n", definition.name, grf::to_text(*named));
  }
  auto brdf = reflectance::BrdfMaker(diagnostics).make(model, surface.brdf_scope);
  if (!brdf) return std::nullopt;
  reflecting.made = *std::move(brdf);
  return reflecting;
}

std::optional<ReflectingSurface> returned_surface(const ReflectingSurface& original,
                                                  const grf::ResolvedSurface& surface, const Format& format,
                                                  const std::string& name, const std::string& folder,
                                                  grf::Diagnostics& diagnostics) {
  if (format.read != nullptr) return by_reader(original, format, name, folder, diagnostics);
  if (format.name == "pbrt" || format.name == "mitsuba") {
    const RenderTarget target = format.name == "pbrt" ? pbrt_target() : mitsuba_target();
    return by_renderer(original, surface, target, name, folder, diagnostics);
  }
  const grf::BrdfModel fallback = reflectance::default_model();
  GltfBrdf nearest = nearest_gltf(surface.brdf != nullptr ? *surface.brdf : fallback, surface.brdf_scope);
  nearest.base *= grf::Vec3d(original.colour);
  normalise(nearest);
  ReflectingSurface returned;
  returned.brdf = grf::to_text(to_brdf(nearest));
  return made(std::move(returned), diagnostics);
}

}  // namespace convert
