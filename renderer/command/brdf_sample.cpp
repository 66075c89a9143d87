#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/command/brdf_command.h"
#include "renderer/command/brdf_instance.h"
#include "renderer/command/directions.h"
#include "renderer/command/drawn_samples.h"
#include "renderer/command/json_values.h"
#include "renderer/plot/fit_file.h"

namespace command {
namespace {

using grf::ExitCode;
using reflectance::ScatterSample;
using reflectance::Vec3f;

/// Writes samples as JSON. `pdfs` and `values` leave out the specular (delta) part, with 0 as its pdf.
nlohmann::ordered_json to_json(const SampledInstance& instance, const Vec3f& u, const DrawnSamples& drawn) {
  auto directions = nlohmann::ordered_json::array();
  auto pdfs = nlohmann::ordered_json::array();
  auto values = nlohmann::ordered_json::array();
  auto weights = nlohmann::ordered_json::array();
  for (const ScatterSample& sample : drawn.samples) {
    directions.push_back(json_array(sample.direction));
    pdfs.push_back(grf::shortest(sample.pdf));
    values.push_back(json_array(instance.reflector.evaluate(u, sample.direction)));
    weights.push_back(json_array(sample.weight));
  }
  return {{"directions", directions},
          {"pdfs", pdfs},
          {"values", values},
          {"weights", weights},
          {"rejected", drawn.rejected},
          {"cosine_share", grf::shortest(instance.reflector.cosine_fraction())},
          {"build_seconds", instance.build_seconds},
          {"sample_seconds", drawn.seconds},
          {"bytes", instance.reflector.bytes()}};
}

/// Prints comments and columns, the input of plotting programs.
void print_text(const SampledInstance& instance, const Vec3f& u, const DrawnSamples& drawn) {
  fmt::print("# {} directions and {} rejected samples\n", drawn.samples.size(), drawn.rejected);
  fmt::print("# built in {:.3g} s, {} bytes of tables, {:.3g} % of the samples cosine-weighted\n",
             instance.build_seconds, instance.reflector.bytes(), 100 * instance.reflector.cosine_fraction());
  fmt::print("# sampled in {:.3g} s, {:.0f} ns per sample\n", drawn.seconds,
             1e9 * drawn.seconds / static_cast<double>(drawn.count()));
  fmt::print("# x y z, pdf in 1/sr (0: specular), f in 1/sr as red green blue\n");
  for (const ScatterSample& sample : drawn.samples) {
    const Vec3f& v = sample.direction;
    const reflectance::Rgb f = instance.reflector.evaluate(u, v);
    fmt::print("{} {} {} {} {} {} {}\n", v.x, v.y, v.z, sample.pdf, f.x, f.y, f.z);
  }
}

/// Rewrites a path to a data file relative to the folder of another file.
std::string renamed(const std::string& data_file, const grf::SourceLocation& named_at,
                    const std::string& in) {
  namespace fs = std::filesystem;
  if (fs::path(data_file).is_absolute()) return data_file;
  const std::string path = named_at.file ? grf::path_beside(named_at.file->path, data_file) : data_file;
  std::error_code error;
  const fs::path folder = fs::path(in).has_parent_path() ? fs::path(in).parent_path() : fs::path(".");
  const fs::path relative = fs::proximate(path, folder, error);
  return error ? path : relative.generic_string();
}

/// Makes a FIT file of non-specular samples. Values are means of f over RGB, to lie on the BRDF's plot.
plot::FitFile fit_of(const SampledInstance& instance, const Angles& view, const DrawnSamples& drawn,
                     const std::string& path) {
  plot::FitFile fit;
  fit.brdf = instance.model;
  if (!fit.brdf.data_file.empty()) {
    fit.brdf.data_file = renamed(fit.brdf.data_file, fit.brdf.location, path);
  }
  fit.theta = static_cast<float>(view.theta);
  fit.phi = static_cast<float>(std::remainder(view.phi, 2 * std::numbers::pi));
  const Vec3f u = direction_of(view);
  for (const ScatterSample& sample : drawn.samples) {
    if (sample.is_specular) continue;
    fit.points.push_back(
        {sample.direction, reflectance::mean(instance.reflector.evaluate(u, sample.direction))});
  }
  return fit;
}

bool write_fit(const plot::FitFile& fit, const std::string& path) {
  grf::Diagnostics diagnostics;
  const bool written = grf::replace_file(path, to_text(fit), diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  return written;
}

}  // namespace

ExitCode sample_brdf(const BrdfArguments& arguments) {
  const auto view = angles_option(arguments.view, "--u");
  if (!view) return ExitCode::BadCommandLine;
  const auto instance = read_sampled_instance(arguments.instance, arguments.pdf);
  if (!instance) return ExitCode::BadInput;
  const Vec3f u = direction_of(*view);
  const DrawnSamples drawn = draw_samples(instance->reflector, u, arguments.count, arguments.seed);
  if (!arguments.fit.empty() && !write_fit(fit_of(*instance, *view, drawn, arguments.fit), arguments.fit)) {
    return ExitCode::BadInput;
  }
  if (arguments.json) {
    fmt::print("{}\n", to_json(*instance, u, drawn).dump());
  } else {
    print_text(*instance, u, drawn);
  }
  return ExitCode::Done;
}

}  // namespace command
