#pragma once

#include <vector>

#include "renderer/job/render_job.h"
#include "renderer/transport/truncation.h"

namespace job {

/// Measures by a pilot what fewer bounces leave out. Empty if the options ask for all of them: by the kernel
/// `full`, or by a checkpoint, from which a render may go on to a smaller target error.
std::vector<transport::Truncation> target_pilot(const options::RenderOptions& render_options,
                                                const RenderJob& job);

/// Truncates the paths of a render with a target error if that saves time, and says so in the plan. Returns
/// what the pilot measured.
std::vector<transport::Truncation> truncate_paths(const options::RenderOptions& render_options,
                                                  RenderJob& job);

}  // namespace job
