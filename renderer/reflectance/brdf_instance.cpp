#include "renderer/reflectance/brdf_instance.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/measurements/measured_formats.h"

namespace reflectance {
namespace {

/// A BRDF and the definitions that it needs.
struct Instance {
  grf::BrdfModel model;
  std::vector<grf::Definition> definitions;
};

std::optional<Instance> without_definitions(std::optional<grf::BrdfModel> model) {
  if (!model) return std::nullopt;
  return Instance{*std::move(model), {}};
}

/// Returns the model of a file of measured data; nothing for other files. Files of these endings are measured
/// data whatever they contain.
std::optional<grf::BrdfModel> measured_model(const std::string& path) {
  const std::string extension = grf::lower_case(std::filesystem::path(path).extension().string());
  const bool may_be_rgl = extension == ".bsdf";
  const auto formats = measured_formats();
  const bool is_measured = std::any_of(formats.begin(), formats.end(), [&](const MeasuredFormat& format) {
    return extension == '.' + std::string(format.extension);
  });
  if (!is_measured) return std::nullopt;
  grf::BrdfModel model;
  model.keyword = "measured";
  model.data_file = path;
  if (!may_be_rgl) return model;
  grf::Diagnostics ignored;
  const auto bytes = grf::read_file(path, ignored);
  if (!bytes || find_measured_format(*bytes) == nullptr) model.keyword = "rgl";
  return model;
}

std::optional<Instance> read_definition(const std::string& path, const std::string& name,
                                        grf::Diagnostics& diagnostics) {
  const auto scene = grf::read(path, diagnostics);
  if (!scene) return std::nullopt;
  std::optional<Instance> found;
  grf::SceneVisitor visitor;
  visitor.definition = [&](const grf::Definition& definition, const grf::Placement& placement) {
    const auto* model = std::get_if<grf::BrdfModel>(&definition.body);
    if (found || model == nullptr || definition.name != name) return;
    std::vector<std::string> names;
    for (const grf::CombineTerm& term : model->terms) names.push_back(term.brdf.name);
    found = Instance{*model, grf::definitions_needed(names, placement.scope)};
  };
  grf::visit(*scene, visitor, path);
  if (!found) diagnostics.error({}, fmt::format("{} defines no BRDF called '{}'", path, name));
  return found;
}

std::optional<Instance> read_model(const std::string& instance, grf::Diagnostics& diagnostics) {
  const auto is_file = [](const std::string& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
  };
  if (auto measured = measured_model(instance)) return Instance{*std::move(measured), {}};
  if (is_file(instance)) {
    const auto bytes = grf::read_file(instance, diagnostics);
    return bytes ? without_definitions(grf::read_brdf(*bytes, instance, diagnostics)) : std::nullopt;
  }
  const std::size_t colon = instance.rfind(':');
  if (colon != std::string::npos && is_file(instance.substr(0, colon)))
    return read_definition(instance.substr(0, colon), instance.substr(colon + 1), diagnostics);
  return without_definitions(grf::read_brdf(instance, "BRDF", diagnostics));
}

}  // namespace

std::optional<Brdf> make_brdf(const grf::BrdfModel& model, grf::Diagnostics& diagnostics,
                              std::span<const grf::Definition> definitions) {
  if (!grf::check(model, brdf_infos(), "BRDF", diagnostics)) return std::nullopt;
  grf::ScopeStack stack;
  for (const grf::Definition& definition : definitions) {
    const auto& body = std::get<grf::BrdfModel>(definition.body);
    if (!grf::check(body, brdf_infos(), "BRDF", diagnostics)) return std::nullopt;
    stack.enter(definition);
  }
  const auto brdf = BrdfMaker(diagnostics).make(model, stack.scope());
  if (brdf && has_maps(model)) {
    diagnostics.warning(
        model.location,
        fmt::format("images vary parameters of '{}': without them, it has their factors", model.keyword));
  }
  return brdf;
}

std::optional<Scheme> make_scheme(const grf::PdfModel& model, const Brdf& brdf,
                                  const std::string& brdf_keyword, grf::Diagnostics& diagnostics) {
  if (!grf::check(model, scheme_infos(), "PDF", diagnostics)) return std::nullopt;
  const Scheme scheme = make_scheme(model).value();
  const std::string reason = unsupported_reason(scheme, brdf);
  if (reason.empty()) return scheme;
  diagnostics.error(model.location, fmt::format("the scheme '{}' cannot sample the BRDF '{}': {}",
                                                model.keyword, brdf_keyword, reason));
  return std::nullopt;
}

SampledInstance sampled_instance(const grf::BrdfModel& model, const Brdf& brdf, const Scheme& scheme) {
  const auto start = std::chrono::steady_clock::now();
  Reflector reflector(brdf, scheme);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return {model, std::move(reflector), time.count()};
}

std::optional<Reflector> read_instance(const std::string& instance, grf::Diagnostics& diagnostics) {
  const auto named = read_model(instance, diagnostics);
  const auto brdf = named ? make_brdf(named->model, diagnostics, named->definitions) : std::nullopt;
  if (!brdf) return std::nullopt;
  return Reflector(*brdf, OwnScheme());
}

std::optional<SampledInstance> read_sampled_instance(const std::string& instance, const std::string& pdf,
                                                     grf::Diagnostics& diagnostics) {
  const auto named = read_model(instance, diagnostics);
  const auto brdf = named ? make_brdf(named->model, diagnostics, named->definitions) : std::nullopt;
  if (!brdf) return std::nullopt;
  const auto pdf_model = grf::read_pdf(pdf, "PDF", diagnostics);
  const auto scheme =
      pdf_model ? make_scheme(*pdf_model, *brdf, named->model.keyword, diagnostics) : std::nullopt;
  if (!scheme) return std::nullopt;
  return sampled_instance(named->model, *brdf, *scheme);
}

}  // namespace reflectance
