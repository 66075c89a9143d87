#include "renderer/command/brdf_instance.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "grf/read.h"
#include "grf/text_file.h"
#include "renderer/reflectance/brdf_maker.h"

namespace command {
namespace {

/// A BRDF as parsed, and made ready for evaluation.
struct BrdfInstance {
  grf::BrdfModel model;
  reflectance::Brdf brdf;
};

std::optional<BrdfInstance> instance_of(const std::string& instance, grf::Diagnostics& diagnostics) {
  std::string text = instance;
  std::string name = "BRDF";
  std::error_code error;
  if (std::filesystem::is_regular_file(instance, error)) {
    const auto bytes = grf::read_file(instance, diagnostics);
    if (!bytes) return std::nullopt;
    text = *bytes;
    name = instance;
  }
  const auto model = grf::read_brdf(text, name, diagnostics);
  if (!model || !grf::check(*model, reflectance::brdf_infos(), "BRDF", diagnostics)) return std::nullopt;
  const auto brdf = reflectance::BrdfMaker(diagnostics).make(*model, {});
  if (!brdf) return std::nullopt;
  return BrdfInstance{*model, *brdf};
}

std::optional<reflectance::Scheme> scheme_of(const std::string& pdf, const BrdfInstance& instance,
                                             grf::Diagnostics& diagnostics) {
  const auto model = grf::read_pdf(pdf, "PDF", diagnostics);
  if (!model || !grf::check(*model, reflectance::scheme_infos(), "PDF", diagnostics)) return std::nullopt;
  const reflectance::Scheme scheme = reflectance::make_scheme(*model).value();
  const std::string unsupported_reason = reflectance::unsupported_reason(scheme, instance.brdf);
  if (unsupported_reason.empty()) return scheme;
  diagnostics.error(model->location, fmt::format("the scheme '{}' cannot sample the BRDF '{}': {}",
                                                 model->keyword, instance.model.keyword, unsupported_reason));
  return std::nullopt;
}

std::optional<SampledInstance> sampled_instance_of(const std::string& text, const std::string& pdf,
                                                   grf::Diagnostics& diagnostics) {
  const auto instance = instance_of(text, diagnostics);
  if (!instance) return std::nullopt;
  const auto scheme = scheme_of(pdf, *instance, diagnostics);
  if (!scheme) return std::nullopt;
  const auto start = std::chrono::steady_clock::now();
  reflectance::Reflector reflector(instance->brdf, *scheme);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return SampledInstance{instance->model, std::move(reflector), time.count()};
}

/// Calls a function that reads, prints its diagnostics and returns its result.
template <class Read>
auto printed(const Read& read) {
  grf::Diagnostics diagnostics;
  auto result = read(diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  return result;
}

}  // namespace

std::optional<reflectance::Reflector> read_instance(const std::string& instance) {
  const auto read =
      printed([&](grf::Diagnostics& diagnostics) { return instance_of(instance, diagnostics); });
  if (!read) return std::nullopt;
  return reflectance::Reflector(read->brdf, reflectance::OwnScheme());
}

std::optional<SampledInstance> read_sampled_instance(const std::string& instance, const std::string& pdf) {
  return printed(
      [&](grf::Diagnostics& diagnostics) { return sampled_instance_of(instance, pdf, diagnostics); });
}

}  // namespace command
