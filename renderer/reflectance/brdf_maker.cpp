#include "renderer/reflectance/brdf_maker.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"

namespace reflectance {
namespace {

std::string data_path(const grf::BrdfModel& data) {
  const auto& file = data.location.file;
  return file ? grf::path_beside(file->path, data.data_file) : data.data_file;
}

}  // namespace

std::optional<Brdf> BrdfMaker::make(const grf::BrdfModel& data, const grf::Scope& scope) {
  if (data.terms.empty()) return make_summand(data);
  auto parts = std::make_shared<CombinedBrdfs>();
  for (const grf::WeightedBrdf& summand : summands_of(data, scope)) {
    auto brdf = make_summand(*summand.model);
    if (!brdf) return std::nullopt;
    if (!std::isfinite(summand.weight)) {
      diagnostics_.error(data.location, "the product of the BRDFs' weights overflows a float");
      return std::nullopt;
    }
    parts->push_back({summand.weight, *std::move(brdf)});
  }
  return Combine{std::move(parts)};
}

std::vector<const grf::BrdfModel*> BrdfMaker::models_of(const grf::BrdfModel& data, const grf::Scope& scope) {
  std::vector<const grf::BrdfModel*> models;
  for (const grf::WeightedBrdf& summand : summands_of(data, scope)) {
    if (summand.weight > 0) models.push_back(summand.model);
  }
  return models;
}

std::vector<std::string> BrdfMaker::data_files_of(const grf::BrdfModel& data, const grf::Scope& scope) {
  std::vector<std::string> paths;
  for (const grf::BrdfModel* model : models_of(data, scope)) {
    if (!model->data_file.empty()) paths.push_back(grf::canonical_path(data_path(*model)));
  }
  return paths;
}

std::string BrdfMaker::identity(const grf::BrdfModel& data, const grf::Scope& scope) {
  std::string text;
  for (const grf::WeightedBrdf& summand : summands_of(data, scope)) {
    grf::BrdfModel model = *summand.model;
    if (!model.data_file.empty()) model.data_file = grf::canonical_path(data_path(model));
    text += fmt::format("{} {} ", summand.weight, grf::to_text(model));
  }
  return text;
}

std::optional<Brdf> BrdfMaker::make_summand(const grf::BrdfModel& data) {
  auto brdf = make_brdf(data);
  if (!brdf) {
    diagnostics_.error(data.location, fmt::format("'{}' cannot be rendered", data.keyword));
    return std::nullopt;
  }
  const bool reads_file = std::visit([]<class Model>(const Model&) { return ReadsDataFile<Model>; }, *brdf);
  if (reads_file == data.data_file.empty()) {
    const char* what = reads_file ? "needs the name of a data file" : "takes no data file";
    diagnostics_.error(data.location, fmt::format("'{}' {}", data.keyword, what));
    return std::nullopt;
  }
  const bool is_complete = std::visit(
      [&]<class Model>(Model& model) {
        if constexpr (ReadsDataFile<Model>) {
          model.data = data_of<Model>(data);
          return model.data != nullptr;
        } else {
          return true;
        }
      },
      static_cast<AnyBrdf&>(*brdf));
  return is_complete ? brdf : std::nullopt;
}

template <class Model>
std::shared_ptr<const typename Model::Data> BrdfMaker::data_of(const grf::BrdfModel& data) {
  const std::string path = data_path(data);
  const auto [entry, is_new] =
      loaded_.try_emplace({Model::table().keyword, grf::canonical_path(path)}, nullptr);
  if (is_new) entry->second = Model::load(path, diagnostics_, data.location);
  return std::static_pointer_cast<const typename Model::Data>(entry->second);
}

}  // namespace reflectance
