#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "renderer/options/op_file.h"
#include "tests/support/samples.h"
#include "tests/transport/scene_helpers.h"

namespace test {

/// A scene of `samples/` with its own view, rendered small.
struct SampleScene {
  std::string name;
  transport::CompiledScene scene;
  transport::RenderSettings settings;
};

inline SampleScene sample_scene(const std::string& op_path,
                                const transport::CompileSettings& compile_settings = {}) {
  grf::Diagnostics diagnostics;
  const auto options = options::read_op_file(op_path, diagnostics);
  const auto scene = options ? grf::read(options->scene, diagnostics) : std::nullopt;
  auto compiled = scene ? transport::compile(*scene, diagnostics, compile_settings) : std::nullopt;
  if (!compiled) throw std::runtime_error(diagnostics.to_text());
  transport::RenderSettings settings;
  settings.width = 37;  // partial tiles at two sides
  settings.height = 29;
  settings.samples = 12;
  settings.seed = 5;
  settings.view = transport::view_of(compiled->bounds(), options->field_of_view, 37.0F / 29.0F);
  if (options->eye) settings.view.eye = *options->eye;
  if (options->target) settings.view.target = *options->target;
  settings.integrator.background = options->background;
  settings.integrator.depth = options->depth;
  if (!options->environment.empty()) {
    auto map = transport::read_environment_map(options->environment, diagnostics, {}, image::read_image, 0,
                                               transport::EnvironmentMap::Weights::Compensated);
    if (!map) throw std::runtime_error(diagnostics.to_text());
    settings.integrator.environment = std::make_shared<const transport::EnvironmentMap>(std::move(*map));
  }
  return {op_path, std::move(*compiled), settings};
}

/// Returns the test name of an OP file: FOLDER_NAME.
inline std::string name_of(const std::filesystem::path& op_file) {
  return op_file.parent_path().filename().string() + "_" + op_file.stem().string();
}

}  // namespace test
