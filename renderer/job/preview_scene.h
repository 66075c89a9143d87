#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/render.h"

namespace job {

/// What a preview is to show. The scene is one in memory: the options' own scene and output count for
/// nothing.
struct PreviewRequest {
  grf::Scene scene;
  std::string path;  ///< of the scene's file, from whose folder it names others; empty: the current folder
  options::RenderOptions options;
  std::optional<transport::View> view;  ///< in place of that of the options
};

/// Reads images as transport::ImageReader does, and gives that up once it is asked to stop.
using StoppableImageReader = std::function<std::optional<transport::Image>(
    const std::string& path, grf::Diagnostics& diagnostics, const grf::SourceLocation& asked_for_at,
    const std::stop_token& stop)>;

/// What previews need of a scene, kept from one to the next as far as it is the same: where only the view
/// changes nothing is compiled, and where only surfaces change, what casts rays is kept.
class PreviewScene {
 public:
  /// An empty reader: images are read in this process.
  explicit PreviewScene(StoppableImageReader image_reader = {}) : image_reader_(std::move(image_reader)) {}

  /// Makes ready for a request. What is wrong with it is an error, and nothing is returned; nor after it was
  /// asked to stop. A request that is no other than the last one reads its files anew.
  std::optional<transport::RenderSettings> prepare(const PreviewRequest& request, const std::stop_token& stop,
                                                   grf::Diagnostics& diagnostics);

  /// That of the last request that could be prepared.
  const transport::CompiledScene& compiled() const { return *compiled_; }
  /// How often a scene was compiled.
  int compilations() const { return compilations_; }

 private:
  bool compile(const PreviewRequest& request, const transport::CompileSettings& settings,
               grf::Diagnostics& diagnostics);
  bool compiles_alike(const PreviewRequest& request, const transport::CompileSettings& settings) const;
  void keep_surroundings(const options::RenderOptions& render_options,
                         transport::RenderSettings& settings) const;

  transport::ImageReader reader_until(const std::stop_token& stop) const;

  const StoppableImageReader image_reader_;
  std::optional<PreviewRequest> last_;
  transport::CompileSettings compile_settings_;
  std::shared_ptr<const transport::CompiledScene> compiled_;
  std::shared_ptr<const transport::EnvironmentMap> environment_;
  std::shared_ptr<const transport::Image> backplate_;
  int compilations_ = 0;
};

}  // namespace job
