#include "renderer/job/preview_render.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>
#include <vector>

#include "renderer/image/image_file.h"
#include "renderer/job/denoise.h"
#include "renderer/job/preview_stages.h"
#include "renderer/transport/error_map.h"

namespace job {
namespace {

using image::Image;
using transport::FilmTile;
using transport::Render;
using transport::RenderSettings;
using Clock = std::chrono::steady_clock;

/// The time between images of one render; images that take long to make are sent less often.
constexpr std::chrono::milliseconds Interval(80);

/// Decides when the accuracy is measured, so that it takes a tenth of a thread's time at most: the map of
/// errors twice per second, and the visible noise, which takes longer, less often.
class AccuracySchedule {
 public:
  template <class Send>
  void send_if_due(const Send& send) {
    const auto start = Clock::now();
    if (start < map_due_) return;
    const bool is_visible_noise_due = start >= visible_noise_due_;
    send(is_visible_noise_due);
    const auto end = Clock::now();
    const auto pause = Fraction * (end - start);
    map_due_ = end + std::max<Clock::duration>(MapInterval, pause);
    if (is_visible_noise_due)
      visible_noise_due_ = end + std::max<Clock::duration>(VisibleNoiseInterval, pause);
  }

 private:
  static constexpr std::chrono::milliseconds MapInterval{500};
  static constexpr std::chrono::milliseconds VisibleNoiseInterval{2000};
  static constexpr int Fraction = 10;

  Clock::time_point map_due_ = Clock::now() + MapInterval;
  Clock::time_point visible_noise_due_ = map_due_;
};

}  // namespace

struct PreviewRender::PausedRender {
  transport::RenderTotals totals;
  std::vector<FilmTile> tiles;

  void save(const Render& render) {
    totals = render.totals();
    tiles.resize(static_cast<std::size_t>(render.film().tile_count()));
    for (std::size_t i = 0; i < tiles.size(); ++i) render.copy_tile(static_cast<int>(i), tiles[i]);
  }
  void restore(Render& render) const {
    if (tiles.empty()) return;
    render.restore(totals);
    for (std::size_t i = 0; i < tiles.size(); ++i) render.restore_tile(static_cast<int>(i), tiles[i]);
  }
};

PreviewRender::PreviewRender(PreviewListener listener, StoppableImageReader image_reader)
    : listener_(std::move(listener)), scene_(std::move(image_reader)), thread_([this] { work(); }) {}

PreviewRender::~PreviewRender() {
  {
    const std::lock_guard lock(lock_);
    is_closing_ = true;
    replace_locked();
  }
  thread_.join();
}

/// Makes the thread abandon its request.
void PreviewRender::replace_locked() {
  ++number_;
  next_.reset();
  is_paused_ = false;
  preparing_.request_stop();
  changed_.notify_all();
}

int PreviewRender::start(PreviewRequest request) {
  const std::lock_guard lock(lock_);
  replace_locked();
  next_ = std::move(request);
  preparing_ = std::stop_source();
  return number_;
}

void PreviewRender::stop() {
  const std::lock_guard lock(lock_);
  replace_locked();
}

void PreviewRender::pause() {
  const std::lock_guard lock(lock_);
  is_paused_ = true;
  changed_.notify_all();
}

void PreviewRender::resume() {
  const std::lock_guard lock(lock_);
  is_paused_ = false;
  changed_.notify_all();
}

void PreviewRender::work() {
  std::unique_lock lock(lock_);
  while (true) {
    changed_.wait(lock, [this] { return is_closing_ || next_; });
    if (is_closing_) return;
    const PreviewRequest request = std::move(*std::exchange(next_, std::nullopt));
    const int number = number_;
    lock.unlock();
    try {
      show(number, request);
    } catch (const std::exception& failure) {
      grf::Diagnostics diagnostics;
      diagnostics.error({}, std::string("the preview failed: ") + failure.what());
      listener_.diagnostics(number, diagnostics);
      listener_.state(number, PreviewState::Failed);
    }
    lock.lock();
  }
}

void PreviewRender::show(int number, const PreviewRequest& request) {
  std::stop_token stop;
  {
    const std::lock_guard lock(lock_);
    if (is_replaced(number)) return;
    stop = preparing_.get_token();
  }
  listener_.state(number, PreviewState::Preparing);
  grf::Diagnostics diagnostics;
  const auto settings = scene_.prepare(request, stop, diagnostics);
  if (stop.stop_requested()) return;
  listener_.diagnostics(number, diagnostics);
  if (!settings) return listener_.state(number, PreviewState::Failed);
  listener_.state(number, PreviewState::Rendering);
  const std::vector<RenderSettings> stages = preview_stages(*settings, request.region);
  last_stage_image_ = std::make_shared<const Image>();
  denoises_ = request.denoises;
  viewing_ = {};
  viewing_.exposure = double(request.options.exposure);
  visible_noise_.reset();
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (!run_stage(number, stages[i], i + 1 == stages.size())) return;
  }
  listener_.state(number, PreviewState::Done);
}

/// Runs a stage to its end. A pause stops the render and saves its film, from which a new render resumes.
/// Returns false if the request was replaced.
bool PreviewRender::run_stage(int number, const RenderSettings& settings, bool is_last) {
  PausedRender paused;
  guides_.reset();
  while (true) {
    RenderSettings rest = settings;
    if (rest.max_seconds) rest.max_seconds = std::max(0.0, *rest.max_seconds - paused.totals.seconds);
    Render render(scene_.compiled(), rest);
    paused.restore(render);
    const StopReason stop_reason = watch(number, render, is_last);
    if (stop_reason == StopReason::Replaced) return false;
    if (is_last) send_accuracy(number, render, true);
    send_image(number, render, is_last);
    if (stop_reason == StopReason::Finished) {
      last_stage_image_ = std::make_shared<const Image>(in_whole_image(render.film().mean(), settings));
      return true;
    }
    paused.save(render);
    listener_.state(number, PreviewState::Paused);
    if (!wait_for_resumption(number)) return false;
    listener_.state(number, PreviewState::Rendering);
  }
}

/// Runs a render until it ends, is paused or is replaced, and sends images meanwhile.
PreviewRender::StopReason PreviewRender::watch(int number, Render& render, bool is_last) {
  std::exception_ptr failure;
  render_has_ended_ = false;
  std::thread runner([&] {
    try {
      render.run();
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(lock_);
    render_has_ended_ = true;
    changed_.notify_all();
  });
  const auto is_to_stop = [&] { return render_has_ended_ || is_paused_ || is_replaced(number); };
  auto due = Clock::now() + Interval;
  AccuracySchedule accuracy;
  std::unique_lock lock(lock_);
  while (!changed_.wait_until(lock, due, is_to_stop)) {
    lock.unlock();
    if (is_last)
      accuracy.send_if_due(
          [&](bool is_visible_noise_due) { send_accuracy(number, render, is_visible_noise_due); });
    const auto start = Clock::now();
    if (is_last) send_image(number, render, is_last);
    due = Clock::now() + std::max<Clock::duration>(Interval, 5 * (Clock::now() - start));
    lock.lock();
  }
  const StopReason stop_reason = is_replaced(number) ? StopReason::Replaced
                                 : render_has_ended_ ? StopReason::Finished
                                                     : StopReason::Paused;
  lock.unlock();
  render.stop();
  runner.join();
  if (failure) std::rethrow_exception(failure);
  return stop_reason;
}

bool PreviewRender::wait_for_resumption(int number) {
  std::unique_lock lock(lock_);
  changed_.wait(lock, [&] { return !is_paused_ || is_replaced(number); });
  return !is_replaced(number);
}

/// The guides are rendered once per stage, with few samples: they are far less noisy than the image.
Image PreviewRender::denoised_image(int number, const Render& render, const Image& image) {
  constexpr int GuideSamples = 2;
  const RenderSettings& settings = render.settings();
  if (!guides_) {
    guides_ = transport::feature_layers(scene_.compiled(), settings.view, settings.width, settings.height,
                                        GuideSamples, settings.seed, settings.threads, settings.crop);
  }
  bool has_variance = true;
  for (int tile = 0; tile < render.film().tile_count(); ++tile) {
    has_variance = has_variance && render.sample_count_of(tile) > 1;
  }
  return denoised(image, render.snapshot(true).variance, has_variance, *guides_, [this, number] {
    const std::lock_guard lock(lock_);
    return is_replaced(number);
  });
}

/// Takes the last visible noise unless it is to be measured. Sends nothing if the request is replaced
/// meanwhile, whose successor does not wait.
void PreviewRender::send_accuracy(int number, const Render& render, bool measures_visible_noise) {
  if (!listener_.accuracy) return;
  const auto stops = [this, number] {
    const std::lock_guard lock(lock_);
    return is_replaced(number);
  };
  if (measures_visible_noise) visible_noise_ = transport::visible_noise(render, viewing_, stops);
  const image::ImageLayer map = {"", "", transport::error_map(render, stops)};
  if (map.values.empty()) return;
  Image error = image::image_of(map, render.film().width(), render.film().height());
  listener_.accuracy(number, std::make_shared<const PreviewAccuracy>(PreviewAccuracy{
                                 in_whole_image(std::move(error), render.settings()), visible_noise_}));
}

void PreviewRender::send_image(int number, const Render& render, bool is_last) {
  Image shown = completed(render, *last_stage_image_);
  if (denoises_) shown = denoised_image(number, render, shown);
  const auto image = std::make_shared<const Image>(in_whole_image(std::move(shown), render.settings()));
  transport::RenderProgress progress = render.progress();
  if (!is_last) progress.done = 0;
  listener_.image(number, image, progress);
}

}  // namespace job
