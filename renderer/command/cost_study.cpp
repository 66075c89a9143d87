#include "renderer/command/cost_study.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "renderer/transport/checkpoint_frame.h"
#include "renderer/transport/digest.h"

namespace command {
namespace {

SavedCost::Row row_of(const nlohmann::json& saved) {
  SavedCost::Row result;
  result.key = saved.at("settings").get<std::string>();
  CostRow& row = result.row;
  row.samples = saved.at("samples").get<int>();
  row.seeds = saved.at("seeds").get<std::vector<std::uint32_t>>();
  row.render_seconds = saved.at("render_seconds").get<double>();
  row.sampling_seconds = saved.at("sampling_seconds").get<double>();
  row.relmse = saved.at("relmse").get<double>();
  if (const nlohmann::json& error = saved.at("average_relative_error"); !error.is_null()) {
    row.average_relative_error = error.get<double>();
  }
  for (const nlohmann::json& round : saved.at("rounds")) {
    row.rounds.push_back({round.at("render_seconds").get<double>(), round.at("relmse").get<double>()});
  }
  if (row.rounds.size() != row.seeds.size()) throw std::runtime_error("a row needs a seed for each round");
  return result;
}

SavedCost study_of(const nlohmann::json& saved, const std::filesystem::path& folder) {
  SavedCost study;
  study.conditions = {saved.at("fingerprint").get<std::string>(), saved.at("threads").get<int>(),
                      saved.at("has_centred_rays").get<bool>()};
  const nlohmann::json& reference = saved.at("reference");
  if (reference.at("image").is_null()) {
    study.reference_digest = reference.at("digest").get<std::string>();
  } else {
    study.reference_image = (folder / reference.at("image").get<std::string>()).string();
    study.reference_samples = reference.at("samples").get<int>();
    study.reference_seconds = reference.at("seconds").get<double>();
    const double error = reference.at("error").get<double>();
    study.reference_relmse = error * error;
  }
  for (const nlohmann::json& row : saved.at("rows")) study.rows.push_back(row_of(row));
  return study;
}

bool fail(const std::string& path, const std::string& problem, grf::Diagnostics& diagnostics) {
  diagnostics.error(grf::whole_file(path), problem);
  return false;
}

}  // namespace

std::string digest_of_image(const image::Image& image) {
  return transport::hex(transport::digest_of(transport::bytes_of_all(image.pixels)));
}

std::optional<SavedCost> read_cost_study(const std::string& path, grf::Diagnostics& diagnostics) {
  const auto text = grf::read_file(path, diagnostics);
  if (!text) return std::nullopt;
  try {
    return study_of(nlohmann::json::parse(*text), std::filesystem::path(path).parent_path());
  } catch (const std::exception& error) {
    fail(path, fmt::format("expected the JSON of a study, as bpt cost writes it: {}", error.what()),
         diagnostics);
    return std::nullopt;
  }
}

bool check_conditions(const SavedCost& saved, const CostConditions& conditions, const std::string& path,
                      grf::Diagnostics& diagnostics) {
  if (saved.conditions.fingerprint != conditions.fingerprint) {
    return fail(path, "the study is of another scene, image, crop or program: its rows cannot be continued",
                diagnostics);
  }
  if (saved.conditions.threads != conditions.threads) {
    return fail(path,
                fmt::format("the study was measured with {} threads, expected {}: times would not compare",
                            saved.conditions.threads, conditions.threads),
                diagnostics);
  }
  if (saved.conditions.has_centred_rays != conditions.has_centred_rays) {
    return fail(path, "naive lines need camera rays through pixel centres: errors would not compare",
                diagnostics);
  }
  return true;
}

}  // namespace command
