#include "renderer/job/target_pilot.h"

#include <fmt/format.h>

#include "grf/wording.h"

namespace job {

using options::RenderOptions;
using transport::Truncation;

std::vector<Truncation> target_pilot(const RenderOptions& render_options, const RenderJob& job) {
  if (render_options.kernel == "full" || !render_options.checkpoint.empty()) return {};
  return transport::truncations_of(job.scene, job.settings);
}

std::vector<Truncation> truncate_paths(const RenderOptions& render_options, RenderJob& job) {
  if (!job.settings.target_error) return {};
  std::vector<Truncation> pilot = target_pilot(render_options, job);
  const auto chosen = transport::truncation_for(pilot, *job.settings.target_error);
  if (!chosen) return pilot;
  follow(*chosen, job.settings);
  job.plan.depth = chosen->depth;
  job.plan.why_depth = fmt::format(
      "paths of more than {} change the image by {:.2g} % (at most {:.2g} %), which is less than {:.0f} % of "
      "the target error; the light of the last bounce stands for theirs",
      grf::counted(static_cast<std::size_t>(chosen->depth), "bounce", "bounces"), 100 * chosen->bias.error,
      100 * chosen->bias.high, 100 * transport::BiasPart);
  return pilot;
}

}  // namespace job
