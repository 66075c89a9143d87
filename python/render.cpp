// Renders to NumPy arrays, with progress in Python.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/image_array.h"
#include "python/messages.h"
#include "python/module.h"
#include "python/render_options.h"
#include "renderer/job/image_layers.h"
#include "renderer/job/render_job.h"
#include "renderer/job/target_pilot.h"
#include "renderer/parallel/loops.h"

namespace python {
namespace {

using transport::RenderEnd;

/// A render and the scene that it needs.
struct RunningRender {
  explicit RunningRender(job::RenderJob the_job) : job(std::move(the_job)), render(job.scene, job.settings) {}

  job::RenderJob job;
  transport::Render render;
};

/// What a callback is told.
struct Progress {
  transport::RenderProgress state;
  double samples = 0;  ///< per pixel
  std::shared_ptr<const RunningRender> running;
};

/// The class `granada.Render`.
struct Rendered {
  py::array_t<float> image;
  py::dict layers;
  std::optional<transport::ErrorEstimate> error;
  RenderEnd end = RenderEnd::NotYet;
  double samples = 0;  ///< per pixel
  transport::RenderTotals totals;
  py::list diagnostics;
};

const char* name_of(RenderEnd end) {
  switch (end) {
    case RenderEnd::NotYet:
      return "";
    case RenderEnd::Samples:
      return "samples";
    case RenderEnd::TargetError:
      return "target error";
    case RenderEnd::Time:
      return "time";
    case RenderEnd::Stopped:
      return "stopped";
  }
  return "";
}

/// A thread that renders; it is stopped if this goes out of scope before its end.
class RenderThread {
 public:
  explicit RenderThread(transport::Render& render)
      : render_(render), thread_([this] {
          try {
            render_.run();
          } catch (...) {
            failure_ = std::current_exception();
          }
          has_ended_ = true;
        }) {}
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;
  RenderThread(RenderThread&&) = delete;
  RenderThread& operator=(RenderThread&&) = delete;
  ~RenderThread() {
    if (!thread_.joinable()) return;
    render_.stop();
    const py::gil_scoped_release released;
    thread_.join();
  }

  bool has_ended() const { return has_ended_; }
  /// Rethrows what the render has thrown.
  void finish() {
    {
      const py::gil_scoped_release released;
      thread_.join();
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  transport::Render& render_;
  std::exception_ptr failure_;
  std::atomic<bool> has_ended_ = false;
  std::thread thread_;  // the last member, as it uses the others
};

void call_back(const py::object& callback, const std::shared_ptr<RunningRender>& running) {
  if (callback.is_none()) return;
  const transport::Render& render = running->render;
  const py::object answer = callback(Progress{render.progress(), render.samples_per_pixel(), running});
  if (answer.is(py::bool_(false))) running->render.stop();
}

/// Renders to the end, unless the callback returns False or raises, or a signal such as Ctrl+C raises.
void run(const std::shared_ptr<RunningRender>& running, const py::object& callback) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds Interval(100);
  RenderThread thread(running->render);
  auto due = Clock::now();
  while (!thread.has_ended()) {
    if (Clock::now() >= due && !running->render.is_stopped()) {
      call_back(callback, running);
      due = Clock::now() + Interval;
    }
    {
      const py::gil_scoped_release released;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  thread.finish();
  if (!running->render.is_stopped()) call_back(callback, running);
}

std::shared_ptr<RunningRender> prepare(const options::RenderOptions& render_options,
                                       grf::Diagnostics& diagnostics) {
  const py::gil_scoped_release released;
  auto job = job::render_job(render_options, diagnostics);
  if (!job) return nullptr;
  job::truncate_paths(render_options, *job);
  return std::make_shared<RunningRender>(*std::move(job));
}

Rendered result_of(const RunningRender& running, const options::RenderOptions& render_options,
                   const grf::Diagnostics& diagnostics) {
  const transport::Render& render = running.render;
  const transport::Film& film = render.film();
  image::Image image;
  std::vector<image::ImageLayer> layers;
  std::optional<transport::ErrorEstimate> error;
  {
    const py::gil_scoped_release released;
    parallel::run_with_threads(render_options.threads, [&] {
      image = film.mean();
      error = render.error_estimate();
      layers = job::feature_layers(render, running.job.scene, render_options);
      for (image::ImageLayer& layer : job::film_layers(film, render_options.layers))
        layers.push_back(std::move(layer));
    });
  }
  py::dict arrays;
  for (const image::ImageLayer& layer : layers)
    arrays[py::str(layer.name)] = array_of(layer, film.width(), film.height());
  return {array_of(image),        arrays, error, render.end(), render.samples_per_pixel(), render.totals(),
          entries_of(diagnostics)};
}

Rendered render(const std::filesystem::path& scene, const py::object& progress, const py::kwargs& options) {
  grf::Diagnostics diagnostics;
  const auto render_options = render_options_of(scene.string(), options, diagnostics);
  const auto running = render_options ? prepare(*render_options, diagnostics) : nullptr;
  if (!running) raise_error(diagnostics);
  run(running, progress);
  return result_of(*running, *render_options, diagnostics);
}

constexpr const char* RenderText =
    R"(Render a scene and return a Render.

scene is an OP file or a scene in GRF. Options are the flags of `bpt render` with underscores, such as
samples=16, size=(64, 64), target_error=0.02, time=10, seed=1, threads=2, layers=['albedo', 'normal'] and
pdf='own', and the other keys of OP files in lower case without BPT_, such as viewer=(0, 1, 4) and
vlook=(0, 0, 0). They override those of the file.

progress(p) is called with a Progress at the beginning, about every tenth of a second, and at the end. If it
returns False, the render stops, with the image so far; an exception in it, and Ctrl+C, end the render and
pass through. Raises granada.Error for errors in files.)";

void define_progress(py::module_& module) {
  py::class_<Progress>(module, "Progress", "The state of a render, for callbacks.")
      .def_property_readonly(
          "done", [](const Progress& progress) { return progress.state.done; },
          "From 0 to 1, towards whichever of samples, error and time comes first.")
      .def_property_readonly(
          "seconds", [](const Progress& progress) { return progress.state.seconds; }, "Render time so far.")
      .def_property_readonly(
          "seconds_left", [](const Progress& progress) { return progress.state.seconds_left; },
          "An estimate, or None while it is unknown.")
      .def_property_readonly(
          "error", [](const Progress& progress) { return progress.state.estimated_error; },
          "The estimated error so far, sqrt(relMSE), or None.")
      .def_readonly("samples_per_pixel", &Progress::samples, "The mean over pixels.")
      .def(
          "image",
          [](const Progress& progress) {
            image::Image image;
            {
              const py::gil_scoped_release released;
              image = progress.running->render.snapshot().mean;
            }
            return array_of(image);
          },
          "Return the image so far, (height, width, 3).");
}

}  // namespace

void define_renders(py::module_& module) {
  define_images(module);
  define_progress(module);
  py::class_<Rendered>(module, "Render", "A rendered image with its layers and its stated error.")
      .def_readonly("image", &Rendered::image, "Linear RGB radiance, (height, width, 3), rows from the top.")
      .def_readonly("layers", &Rendered::layers,
                    "The layers that were asked for, by name: albedo, normal, variance (height, width, 3); "
                    "depth, error, samples (height, width).")
      .def_property_readonly(
          "error",
          [](const Rendered& rendered) {
            return rendered.error ? std::optional(rendered.error->error) : std::nullopt;
          },
          "The estimated error, sqrt(relMSE) of the image, or None while no pixel has two samples.")
      .def_property_readonly(
          "error_interval",
          [](const Rendered& rendered) {
            return rendered.error ? std::optional(std::pair(rendered.error->low, rendered.error->high))
                                  : std::nullopt;
          },
          "The bounds of the error's 95 % confidence interval, or None.")
      .def_property_readonly(
          "end", [](const Rendered& rendered) { return name_of(rendered.end); },
          "Why the render ended: 'samples', 'target error', 'time' or 'stopped'.")
      .def_readonly("samples_per_pixel", &Rendered::samples, "The mean over pixels.")
      .def_property_readonly(
          "seconds", [](const Rendered& rendered) { return rendered.totals.seconds; }, "Render time.")
      .def_property_readonly(
          "rays", [](const Rendered& rendered) { return rendered.totals.rays; }, "Rays traced.")
      .def_property_readonly(
          "rejected_samples", [](const Rendered& rendered) { return rendered.totals.rejected; },
          "Samples that were not finite, which count as black.")
      .def_readonly("diagnostics", &Rendered::diagnostics, "Warnings and notes about the files.")
      .def("__repr__", [](const Rendered& rendered) {
        return py::str("<granada.Render {}x{}, {:g} samples per pixel>")
            .format(rendered.image.shape(1), rendered.image.shape(0), rendered.samples);
      });
  module.def("render", &render, py::arg("scene"), py::arg("progress") = py::none(), RenderText);
}

}  // namespace python
