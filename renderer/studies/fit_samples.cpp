#include "renderer/studies/fit_samples.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <system_error>

#include "grf/text_file.h"

namespace studies {

std::string renamed(const std::string& path, const grf::SourceLocation& named_at,
                    const std::string& in_file) {
  namespace fs = std::filesystem;
  if (fs::path(path).is_absolute()) return path;
  const std::string from_here = named_at.file ? grf::path_beside(named_at.file->path, path) : path;
  std::error_code error;
  const fs::path folder =
      fs::path(in_file).has_parent_path() ? fs::path(in_file).parent_path() : fs::path(".");
  const fs::path relative = fs::proximate(from_here, folder, error);
  return error ? from_here : relative.generic_string();
}

plot::FitFile fit_of(const grf::BrdfModel& model, const reflectance::Reflector& reflector, const Angles& view,
                     std::span<const reflectance::ScatterSample> samples, const std::string& path) {
  plot::FitFile fit;
  fit.brdf = model;
  if (!model.data_file.empty()) fit.brdf.data_file = renamed(model.data_file, model.location, path);
  fit.theta = static_cast<float>(view.theta);
  fit.phi = static_cast<float>(std::remainder(view.phi, 2 * std::numbers::pi));
  const reflectance::Vec3f u = direction_of(view);
  for (const reflectance::ScatterSample& sample : samples) {
    if (sample.is_specular) continue;
    fit.points.push_back({sample.direction, reflectance::mean(reflector.evaluate(u, sample.direction))});
  }
  return fit;
}

}  // namespace studies
