// A preview: a render that begins coarse, refines, and begins anew whenever what it shows has changed.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "renderer/job/preview_scene.h"

namespace job {

enum class PreviewState {
  Preparing,  ///< reads files and compiles the scene
  Rendering,
  Paused,
  Done,
  Failed,  ///< the diagnostics say why
};

/// Who hears of a preview. All are called by its thread, with the number of the request that they are about;
/// something may still be said of a request that was just replaced or stopped.
struct PreviewListener {
  /// An image, at first smaller than asked for. Progress is that of the image in its whole size.
  std::function<void(int request, std::shared_ptr<const transport::Image> image,
                     const transport::RenderProgress& progress)>
      image;
  std::function<void(int request, const grf::Diagnostics& diagnostics)> diagnostics;
  std::function<void(int request, PreviewState state)> state;
};

/// Shows one request after the other, in a thread of its own. All functions return at once, and may be called
/// from any thread.
class PreviewRender {
 public:
  explicit PreviewRender(PreviewListener listener, StoppableImageReader image_reader = {});
  PreviewRender(const PreviewRender&) = delete;
  PreviewRender& operator=(const PreviewRender&) = delete;
  /// Stops, and waits for the thread.
  ~PreviewRender();

  /// Shows this in place of what was shown; returns its number. A preview that was paused goes on.
  int start(PreviewRequest request);
  void stop();
  void pause();
  void resume();

 private:
  /// Why a render was left.
  enum class Left { AtItsEnd, ForAPause, ForAnother };
  /// What a paused render had.
  struct Kept;

  void work();
  void show(int number, const PreviewRequest& request);
  bool run_stage(int number, const transport::RenderSettings& settings, bool is_last);
  Left watch(int number, transport::Render& render, bool is_last);
  bool wait_for_resumption(int number);
  void say_image(int number, const transport::Render& render, bool is_last);
  bool is_replaced(int number) const { return ends_ || number != number_; }
  void replace_locked();

  const PreviewListener listener_;
  PreviewScene scene_;
  /// Of the stage before, and of the current one.
  std::shared_ptr<const transport::Image> shown_;

  std::mutex lock_;  ///< of what follows
  std::condition_variable changed_;
  std::optional<PreviewRequest> next_;
  int number_ = 0;
  bool is_paused_ = false;
  bool ends_ = false;
  bool has_ended_ = false;  ///< the render that is watched
  std::stop_source preparing_;

  std::thread thread_;  ///< the last member: it uses the others
};

}  // namespace job
