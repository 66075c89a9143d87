#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/job/preview_stages.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/render.h"

namespace job {

/// A request for a preview of a scene in memory; the options' scene and output paths are ignored.
struct PreviewRequest {
  grf::Scene scene;
  std::string path;  ///< of the scene's file, for relative paths; empty: the current folder
  options::RenderOptions options;
  std::optional<transport::View> view;       ///< overrides the camera of the options, but not its lens
  bool denoises = false;                     ///< see `denoised`
  std::optional<PreviewRegion> region = {};  ///< renders nothing else: the rest of an image is black
};

/// Reads images as image::ImageReader does, and cancels when stop is requested.
using StoppableImageReader = std::function<std::optional<image::Image>(
    const std::string& path, grf::Diagnostics& diagnostics, const grf::SourceLocation& asked_for_at,
    image::Alpha alpha, const std::stop_token& stop)>;

/// The compiled scene of previews, reused between requests as far as possible: where only the view changes
/// nothing is compiled, and where only surfaces change, the acceleration structure is reused.
class PreviewScene {
 public:
  /// Images are read in this process if the reader is empty.
  explicit PreviewScene(StoppableImageReader image_reader = {}) : image_reader_(std::move(image_reader)) {}

  /// Compiles the scene and loads the images of a request. Reports errors, and then returns nothing, as after
  /// a requested stop. A request equal to the last one reads its files again.
  std::optional<transport::RenderSettings> prepare(const PreviewRequest& request, const std::stop_token& stop,
                                                   grf::Diagnostics& diagnostics);

  /// The compiled scene of the last request that was prepared successfully.
  const transport::CompiledScene& compiled() const { return *compiled_; }
  /// Number of compilations so far.
  int compilations() const { return compilations_; }

 private:
  bool compile(const PreviewRequest& request, const transport::CompileSettings& settings,
               grf::Diagnostics& diagnostics);
  bool can_reuse_compiled(const PreviewRequest& request, const transport::CompileSettings& settings) const;
  void reuse_environment(const options::RenderOptions& render_options,
                         transport::RenderSettings& settings) const;

  image::ImageReader reader_until(const std::stop_token& stop) const;

  const StoppableImageReader image_reader_;
  std::optional<PreviewRequest> last_;
  transport::CompileSettings compile_settings_;
  std::shared_ptr<const transport::CompiledScene> compiled_;
  std::shared_ptr<const transport::EnvironmentMap> environment_;
  std::shared_ptr<const image::Image> backplate_;
  int compilations_ = 0;
};

}  // namespace job
