#include "samples/studies/sampling/technique.h"

#include <chrono>
#include <stdexcept>

#include "grf/check.h"
#include "grf/read.h"
#include "renderer/reflectance/reflector.h"

namespace study {

using reflectance::Brdf;
using reflectance::DirectionSample;
using reflectance::Scheme;
using reflectance::Uniforms;
using reflectance::Vec3f;

Brdf brdf_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_brdf(text, "study", diagnostics);
  if (!model || !grf::check(*model, reflectance::brdf_infos(), "BRDF", diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
  return *reflectance::make_brdf(*model);
}

Scheme scheme_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_pdf(text, "study", diagnostics);
  if (!model || !grf::check(*model, reflectance::scheme_infos(), "PDF", diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
  return *reflectance::make_scheme(*model);
}

Technique::Technique(const Brdf& brdf, const Scheme& scheme) : brdf_(brdf) {
  const auto start = std::chrono::steady_clock::now();
  const reflectance::Reflector reflector(brdf, scheme);
  build_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  scheme_ = reflector.scheme();
  cosine_fraction_ = reflector.cosine_fraction();
}

std::optional<DirectionSample> Technique::sample_alone(const Brdf& valued, const Vec3f& u,
                                                       const Uniforms& xi) const {
  if (scheme_) return reflectance::sample(*scheme_, valued, u, xi);
  return std::visit([&](const auto& model) { return model.sample(u, xi); }, brdf_);
}

float Technique::pdf_alone(const Vec3f& u, const Vec3f& v) const {
  if (scheme_) return reflectance::pdf(*scheme_, brdf_, u, v);
  return std::visit([&](const auto& model) { return model.pdf(u, v); }, brdf_);
}

float Technique::pdf(const Vec3f& u, const Vec3f& v) const {
  const float alone = pdf_alone(u, v);
  return cosine_fraction_ > 0 ? alone + cosine_fraction_ * (reflectance::cosine_pdf(v) - alone) : alone;
}

std::optional<DirectionSample> Technique::sample(const Vec3f& u, const Uniforms& xi) const {
  if (!(cosine_fraction_ > 0)) return sample_alone(brdf_, u, xi);
  const auto drawn = xi.choice < cosine_fraction_
                         ? reflectance::DiffuseScheme().sample(brdf_, u, xi)
                         : sample_alone(brdf_, u, reflectance::rescale(xi, cosine_fraction_));
  if (!drawn) return std::nullopt;
  const float mixed = pdf(u, drawn->direction);
  return DirectionSample{drawn->direction, drawn->weight * (drawn->pdf / mixed), mixed};
}

}  // namespace study
