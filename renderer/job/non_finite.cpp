#include "renderer/job/non_finite.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/transport/render.h"

namespace job {

std::string cause_text(const transport::NotFinite& cause, const transport::CompiledScene& scene) {
  if (cause.term.empty()) return "a product of finite terms is too large";
  std::string text = fmt::format("the {} is not finite", cause.term);
  if (!cause.where) return text;
  const std::uint32_t reflector = cause.where->surface->reflector;
  if (reflector != transport::InvalidIndex) text += fmt::format(", on `{}`", scene.tables()[reflector].brdf);
  const grf::Vec3d place = grf::Vec3d(cause.where->position) + scene.origin();
  return text + fmt::format(" at ({:.6g}, {:.6g}, {:.6g})", place.x, place.y, place.z);
}

std::optional<NonFiniteSearch> search_non_finite(const PreviewRequest& request, const std::stop_token& stop,
                                                 grf::Diagnostics& diagnostics) {
  constexpr int MostWidth = 256;
  constexpr int Samples = 64;
  PreviewScene scene;
  std::optional<transport::RenderSettings> settings = scene.prepare(request, stop, diagnostics);
  if (!settings) return std::nullopt;
  if (settings->width > MostWidth) {
    settings->height = std::max(1, settings->height * MostWidth / settings->width);
    settings->width = MostWidth;
  }
  settings->samples = Samples;
  settings->adaptive = false;
  settings->target_error.reset();
  settings->max_seconds.reset();
  transport::Render render(scene.compiled(), *settings);
  const std::stop_callback stopped(stop, [&render] { render.stop(); });
  render.run();
  if (stop.stop_requested()) return std::nullopt;
  NonFiniteSearch search;
  search.samples = static_cast<std::uint64_t>(Samples) * static_cast<std::uint64_t>(settings->width) *
                   static_cast<std::uint64_t>(settings->height);
  search.rejected = render.rejected_samples();
  if (search.rejected == 0) return search;
  const transport::NotFinite cause = render.cause_of_rejection().value_or(transport::NotFinite());
  search.cause = cause_text(cause, scene.compiled());
  if (cause.where) search.where = grf::Vec3d(cause.where->position) + scene.compiled().origin();
  return search;
}

}  // namespace job
