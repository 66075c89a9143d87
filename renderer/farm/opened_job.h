// A job file is unpacked and read, so that its parts can be rendered.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/short_lived_folder.h"
#include "renderer/farm/records.h"
#include "renderer/job/render_job.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/part_file.h"

namespace farm {

/// The scene and the settings of a job.
struct OpenedJob {
  grf::ShortLivedFolder folder{"grfjob"};  ///< the files of the job
  options::RenderOptions options;
  std::optional<job::RenderJob> job;
  transport::Fingerprint fingerprint;
};

/// Unpacks and reads a job file. It is an error if it is damaged, names files outside of its own folder, or
/// asks for an image that cannot be divided: with a time limit or several frames. Options for other files
/// than the scene's are ignored.
std::unique_ptr<OpenedJob> open_job(const std::string& path, grf::Diagnostics& diagnostics);

/// Renders that run in several threads and can be stopped together.
class RunningRenders {
 public:
  /// Renders a task on one thread; its totals have the time. Empty if it was stopped. The image must have its
  /// tiles.
  std::optional<transport::SamplePart> run(const OpenedJob& job, const Task& task);
  /// Renders a probe likewise, whose samples are placed as those of an image that is not adaptive.
  std::optional<transport::SamplePart> run_probe(const OpenedJob& job, const transport::ImagePart& probe);
  /// Stops all renders, and those that begin later.
  void stop();

 private:
  std::optional<transport::SamplePart> run(const OpenedJob& job, transport::RenderSettings settings);

  std::mutex lock_;
  bool is_stopped_ = false;
  std::vector<transport::Render*> renders_;
};

}  // namespace farm
