#include "converters/input.h"

#include <set>
#include <utility>

#include "grf/check.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "renderer/reflectance/scheme.h"

namespace convert {
namespace {

/// Returns the paths of embedded files as the scene names them: beside the scene, or only names if the scene
/// has no location.
std::set<std::string> paths_of(const std::vector<EmbeddedFile>& files, const std::string& path) {
  std::set<std::string> paths;
  for (const EmbeddedFile& file : files) {
    paths.insert(file.name);
    paths.insert(grf::path_beside(path, file.name));
  }
  return paths;
}

}  // namespace

std::optional<Input> read_input(const InputOptions& options, grf::Diagnostics& diagnostics) {
  const Format* format = options.format;
  if (format == nullptr) format = recognise(options.path, diagnostics);
  if (format == nullptr) return std::nullopt;
  auto import = read(*format, options.path, options.reading, diagnostics);
  if (!import) return std::nullopt;
  const std::set<std::string> embedded = paths_of(import->files, options.path);
  if (!grf::check(import->scene, reflectance::catalogue(), diagnostics, embedded)) return std::nullopt;
  return Input{format, std::move(*import)};
}

std::optional<grf::BrdfModel> read_brdf_option(const std::string& text, const std::string& option,
                                               grf::Diagnostics& diagnostics) {
  auto brdf = grf::read_brdf(text, option, diagnostics);
  if (!brdf || !grf::check(*brdf, reflectance::catalogue().brdfs, "BRDF", diagnostics)) return std::nullopt;
  return brdf;
}

}  // namespace convert
