#include "converters/command/input.h"

#include <utility>

#include "grf/check.h"
#include "grf/read.h"
#include "renderer/reflectance/scheme.h"

namespace convert {

std::optional<Input> read_input(const InputOptions& options, grf::Diagnostics& diagnostics) {
  const Format* format = options.format;
  if (format == nullptr) format = recognise(options.path, diagnostics);
  if (format == nullptr) return std::nullopt;
  auto import = read(*format, options.path, options.reading, diagnostics);
  if (!import || !grf::check(import->scene, reflectance::catalogue(), diagnostics)) return std::nullopt;
  return Input{format, std::move(import->scene), std::move(import->files)};
}

std::optional<grf::BrdfModel> read_brdf_option(const std::string& text, const std::string& option,
                                               grf::Diagnostics& diagnostics) {
  auto brdf = grf::read_brdf(text, option, diagnostics);
  if (!brdf || !grf::check(*brdf, reflectance::catalogue().brdfs, "BRDF", diagnostics)) return std::nullopt;
  return brdf;
}

}  // namespace convert
