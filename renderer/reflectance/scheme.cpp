#include "renderer/reflectance/scheme.h"

#include "renderer/reflectance/each_type.h"

namespace reflectance {

Scheme::Scheme() = default;
Scheme::~Scheme() = default;
Scheme::Scheme(const Scheme& other) = default;
Scheme::Scheme(Scheme&& other) noexcept = default;
Scheme& Scheme::operator=(const Scheme& other) = default;
Scheme& Scheme::operator=(Scheme&& other) noexcept = default;

std::optional<Scheme> make_scheme(const grf::Model& data) { return make_any<Scheme, AnyScheme>(data); }

Scheme default_scheme() { return AutoScheme(); }

std::string unsupported_reason(const Scheme& scheme, const Brdf& brdf) {
  return std::visit([&](const auto& chosen) { return chosen.unsupported_reason(brdf); }, scheme);
}

void build(Scheme& scheme, const Brdf& brdf) {
  std::visit(
      [&](auto& chosen) {
        if constexpr (requires { chosen.build(brdf); }) chosen.build(brdf);
      },
      scheme);
}

std::size_t bytes(const Scheme& scheme) {
  return std::visit(
      [](const auto& chosen) -> std::size_t {
        if constexpr (requires { chosen.bytes(); }) return chosen.bytes();
        return 0;
      },
      scheme);
}

bool is_tabulated(const Scheme& scheme) {
  return std::holds_alternative<AdaptiveScheme>(scheme) || std::holds_alternative<CascadeScheme>(scheme) ||
         std::holds_alternative<FactoredScheme>(scheme) || std::holds_alternative<RejectScheme>(scheme);
}

bool is_incomplete(const Scheme& scheme) {
  return std::visit(
      [](const auto& chosen) {
        return requires { chosen.IsIncomplete; };
      },
      scheme);
}

std::optional<DirectionSample> sample(const Scheme& scheme, const Brdf& brdf, const Vec3f& u,
                                      const Uniforms& xi) {
  return std::visit([&](const auto& chosen) { return chosen.sample(brdf, u, xi); }, scheme);
}

float pdf(const Scheme& scheme, const Brdf& brdf, const Vec3f& u, const Vec3f& v) {
  return std::visit([&](const auto& chosen) { return chosen.pdf(brdf, u, v); }, scheme);
}

void sample_many(const Scheme& scheme, const Brdf& brdf, const Vec3f& u, std::span<const Uniforms> xi,
                 std::vector<DirectionSample>& out) {
  std::visit(
      [&](const auto& chosen) {
        if constexpr (requires { chosen.sample_many(brdf, u, xi, out); }) {
          chosen.sample_many(brdf, u, xi, out);
        } else {
          for (const Uniforms& one : xi) {
            if (const auto drawn = chosen.sample(brdf, u, one)) out.push_back(*drawn);
          }
        }
      },
      scheme);
}

std::vector<grf::ModelInfo> scheme_infos() { return infos_of<AnyScheme>(); }

grf::Catalogue catalogue() { return {brdf_infos(), scheme_infos()}; }

}  // namespace reflectance
