#include "editor/rendering/effect_renders.h"

#include <algorithm>

#include "editor/rendering/effect_plan.h"
#include "editor/rendering/render_files.h"

namespace editor {
namespace {

using transport::Effect;

bool is_source(Effect effect) {
  return effect == Effect::AreaLights || effect == Effect::Environment || effect == Effect::Background;
}

}  // namespace

std::vector<EffectRender> effect_renders(const FinalRenderRequest& request, grf::Diagnostics& diagnostics) {
  const auto planned = planned_scene(request, diagnostics);
  if (!planned) return {};
  std::vector<std::string> sources;
  for (const plan::PlannedEffect& effect : planned->plan.effects) {
    if (effect.is_needed && is_source(effect.effect)) sources.emplace_back(name_of(effect.effect));
  }
  std::vector<EffectRender> renders;
  for (const plan::PlannedEffect& effect : planned->plan.effects) {
    if (!effect.is_needed || effect.effect == Effect::Instances) continue;
    const std::string name(name_of(effect.effect));
    std::vector<std::string> only = is_source(effect.effect) ? std::vector<std::string>() : sources;
    only.push_back(name);
    renders.push_back({name, effect.why, std::move(only)});
  }
  return renders;
}

FinalRenderRequest request_of(const EffectRender& effect, const FinalRenderRequest& request,
                              const FinalRender& final_render) {
  FinalRenderRequest result = request;
  result.options.output = file_of_effect(final_render.output_of(request), effect.name).toStdString();
  result.options.only = effect.only;
  return result;
}

}  // namespace editor
