#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/command/brdf_command.h"
#include "renderer/command/directions.h"
#include "renderer/command/json_values.h"
#include "renderer/command/printed.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/drawn_samples.h"
#include "renderer/studies/fit_samples.h"

namespace command {
namespace {

using grf::ExitCode;
using reflectance::SampledInstance;
using reflectance::ScatterSample;
using reflectance::Vec3f;
using studies::DrawnSamples;

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

bool write_fit(const plot::FitFile& fit, const std::string& path) {
  return printed(
      [&](grf::Diagnostics& diagnostics) { return grf::replace_file(path, to_text(fit), diagnostics); });
}

}  // namespace

ExitCode sample_brdf(const BrdfArguments& arguments) {
  const auto view = angles_option(arguments.view, "--u");
  if (!view) return ExitCode::BadCommandLine;
  const auto instance = printed([&](grf::Diagnostics& diagnostics) {
    return reflectance::read_sampled_instance(arguments.instance, arguments.pdf, diagnostics);
  });
  if (!instance) return ExitCode::BadInput;
  const Vec3f u = direction_of(*view);
  const DrawnSamples drawn = studies::draw_samples(instance->reflector, u, arguments.count, arguments.seed);
  if (!arguments.fit.empty()) {
    const plot::FitFile fit =
        studies::fit_of(instance->model, instance->reflector, *view, drawn.samples, arguments.fit);
    if (!write_fit(fit, arguments.fit)) return ExitCode::BadInput;
  }
  if (arguments.json) {
    fmt::print("{}\n", json_text(to_json(*instance, u, drawn), true));
  } else {
    print_text(*instance, u, drawn);
  }
  return ExitCode::Done;
}

}  // namespace command
