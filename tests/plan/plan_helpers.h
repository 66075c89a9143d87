#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "renderer/plan/plan.h"
#include "tests/transport/scene_helpers.h"

namespace test {

using transport::Effect;
using transport::EffectSet;

/// The render options that affect a plan.
struct PlannedRender : RenderSetup {
  EffectSet effects = EffectSet::all();
  bool full = false;  ///< `--kernel full`
  bool uses_irradiance = false;
  transport::Integrator integrator = transport::Integrator::Path;
  /// An environment map with this radiance in its upper half, made once.
  float environment = 0;
  std::size_t most_copied_triangles = 10'000;
};

/// A scene from GRF text with its plan, as `bpt` makes it; throws the diagnostics on errors.
class PlannedScene {
 public:
  PlannedScene(const std::string& text, const PlannedRender& setup, const std::string& file = "test.igrf")
      : settings_(settings_of(setup)) {
    auto scene = grf::read_text(text, file, diagnostics_);
    if (!scene || !grf::check(*scene, reflectance::catalogue(), diagnostics_)) fail();
    compile_settings_.effects = setup.effects;
    compile_settings_.most_copied_triangles = setup.most_copied_triangles;
    compile_settings_.has_irradiance = setup.uses_irradiance;
    settings_.integrator.uses_full_kernel = setup.full;
    settings_.integrator.integrator = setup.integrator;
    settings_.integrator.secondary_rays = 3;
    settings_.integrator.uses_irradiance = setup.uses_irradiance;
    if (setup.environment > 0) settings_.integrator.environment = map_of(setup.environment);
    const plan::CoarseScene coarse_scene(*scene, transport::most_copied_triangles(compile_settings_));
    bounds_ = coarse_scene.bounds;
    plan_ = plan_of(coarse_scene, plan_settings_of(setup));
    follow(plan_, settings_);
    compile_settings_.effects = plan_.needed();
    compile_settings_.reflecting = plan_.reflecting;
    scene_ = std::move(*scene);
  }

  const plan::Plan& plan() const { return plan_; }
  const grf::Box3d& bounds() const { return bounds_; }
  const grf::Scene& scene() const { return scene_; }
  const transport::CompileSettings& compile_settings() const { return compile_settings_; }

  transport::CompiledScene compiled() {
    auto compiled = transport::compile(scene_, diagnostics_, compile_settings_);
    if (!compiled) fail();
    return std::move(*compiled);
  }

  transport::Film film() {
    const transport::CompiledScene scene = compiled();
    transport::Render render(scene, settings_);
    render.run();
    if (render.rejected_samples() > 0) throw std::runtime_error("samples that are not finite");
    return render.film();
  }
  image::Image image() { return film().mean(); }

  std::vector<std::string> needed() const {
    std::vector<std::string> names;
    for (const plan::PlannedEffect& effect : plan_.effects) {
      if (effect.is_needed) names.emplace_back(name_of(effect.effect));
    }
    return names;
  }

 private:
  [[noreturn]] void fail() const { throw std::runtime_error(diagnostics_.to_text()); }

  static std::shared_ptr<const transport::EnvironmentMap> map_of(float radiance) {
    image::Image image{8, 4, std::vector<transport::Rgb>(32, transport::Rgb(0))};
    std::fill_n(image.pixels.begin(), 16, transport::Rgb(radiance));
    return environment_of(std::move(image));
  }

  plan::PlanSettings plan_settings_of(const PlannedRender& setup) const {
    plan::PlanSettings settings;
    settings.limits = {settings_.view, setup.width, setup.height, setup.depth, setup.effects};
    settings.has_environment = setup.environment > 0;
    settings.has_background = setup.background > 0;
    settings.uses_irradiance = setup.uses_irradiance;
    settings.keeps_all = setup.full;
    return settings;
  }

  grf::Diagnostics diagnostics_;
  grf::Scene scene_;
  transport::RenderSettings settings_;
  transport::CompileSettings compile_settings_;
  plan::Plan plan_;
  grf::Box3d bounds_;
};

inline PlannedRender full(PlannedRender setup) {
  setup.full = true;
  return setup;
}

inline PlannedRender without(PlannedRender setup, Effect effect) {
  setup.effects.remove(effect);
  return setup;
}

}  // namespace test
