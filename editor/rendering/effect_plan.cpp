#include "editor/rendering/effect_plan.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "editor/controls/text.h"
#include "editor/document/op_files.h"
#include "editor/document/scene_places.h"
#include "editor/rendering/render_files.h"
#include "grf/relocate.h"
#include "renderer/job/render_job.h"

namespace editor {
namespace {

using plan::SurfacePlace;
using transport::Effect;
using Words = std::vector<std::string>;
/// The numbers of the objects that a mesh of the scene is: a file that is included twice has its meshes
/// twice.
using ObjectsOfMesh = std::map<const grf::Mesh*, std::vector<std::uint32_t>>;

ObjectsOfMesh objects_of_mesh(const grf::Scene& scene, const SceneObjects& objects) {
  ObjectsOfMesh result;
  for (std::uint32_t i = 0; i < objects.meshes.size(); ++i) {
    const grf::Mesh* mesh = mesh_at(scene, objects.meshes[i].path);
    if (mesh != nullptr) result[mesh].push_back(i);
  }
  return result;
}

Words without(const Words& words, Effect effect) {
  Words result;
  for (const std::string& word : words) {
    const transport::EffectSet named = transport::effects_named(std::vector<std::string_view>{word});
    if (!named.has(effect)) {
      result.push_back(word);
      continue;
    }
    for (const transport::EffectInfo& info : transport::EffectInfos) {
      const bool is_known = std::find(result.begin(), result.end(), info.name) != result.end();
      if (named.has(info.effect) && info.effect != effect && !is_known) result.emplace_back(info.name);
    }
  }
  return result;
}

}  // namespace

std::optional<PlannedScene> planned_scene(const FinalRenderRequest& request, grf::Diagnostics& diagnostics) {
  const options::RenderOptions render_options = with_absolute_paths(request.options, request.path);
  const auto settings = job::compile_settings_of(render_options, diagnostics);
  if (!settings || !job::check(request.scene, diagnostics)) return std::nullopt;
  PlannedScene planned;
  planned.scene = std::make_unique<const grf::Scene>(
      grf::with_absolute_names(request.scene, naming_path(request.path).toStdString()));
  auto plan = job::render_plan(*planned.scene, *settings, render_options, diagnostics);
  if (!plan) return std::nullopt;
  planned.plan = std::move(plan->plan);
  return planned;
}

EffectPlan effect_plan(const FinalRenderRequest& request, const SceneObjects& objects) {
  grf::Diagnostics diagnostics;
  const auto planned = planned_scene(request, diagnostics);
  if (!planned) return {{}, text_of(diagnostics)};
  const ObjectsOfMesh of_mesh = objects_of_mesh(*planned->scene, objects);
  const transport::EffectSet on = request.options.effects();
  EffectPlan result;
  for (const plan::PlannedEffect& effect : planned->plan.effects) {
    EffectRow row{effect.effect,          effect.is_needed,
                  on.has(effect.effect),  QString::fromStdString(effect.why),
                  FaceSelection(objects), {}};
    for (const SurfacePlace& place : effect.places) {
      if (place.mesh == nullptr) {
        if (place.index < objects.lights.size()) row.lights.push_back(objects.lights[place.index].path);
        continue;
      }
      const auto meshes = of_mesh.find(place.mesh);
      if (meshes == of_mesh.end()) continue;
      std::vector<bool> surfaces(place.mesh->surfaces.size());
      surfaces[place.index] = true;
      for (const std::uint32_t mesh : meshes->second) {
        select_surfaces(*objects.meshes[mesh].mesh, mesh, surfaces, row.faces);
      }
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

void switch_effect(options::RenderOptions& render_options, Effect effect, bool is_on) {
  if (render_options.effects().has(effect) == is_on) return;
  const bool renders_all = transport::effects_named(render_options.only) == transport::EffectSet::all();
  const std::string name(name_of(effect));
  if (is_on) {
    render_options.without = without(render_options.without, effect);
    if (!transport::effects_named(render_options.only).has(effect)) render_options.only.push_back(name);
  } else if (renders_all) {
    render_options.without.push_back(name);
  } else {
    render_options.only = without(render_options.only, effect);
  }
}

}  // namespace editor
