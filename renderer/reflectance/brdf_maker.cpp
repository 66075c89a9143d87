#include "renderer/reflectance/brdf_maker.h"

#include <cmath>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/reflectance/layers.h"

namespace reflectance {
namespace {

std::string data_path(const grf::BrdfModel& data) {
  const auto& file = data.location.file;
  return file ? grf::path_beside(file->path, data.data_file) : data.data_file;
}

}  // namespace

std::optional<Brdf> BrdfMaker::make(const grf::BrdfModel& data, const grf::Scope& scope) {
  if (data.terms.empty()) return make_summand(data);
  if (is_layered(data)) return make_layered(data, scope);
  auto parts = std::make_shared<CombinedBrdfs>();
  for (const grf::WeightedBrdf& summand : summands_of(data, scope)) {
    auto brdf = make(*summand.model, summand.scope);
    if (!brdf) return std::nullopt;
    if (!std::isfinite(summand.weight)) {
      diagnostics_.error(data.location, "the product of the BRDFs' weights overflows a float");
      return std::nullopt;
    }
    if (const auto* layers = std::get_if<Combine>(&*brdf)) {
      for (const CombinedBrdf& part : *layers->parts) {
        parts->push_back({summand.weight * part.weight, part.brdf, part.transmission});
      }
    } else {
      warn_of_glass(*brdf, data);
      parts->push_back({summand.weight, *std::move(brdf), nullptr});
    }
  }
  return Combine{std::move(parts)};
}

std::optional<Brdf> BrdfMaker::make_layered(const grf::BrdfModel& data, const grf::Scope& scope) {
  if (layers_ == grf::MostLayers) {
    diagnostics_.error(data.location,
                       fmt::format("'{}': over {} layers above each other", data.keyword, grf::MostLayers));
    return std::nullopt;
  }
  ++layers_;
  const auto base = make_term(data, 0, scope);
  const auto top = base && data.terms.size() > 1 ? make_term(data, 1, scope) : std::nullopt;
  --layers_;
  if (!base) return std::nullopt;
  warn_of_glass(*base, data);
  if (top) warn_of_glass(*top, data);
  if (data.terms.size() == 1) return layered(*base, reflectance::make<Coat>(data));
  return top ? std::optional<Brdf>(layered(*base, *top)) : std::nullopt;
}

void BrdfMaker::warn_of_glass(const Brdf& part, const grf::BrdfModel& whole) {
  if (std::holds_alternative<Glass>(part))
    diagnostics_.warning(whole.location,
                         "glass lets nothing through in a sum or layer: it only reflects there");
}

std::optional<Brdf> BrdfMaker::make_term(const grf::BrdfModel& data, std::size_t term,
                                         const grf::Scope& scope) {
  const grf::WeightedBrdf named = named_term(data, term, scope);
  if (named.model != nullptr) return make(*named.model, named.scope);
  diagnostics_.error(data.location,
                     fmt::format("no BRDF called '{}' is defined", data.terms[term].brdf.name));
  return std::nullopt;
}

// Each BRDF is visited once, so that names that are used again and again do not multiply the work.
std::vector<const grf::BrdfModel*> BrdfMaker::models_of(const grf::BrdfModel& data, const grf::Scope& scope) {
  std::vector<const grf::BrdfModel*> models;
  std::vector<grf::WeightedBrdf> open = {{&data, 1, scope}};
  std::unordered_set<const grf::BrdfModel*> visited;
  while (!open.empty()) {
    const grf::WeightedBrdf next = open.back();
    open.pop_back();
    for (const grf::WeightedBrdf& summand : summands_of(*next.model, next.scope)) {
      if (!(summand.weight > 0) || !visited.insert(summand.model).second) continue;
      models.push_back(summand.model);
      if (!is_layered(*summand.model)) continue;
      for (std::size_t i = summand.model->terms.size(); i > 0; --i) {
        const grf::WeightedBrdf named = named_term(*summand.model, i - 1, summand.scope);
        if (named.model != nullptr) open.push_back(named);
      }
    }
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
    for (grf::Argument& argument : model.arguments) {
      if (argument.map) argument.map->file = grf::canonical_path(map_path(argument));
    }
    text += fmt::format("{} {} ", summand.weight, grf::to_text(model));
    if (!is_layered(model) || layers_ == grf::MostLayers) continue;
    ++layers_;
    for (std::size_t i = 0; i < model.terms.size(); ++i) {
      const grf::WeightedBrdf named = named_term(model, i, summand.scope);
      if (named.model != nullptr) text += fmt::format("[{}] ", identity(*named.model, named.scope));
    }
    --layers_;
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
