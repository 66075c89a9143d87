#include "renderer/reflectance/scheme.h"

#include "grf/keywords.h"
#include "renderer/reflectance/each_type.h"

namespace reflectance {

std::optional<Scheme> make_scheme(const grf::Model& data) {
  std::optional<Scheme> scheme;
  EachType<Scheme>::any([&](auto candidate) {
    using Candidate = decltype(candidate);
    if (!grf::same_keyword(Candidate::table().keyword, data.keyword)) return false;
    scheme = make<Candidate>(data);
    return true;
  });
  return scheme;
}

Scheme default_scheme() { return AutoScheme(); }

std::string refusal(const Scheme& scheme, const Brdf& brdf) {
  return std::visit([&](const auto& chosen) { return chosen.refusal(brdf); }, scheme);
}

std::vector<grf::ModelInfo> scheme_infos() {
  std::vector<grf::ModelInfo> infos;
  EachType<Scheme>::any([&](auto scheme) {
    infos.push_back(info_of<decltype(scheme)>());
    return false;
  });
  return infos;
}

grf::Catalogue catalogue() { return {brdf_infos(), scheme_infos()}; }

}  // namespace reflectance
