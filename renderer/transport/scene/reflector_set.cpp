#include "renderer/transport/scene/reflector_set.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "grf/write.h"
#include "renderer/parallel/loops.h"

namespace transport {
namespace {

using reflectance::Reflector;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::string brdf_text(const grf::BrdfModel* brdf) { return brdf != nullptr ? to_text(*brdf) : "diffuse"; }
std::string scheme_text(const grf::PdfModel* scheme) { return scheme != nullptr ? to_text(*scheme) : "auto"; }

std::uint32_t ReflectorSetBuilder::index_of(const grf::ResolvedSurface& surface) {
  if (surface.brdf != nullptr && !surface.brdf->terms.empty()) return index_by_text(surface);
  const auto [known, is_new] = index_by_place_.try_emplace({surface.brdf, surface.pdf});
  if (is_new) known->second = index_by_text(surface);
  return known->second;
}

std::uint32_t ReflectorSetBuilder::index_by_text(const grf::ResolvedSurface& surface) {
  const grf::PdfModel* pdf = scheme_of(surface);
  const std::string brdf =
      surface.brdf != nullptr ? brdfs_.identity(*surface.brdf, surface.brdf_scope) : std::string();
  const std::string text = brdf + " / " + (pdf != nullptr ? to_text(*pdf) : std::string());
  const auto [known, is_new] = index_by_text_.emplace(text, 0);
  if (is_new) known->second = add(surface, text);
  return known->second;
}

bool ReflectorSetBuilder::is_overridden(const grf::ResolvedSurface& surface) const {
  return override_->brdf.empty() ||
         (brdf_text(surface.brdf) == override_->brdf && scheme_text(surface.pdf) == override_->scheme);
}

/// The cache key has the modification times of data files, since the text does not tell whether they changed.
std::string ReflectorSetBuilder::identity_of(const grf::ResolvedSurface& surface, const std::string& text) {
  if (override_ && !override_->factors_file.empty()) return {};
  std::string identity =
      fmt::format("{} / {} / {}", text, static_cast<int>(missed_part_), static_cast<int>(precision_));
  if (surface.brdf == nullptr) return identity;
  for (const std::string& path : brdfs_.data_files_of(*surface.brdf, surface.brdf_scope)) {
    std::error_code missing;
    const auto changed = std::filesystem::last_write_time(path, missing);
    if (missing) return {};
    identity += fmt::format(" / {}", changed.time_since_epoch().count());
  }
  return identity;
}

const Reflector* ReflectorSetBuilder::known(const std::string& identity) const {
  if (before_ == nullptr || identity.empty()) return nullptr;
  const auto found = std::find(before_->identities.begin(), before_->identities.end(), identity);
  if (found == before_->identities.end()) return nullptr;
  return &before_->reflectors[static_cast<std::size_t>(found - before_->identities.begin())];
}

std::uint32_t ReflectorSetBuilder::add(const grf::ResolvedSurface& surface, const std::string& text) {
  const grf::PdfModel* pdf = scheme_of(surface);
  const std::string identity = identity_of(surface, text);
  const Reflector* of_before = known(identity);
  const auto brdf = of_before != nullptr      ? std::optional(of_before->brdf())
                    : surface.brdf != nullptr ? brdfs_.make(*surface.brdf, surface.brdf_scope)
                                              : std::optional(reflectance::default_brdf());
  const auto scheme = pdf != nullptr ? reflectance::make_scheme(*pdf) : reflectance::default_scheme();
  if (!scheme) diagnostics_.error(pdf->location, fmt::format("'{}' cannot be rendered", pdf->keyword));
  if (!brdf || !scheme) return 0;
  Pair pair{*brdf, *scheme, identity, of_before, {}, {}, {}, {}};
  pair.brdf_keyword = surface.brdf != nullptr ? surface.brdf->keyword : "diffuse";
  pair.info.brdf = brdf_text(surface.brdf);
  pair.scheme_keyword = pdf != nullptr ? pdf->keyword : "auto";
  pair.info.scheme = scheme_text(pdf);
  if (pdf != nullptr) pair.scheme_location = pdf->location;
  if (surface.brdf != nullptr && has_maps(*surface.brdf) && !make_varying(*surface.brdf, pair)) return 0;
  const std::string unsupported_reason = reflectance::unsupported_reason(pair.scheme, *brdf);
  if (!unsupported_reason.empty()) {
    diagnostics_.error(pair.scheme_location,
                       fmt::format("the scheme '{}' cannot sample the BRDF '{}': {}", pair.scheme_keyword,
                                   pair.brdf_keyword, unsupported_reason));
    return 0;
  }
  if (override_ && !override_->factors_file.empty() && !use_factors_file(surface, pair)) return 0;
  pairs_.push_back(std::move(pair));
  return static_cast<std::uint32_t>(pairs_.size() - 1);
}

bool ReflectorSetBuilder::is_anisotropic(std::uint32_t index) const {
  if (index >= pairs_.size()) return false;
  const Pair& pair = pairs_[index];
  return pair.varying ? pair.varying->may_be_anisotropic() : reflectance::is_anisotropic(pair.brdf);
}

bool ReflectorSetBuilder::is_diffuse(std::uint32_t index) const {
  if (index >= pairs_.size()) return false;
  const Pair& pair = pairs_[index];
  if (pair.varying) return pair.varying->is_diffuse();
  return !reflectance::has_glossy_part(pair.brdf) && !reflectance::has_specular_part(pair.brdf);
}

/// Lets images vary a BRDF. Tables for each point would cost too much: the default is the BRDF's own sampler.
bool ReflectorSetBuilder::make_varying(const grf::BrdfModel& brdf, Pair& pair) {
  pair.varying = std::make_shared<const reflectance::VaryingBrdf>(brdf);
  if (std::holds_alternative<reflectance::AutoScheme>(pair.scheme)) pair.scheme = reflectance::OwnScheme();
  if (!reflectance::is_tabulated(pair.scheme)) return true;
  diagnostics_.error(pair.scheme_location,
                     fmt::format("the scheme '{}' has tables for one BRDF, and images vary parameters of "
                                 "this '{}': use own",
                                 pair.scheme_keyword, pair.brdf_keyword));
  return false;
}

bool ReflectorSetBuilder::reads_data(const grf::ResolvedSurface& surface) {
  if (surface.brdf == nullptr) return false;
  const auto models = brdfs_.models_of(*surface.brdf, surface.brdf_scope);
  return std::any_of(models.begin(), models.end(),
                     [](const grf::BrdfModel* model) { return !model->data_file.empty(); });
}

bool ReflectorSetBuilder::use_factors_file(const grf::ResolvedSurface& surface, Pair& pair) {
  auto* factored = std::get_if<reflectance::FactoredScheme>(&pair.scheme);
  if (factored == nullptr) return true;
  const std::string identity =
      surface.brdf != nullptr ? brdfs_.identity(*surface.brdf, surface.brdf_scope) : "diffuse";
  const auto start = std::chrono::steady_clock::now();
  const bool is_right = factored->use_files(override_->factors_file, pair.brdf, identity, diagnostics_);
  seconds_ += seconds_since(start);
  return is_right;
}

ReflectorSet ReflectorSetBuilder::build(const std::stop_token& stop) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::optional<Reflector>> made(pairs_.size());
  parallel::for_each_index(pairs_.size(), [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const Pair& pair = pairs_[i];
    if (pair.known != nullptr) {
      made[i] = *pair.known;
    } else {
      made[i].emplace(pair.brdf, pair.scheme, missed_part_, precision_);
    }
  });
  if (stop.stop_requested()) return {};
  ReflectorSet set;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    Pair& pair = pairs_[i];
    pair.info.bytes = made[i]->bytes();
    pair.info.cosine_fraction = made[i]->cosine_fraction();
    if (made[i]->missed_fraction() > 0) warn_of_what_is_missed(pair, *made[i]);
    set.identities.push_back(std::move(pair.identity));
    set.tables.push_back(std::move(pair.info));
    set.reflectors.push_back(std::move(*made[i]));
  }
  set.seconds = seconds_ + seconds_since(start);
  return set;
}

void ReflectorSetBuilder::warn_of_what_is_missed(const Pair& pair, const Reflector& reflector) {
  const std::string missed = fmt::format("the scheme '{}' hardly samples part of the BRDF '{}'",
                                         pair.scheme_keyword, pair.brdf_keyword);
  const std::string consequence =
      reflector.cosine_fraction() > 0
          ? fmt::format("{:.0f} % of its samples are cosine-weighted", 100 * reflector.cosine_fraction())
          : fmt::format("the image misses {:.2g} % of it", 100 * reflector.missed_fraction());
  diagnostics_.warning(pair.scheme_location, missed + ": " + consequence);
}

}  // namespace transport
