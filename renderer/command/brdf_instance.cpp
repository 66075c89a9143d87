#include "renderer/command/brdf_instance.h"

#include <cstdio>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "grf/read.h"
#include "grf/text_file.h"
#include "renderer/reflectance/brdf_maker.h"

namespace command {
namespace {

std::optional<reflectance::Reflector> reflector_of(const std::string& instance,
                                                   grf::Diagnostics& diagnostics) {
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
  return reflectance::Reflector(*brdf, reflectance::default_scheme());
}

}  // namespace

std::optional<reflectance::Reflector> read_instance(const std::string& instance) {
  grf::Diagnostics diagnostics;
  auto reflector = reflector_of(instance, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  return reflector;
}

}  // namespace command
