#include "renderer/reflectance/brdf.h"

#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/each_type.h"
#include "renderer/reflectance/layers.h"

namespace reflectance {

Brdf::Brdf() = default;
Brdf::~Brdf() = default;
Brdf::Brdf(const Brdf& other) = default;
Brdf::Brdf(Brdf&& other) noexcept = default;
Brdf& Brdf::operator=(const Brdf& other) = default;
Brdf& Brdf::operator=(Brdf&& other) noexcept = default;

float CombinedBrdf::albedo_estimate(const Vec3f& u) const {
  const float own = weight * std::visit([&](const auto& model) { return model.albedo_estimate(u); }, brdf);
  return transmission ? own * transmission->estimate(u) : own;
}

Rgb CombinedBrdf::specular_weight(const Vec3f& u) const {
  return contribution(reflectance::specular_weight(brdf, u), u, u);
}

std::optional<Brdf> make_brdf(const grf::Model& data) {
  if (grf::same_keyword(data.keyword, Coat::table().keyword)) return make<Coat>(data).facets();
  if (grf::same_keyword(data.keyword, Layer::table().keyword)) return Combine();
  return make_any<Brdf, AnyBrdf>(data);
}

Rgb evaluate(const Brdf& brdf, const Vec3f& u, const Vec3f& v) {
  return std::visit([&](const auto& model) { return model.evaluate(u, v); }, brdf);
}

Rgb specular_weight(const Brdf& brdf, const Vec3f& u) {
  return std::visit([&](const auto& model) { return specular_weight_of(model, u); }, brdf);
}

std::optional<DirectionSample> own_sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) {
  return std::visit([&](const auto& model) { return model.sample(u, xi); }, brdf);
}

float own_pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) {
  return std::visit([&](const auto& model) { return model.pdf(u, v); }, brdf);
}

Brdf default_brdf() { return Diffuse(); }

grf::BrdfModel default_model() {
  grf::BrdfModel model;
  model.keyword = Diffuse::table().keyword;
  return model;
}

bool has_specular_part(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) {
        if constexpr (requires { model.has_specular_part(); }) return model.has_specular_part();
        return requires { model.specular_weight(Vec3f()); };
      },
      brdf);
}

bool has_nonspecular_part(const Brdf& brdf) { return has_diffuse_part(brdf) || has_glossy_part(brdf); }

bool has_diffuse_part(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) {
        if constexpr (requires { model.has_diffuse_part(); }) {
          return model.has_diffuse_part();
        } else if constexpr (requires { model.kd; }) {
          return !is_black(model.kd);
        } else {
          return false;
        }
      },
      brdf);
}

bool has_glossy_part(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) {
        if constexpr (requires { model.has_glossy_part(); }) {
          return model.has_glossy_part();
        } else if constexpr (requires { model.ks; }) {
          return !is_black(model.ks);
        } else {
          return true;
        }
      },
      brdf);
}

bool is_anisotropic(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) {
        if constexpr (requires { model.is_anisotropic(); }) return model.is_anisotropic();
        return !model.table().not_isotropic.empty();
      },
      brdf);
}

std::optional<LobeExponents> lobe_exponents(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) -> std::optional<LobeExponents> {
        if constexpr (requires { model.lobe_exponents(); }) {
          return model.lobe_exponents();
        } else if constexpr (requires { model.ex + model.ey; }) {
          return LobeExponents{model.ex, model.ey};
        } else if constexpr (requires { model.n; }) {
          return LobeExponents{model.n, model.n};
        } else {
          return std::nullopt;
        }
      },
      brdf);
}

std::vector<grf::ModelInfo> brdf_infos() {
  std::vector<grf::ModelInfo> infos = infos_of<AnyBrdf>();
  for (grf::ModelInfo& info : infos) {
    info.largest_albedo = [](const grf::Model& data) { return largest_albedo(*make_brdf(data)); };
    // Refraction at a point depends on the BRDF of others: of a solid where light leaves it again.
    const bool is_glass = grf::same_keyword(info.keyword, "glass");
    info.takes_maps = info.argument_kind == grf::ModelInfo::ArgumentKind::Parameters && !is_glass;
  }
  infos.push_back(info_of<Coat>());
  infos.push_back(info_of<Layer>());
  return infos;
}

}  // namespace reflectance
