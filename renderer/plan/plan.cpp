#include "renderer/plan/plan.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "grf/wording.h"

namespace plan {
namespace {

using grf::counted;
using transport::Effect;
using transport::EffectSet;

/// Indices into CoarseScene::surfaces.
using SurfaceList = std::vector<std::size_t>;

struct Answer {
  bool is_needed;
  std::string why;
  SurfaceList surfaces = {};  ///< that call for the effect
};

std::string faces(std::size_t count) { return counted(count, "face", "faces"); }

struct FaceCounts {
  std::size_t all = 0;
  std::size_t reflecting = 0;

  void add(const CoarseSurface& surface) {
    all += surface.faces;
    reflecting += surface.reflects() ? surface.faces : 0;
  }
};

class Planner {
 public:
  Planner(const CoarseScene& coarse_scene, const PlanSettings& settings)
      : coarse_scene_(coarse_scene), settings_(settings), reachability_(coarse_scene, limits_of(settings)) {
    // What glass lets through goes anywhere.
    if (settings.keeps_all || transmission().is_needed) keep_all();
    if (settings.shows_surfaces) keep_what_is_seen();
  }

  Plan plan() const;

 private:
  using Test = std::function<bool(const CoarseSurface&)>;

  static PathLimits limits_of(const PlanSettings& settings) {
    PathLimits limits = settings.limits;
    if (settings.draws_normals) limits.depth = 0;
    return limits;
  }
  void keep_all();
  void keep_what_is_seen();
  std::size_t count(const Test& test) const;
  SurfaceList reflecting(const Test& test) const;
  std::size_t face_count(const SurfaceList& surfaces) const;
  std::vector<SurfacePlace> places_of(const SurfaceList& surfaces) const;
  Answer of(Effect effect) const;
  Answer area_lights() const;
  Answer environment() const;
  Answer background() const;
  Answer interreflection(bool diffuse) const;
  Answer of_faces(const Test& test, std::string_view what) const;
  Answer transmission() const;
  Answer opacity() const;
  Answer interpolated_normals() const;
  Answer irradiance() const;
  Answer depth_of_field() const;
  std::string why_not(std::size_t all, std::size_t reflects) const;
  std::string why_depth() const;
  const std::string& scheme_of(const CoarseSurface& surface) const {
    return settings_.scheme.empty() ? surface.scheme : settings_.scheme;
  }
  void add_tables(Plan& plan) const;
  void add_textures(Plan& plan) const;
  void add_reflecting(Plan& plan) const;

  const CoarseScene& coarse_scene_;
  const PlanSettings& settings_;
  Reachability reachability_;
};

void Planner::keep_all() {
  const std::size_t all = coarse_scene_.surfaces.size();
  reachability_.depth = settings_.limits.depth;
  for (std::vector<bool>* list : {&reachability_.is_seen, &reachability_.is_met, &reachability_.is_front_met,
                                  &reachability_.is_smooth}) {
    list->assign(all, true);
  }
  for (std::size_t i = 0; i < all; ++i) reachability_.reflects[i] = coarse_scene_.surfaces[i].reflects();
}

void Planner::keep_what_is_seen() {
  for (std::size_t i = 0; i < reachability_.reflects.size(); ++i) {
    if (reachability_.is_seen[i] && coarse_scene_.surfaces[i].reflects()) reachability_.reflects[i] = true;
  }
}

std::size_t Planner::count(const Test& test) const {
  std::size_t sum = 0;
  for (const CoarseSurface& surface : coarse_scene_.surfaces) sum += test(surface) ? surface.faces : 0;
  return sum;
}

/// The surfaces of those faces at which a path can be scattered.
SurfaceList Planner::reflecting(const Test& test) const {
  SurfaceList surfaces;
  for (std::size_t i = 0; i < coarse_scene_.surfaces.size(); ++i) {
    if (reachability_.reflects[i] && test(coarse_scene_.surfaces[i])) surfaces.push_back(i);
  }
  return surfaces;
}

std::size_t Planner::face_count(const SurfaceList& surfaces) const {
  std::size_t sum = 0;
  for (const std::size_t i : surfaces) sum += coarse_scene_.surfaces[i].faces;
  return sum;
}

std::vector<SurfacePlace> Planner::places_of(const SurfaceList& surfaces) const {
  std::vector<SurfacePlace> places;
  std::set<std::pair<const grf::Mesh*, std::uint32_t>> known;
  for (const std::size_t i : surfaces) {
    const CoarseSurface& surface = coarse_scene_.surfaces[i];
    // Instances of a mesh in different scopes have surfaces of their own.
    if (known.emplace(surface.mesh, surface.index).second) places.push_back({surface.mesh, surface.index});
  }
  return places;
}

/// Returns why faces with some property are not hit: `all` of them have it, `reflects` of which reflect.
std::string Planner::why_not(std::size_t all, std::size_t reflects) const {
  if (reflects == 0)
    return fmt::format("only on {} that {} nothing", faces(all), all == 1 ? "reflects" : "reflect");
  if (settings_.draws_normals) return "only normals are rendered";
  if (settings_.limits.depth == 0) return "a depth of 0 shows only emission";
  const std::string far = reachability_.depth == 1
                              ? fmt::format("and {} allows no second bounce",
                                            settings_.limits.depth == 1 ? "the depth of 1" : "the geometry")
                              : "and below the horizon of the faces that paths leave";
  return fmt::format("only on {} that no path hits: outside the view, {}", faces(reflects), far);
}

Answer Planner::of_faces(const Test& test, std::string_view what) const {
  SurfaceList surfaces = reflecting(test);
  const std::size_t met = face_count(surfaces);
  if (met > 0) {
    return {true, fmt::format("{} that a path can hit {} {}", faces(met), met == 1 ? "has" : "have", what),
            std::move(surfaces)};
  }
  const std::size_t all = count(test);
  if (all == 0) return {false, fmt::format("no face has {}", what)};
  return {false, why_not(all, count([&](const CoarseSurface& s) { return test(s) && s.reflects(); }))};
}

Answer Planner::area_lights() const {
  const std::size_t all = count([](const CoarseSurface& surface) { return surface.emits; });
  if (all == 0) return {false, "nothing in the scene emits"};
  if (settings_.draws_normals) return {false, "only normals are rendered"};
  SurfaceList surfaces;
  for (std::size_t i = 0; i < coarse_scene_.surfaces.size(); ++i) {
    if (coarse_scene_.surfaces[i].emits && reachability_.is_front_met[i]) surfaces.push_back(i);
  }
  const std::size_t met = face_count(surfaces);
  if (met == 0) return {false, fmt::format("no path hits the front of the {} that emit", faces(all))};
  return {true, fmt::format("{} {} light that a path can hit", faces(met), met == 1 ? "emits" : "emit"),
          std::move(surfaces)};
}

Answer Planner::environment() const {
  if (!settings_.has_environment) return {false, "the options name no environment map"};
  if (settings_.draws_normals) return {false, "only normals are rendered"};
  return {true, "paths can leave the scene"};
}

Answer Planner::background() const {
  if (settings_.draws_normals) return {false, "only normals are rendered"};
  if (settings_.has_backplate) return {true, "the options name a backplate"};
  if (!settings_.has_background) return {false, "it is black"};
  const bool has_environment = settings_.has_environment && settings_.limits.effects.has(Effect::Environment);
  if (has_environment) return {false, "the environment map replaces it"};
  return {true, "paths can leave the scene"};
}

// A mirror interreflects if a path that was scattered elsewhere can come to it: its light is a caustic there.
Answer Planner::interreflection(bool diffuse) const {
  if (reachability_.depth < 2) return {false, why_depth()};
  const Test scatters = [](const CoarseSurface& surface) { return surface.is_diffuse || surface.is_glossy; };
  const bool has_caustics = !reflecting(scatters).empty();
  const bool has_mirrors = has_caustics && settings_.limits.effects.has(Effect::MirrorReflection);
  const bool has_glass = has_caustics && settings_.limits.effects.has(Effect::Transmission);
  const Test test = [&](const CoarseSurface& surface) {
    return surface.is_only_diffuse() == diffuse &&
           (scatters(surface) || (has_mirrors && surface.is_specular) || (has_glass && surface.is_glass));
  };
  return of_faces(test, diffuse ? "a diffuse BRDF, and paths continue from there or to there"
                                : "a glossy or specular BRDF, and paths continue from there or to there");
}

// Paths that pass glass, and lamps that shine through it, are not bounded by its faces.
Answer Planner::transmission() const {
  if (!settings_.limits.effects.has(Effect::Transmission)) return {false, "it is switched off"};
  SurfaceList surfaces;
  for (std::size_t i = 0; i < coarse_scene_.surfaces.size(); ++i) {
    if (coarse_scene_.surfaces[i].is_glass) surfaces.push_back(i);
  }
  const std::size_t all = face_count(surfaces);
  if (all == 0) return {false, "no face is glass"};
  if (settings_.draws_normals) return {false, "only normals are rendered"};
  return {true, fmt::format("{} {} glass", faces(all), all == 1 ? "is" : "are"), std::move(surfaces)};
}

// Light that reaches a visible face may have passed any other face.
Answer Planner::opacity() const {
  const std::size_t all = count([](const CoarseSurface& surface) { return surface.is_cutout; });
  if (all == 0) return {false, "all faces are opaque"};
  SurfaceList surfaces;
  for (std::size_t i = 0; i < coarse_scene_.surfaces.size(); ++i) {
    const bool is_passed = reachability_.depth > 0 || reachability_.is_met[i];
    if (coarse_scene_.surfaces[i].is_cutout && is_passed) surfaces.push_back(i);
  }
  const std::size_t passed = face_count(surfaces);
  if (passed == 0) return {false, why_not(all, all)};
  return {true, fmt::format("light can pass through {}", faces(passed)), std::move(surfaces)};
}

Answer Planner::interpolated_normals() const {
  SurfaceList surfaces;
  for (std::size_t i = 0; i < coarse_scene_.surfaces.size(); ++i) {
    const bool shows = reachability_.reflects[i] || settings_.draws_normals || settings_.shows_surfaces;
    if (shows && reachability_.is_smooth[i] && coarse_scene_.surfaces[i].is_smooth) surfaces.push_back(i);
  }
  const std::size_t met = face_count(surfaces);
  if (met > 0) {
    return {true, fmt::format("paths can hit {} with smooth shading", faces(met)), std::move(surfaces)};
  }
  const std::size_t all = count([](const CoarseSurface& surface) { return surface.is_smooth; });
  if (all == 0) return {false, "no vertex normal differs from its faces'"};
  return {false, why_not(all, count([](const CoarseSurface& s) { return s.is_smooth && s.reflects(); }))};
}

Answer Planner::irradiance() const {
  if (!settings_.uses_irradiance) return {false, "BPT_Irradiance is off"};
  return of_faces(
      [](const CoarseSurface& surface) { return surface.has_irradiance && surface.is_only_diffuse(); },
      "baked irradiance and a diffuse BRDF");
}

Answer Planner::depth_of_field() const {
  const float radius = settings_.limits.view.lens_radius;
  if (!(radius > 0)) return {false, "the camera has no lens: its lens radius is 0"};
  if (settings_.draws_normals) return {false, "only normals are rendered"};
  return {true, fmt::format("the camera has a lens with a radius of {}", radius)};
}

Answer Planner::of(Effect effect) const {
  if (!settings_.limits.effects.has(effect)) return {false, "it is switched off"};
  if (settings_.keeps_all) return {true, "the options leave out nothing"};
  switch (effect) {
    case Effect::AreaLights:
      return area_lights();
    case Effect::Environment:
      return environment();
    case Effect::Background:
      return background();
    case Effect::DiffuseInterreflection:
      return interreflection(true);
    case Effect::GlossyInterreflection:
      return interreflection(false);
    case Effect::MirrorReflection:
      return of_faces([](const CoarseSurface& surface) { return surface.is_specular; }, "a specular part");
    case Effect::Transmission:
      return transmission();
    case Effect::Anisotropy:
      return of_faces([](const CoarseSurface& surface) { return surface.is_anisotropic; },
                      "an anisotropic BRDF");
    case Effect::Textures:
      return of_faces([](const CoarseSurface& surface) { return surface.reads_images(); }, "a texture");
    case Effect::Opacity:
      return opacity();
    case Effect::VertexColours:
      return of_faces([](const CoarseSurface& surface) { return surface.has_colours; },
                      "vertex colours other than white");
    case Effect::InterpolatedNormals:
      return interpolated_normals();
    case Effect::MeasuredData:
      return of_faces([](const CoarseSurface& surface) { return surface.is_measured; }, "a measured BRDF");
    case Effect::Irradiance:
      return irradiance();
    case Effect::DepthOfField:
      return depth_of_field();
    case Effect::Instances:
      break;
  }
  if (coarse_scene_.instances == 0) return {false, "no mesh of many triangles is placed more than once"};
  return {true, fmt::format("{} share their triangles", counted(coarse_scene_.instances, "mesh", "meshes"))};
}

std::string Planner::why_depth() const {
  const int asked = settings_.limits.depth;
  if (settings_.draws_normals) return "only normals are rendered";
  if (reachability_.depth == asked) return fmt::format("the options ask for a depth of {}", asked);
  if (reachability_.depth == 0) return "no visible face reflects";
  return fmt::format(
      "after {} no path can hit a face that reflects",
      reachability_.depth == 1 ? "its first bounce" : fmt::format("{} bounces", reachability_.depth));
}

void Planner::add_tables(Plan& plan) const {
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  std::vector<FaceCounts> faces_of_table;
  for (std::size_t i = 0; i < coarse_scene_.surfaces.size(); ++i) {
    const CoarseSurface& surface = coarse_scene_.surfaces[i];
    if (surface.brdf.empty()) continue;
    const std::string& scheme = scheme_of(surface);
    const auto [place, is_new] = places.try_emplace({surface.identity, scheme}, plan.tables.size());
    if (is_new) plan.tables.push_back({surface.brdf, scheme, surface.identity, false, {}});
    faces_of_table.resize(plan.tables.size());
    faces_of_table[place->second].add(surface);
    plan.tables[place->second].is_needed = plan.tables[place->second].is_needed || reachability_.reflects[i];
  }
  for (std::size_t i = 0; i < plan.tables.size(); ++i) {
    if (!plan.tables[i].is_needed) {
      plan.tables[i].why = why_not(faces_of_table[i].all, faces_of_table[i].reflecting);
    }
  }
}

void Planner::add_textures(Plan& plan) const {
  std::map<std::string, std::size_t> places;
  std::vector<FaceCounts> faces_of_texture;
  const bool are_on = settings_.limits.effects.has(Effect::Textures);
  const bool has_opacity = of(Effect::Opacity).is_needed;
  const auto add = [&](const std::string& file, const CoarseSurface& surface, bool is_needed) {
    if (file.empty()) return;
    const auto [place, is_new] = places.try_emplace(file, plan.textures.size());
    if (is_new) plan.textures.push_back({file, false, {}});
    faces_of_texture.resize(plan.textures.size());
    faces_of_texture[place->second].add(surface);
    PlannedTexture& texture = plan.textures[place->second];
    texture.is_needed = texture.is_needed || is_needed;
  };
  for (std::size_t i = 0; i < coarse_scene_.surfaces.size(); ++i) {
    const CoarseSurface& surface = coarse_scene_.surfaces[i];
    const bool colours = are_on && reachability_.reflects[i];
    add(surface.texture.empty() ? surface.alpha : surface.texture, surface,
        colours || (has_opacity && !surface.alpha.empty()));
    for (const std::string& map : surface.maps) add(map, surface, colours);
  }
  for (std::size_t i = 0; i < plan.textures.size(); ++i) {
    if (plan.textures[i].is_needed) continue;
    plan.textures[i].why = are_on ? why_not(faces_of_texture[i].all, faces_of_texture[i].reflecting)
                                  : "textures are switched off";
  }
}

void Planner::add_reflecting(Plan& plan) const {
  if (settings_.keeps_all) return;
  auto reflecting = std::make_shared<transport::ReflectingSurfaces>();
  for (std::size_t i = 0; i < coarse_scene_.surfaces.size(); ++i) {
    const CoarseSurface& surface = coarse_scene_.surfaces[i];
    if (surface.mesh == nullptr) continue;
    std::vector<bool>& of_mesh = (*reflecting)[surface.mesh];
    of_mesh.resize(surface.mesh->surfaces.size());
    if (reachability_.reflects[i]) of_mesh[surface.index] = true;
  }
  plan.reflecting = std::move(reflecting);
}

Plan Planner::plan() const {
  Plan plan;
  plan.asked_depth = settings_.limits.depth;
  plan.depth = reachability_.depth;
  plan.why_depth = why_depth();
  for (const transport::EffectInfo& info : transport::EffectInfos) {
    Answer answer = of(info.effect);
    plan.effects.push_back(
        {info.effect, answer.is_needed, std::move(answer.why), places_of(answer.surfaces)});
  }
  add_tables(plan);
  add_textures(plan);
  add_reflecting(plan);
  return plan;
}

}  // namespace

EffectSet Plan::needed() const {
  EffectSet set;
  for (const PlannedEffect& effect : effects) {
    if (effect.is_needed) set.add(effect.effect);
  }
  return set;
}

Plan plan_of(const CoarseScene& coarse_scene, const PlanSettings& settings) {
  return Planner(coarse_scene, settings).plan();
}

void follow(const Plan& plan, transport::RenderSettings& settings) {
  settings.integrator.depth = plan.depth;
  keep_only(plan.needed(), settings);
}

void keep_only(const EffectSet& effects, transport::RenderSettings& settings) {
  transport::IntegratorSettings& integrator = settings.integrator;
  integrator.reflects_specular &= effects.has(Effect::MirrorReflection);
  integrator.uses_irradiance &= effects.has(Effect::Irradiance);
  if (!effects.has(Effect::Environment)) {
    integrator.environment = nullptr;
    integrator.resampling = std::nullopt;
  }
  if (!effects.has(Effect::Background)) {
    integrator.background = transport::Rgb(0);
    settings.backplate = nullptr;
  }
  if (!effects.has(Effect::DepthOfField)) settings.view.lens_radius = 0;
}

}  // namespace plan
