// A preview is a progressive render: it starts coarse, refines, and restarts whenever the scene changes.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "renderer/job/preview_scene.h"
#include "renderer/transport/integrators/feature_layers.h"
#include "renderer/transport/visible_noise.h"

namespace job {

enum class PreviewState {
  Preparing,  ///< reads files and compiles the scene
  Rendering,
  Paused,
  Done,
  Failed,  ///< the diagnostics say why
};

/// How accurate the image of a preview is, measured as it was sent or somewhat before.
struct PreviewAccuracy {
  /// The relative standard error of each pixel as grey, see transport::error_map: of the rendered image, even
  /// if the one that is shown is denoised. 0 outside a region.
  image::Image error;
  /// With the exposure of the options, and the default distance of the eye; empty while it is not known.
  std::optional<transport::VisibleNoise> visible_noise;
};

/// Callbacks of a preview. All are called from its thread, with the number of their request; calls for a
/// request that was just replaced or stopped may still arrive.
struct PreviewListener {
  /// Receives an image, at first of lower resolution. Progress is that of the full resolution.
  std::function<void(int request, std::shared_ptr<const image::Image> image,
                     const transport::RenderProgress& progress)>
      image;
  /// Receives the accuracy of images in full resolution before them: of some and of the last one.
  std::function<void(int request, std::shared_ptr<const PreviewAccuracy> accuracy)> accuracy;
  std::function<void(int request, const grf::Diagnostics& diagnostics)> diagnostics;
  std::function<void(int request, PreviewState state)> state;
};

/// Renders previews in a thread of its own, of which the latest request replaces the one before. All
/// functions return at once and may be called from any thread.
class PreviewRender {
 public:
  explicit PreviewRender(PreviewListener listener, StoppableImageReader image_reader = {});
  PreviewRender(const PreviewRender&) = delete;
  PreviewRender& operator=(const PreviewRender&) = delete;
  /// Stops the render and joins the thread.
  ~PreviewRender();

  /// Replaces the current request and returns the number of the new one. Ends a pause.
  int start(PreviewRequest request);
  void stop();
  void pause();
  void resume();

 private:
  /// Why a render was left.
  enum class StopReason { Finished, Paused, Replaced };
  /// The film and totals of a paused render.
  struct PausedRender;

  void work();
  void show(int number, const PreviewRequest& request);
  bool run_stage(int number, const transport::RenderSettings& settings, bool is_last);
  StopReason watch(int number, transport::Render& render, bool is_last);
  bool wait_for_resumption(int number);
  void send_image(int number, const transport::Render& render, bool is_last);
  void send_accuracy(int number, const transport::Render& render, bool measures_visible_noise);
  image::Image denoised_image(int number, const transport::Render& render, const image::Image& image);
  bool is_replaced(int number) const { return is_closing_ || number != number_; }
  void replace_locked();

  const PreviewListener listener_;
  PreviewScene scene_;
  /// The image of the last finished stage.
  std::shared_ptr<const image::Image> last_stage_image_;
  bool denoises_ = false;
  image::Viewing viewing_;
  std::optional<transport::VisibleNoise> visible_noise_;  ///< the last one of the request
  std::optional<transport::FeatureLayers> guides_;        ///< of the current stage, if it is denoised

  std::mutex lock_;  ///< guards the members below
  std::condition_variable changed_;
  std::optional<PreviewRequest> next_;
  int number_ = 0;
  bool is_paused_ = false;
  bool is_closing_ = false;
  bool render_has_ended_ = false;  ///< the current render has finished
  std::stop_source preparing_;

  std::thread thread_;  ///< declared last, because it uses the other members
};

}  // namespace job
