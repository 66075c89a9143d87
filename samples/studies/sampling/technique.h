// A technique that samples directions for one BRDF.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "renderer/reflectance/scheme.h"

namespace study {

reflectance::Brdf brdf_of(const std::string& text);
/// Makes the scheme without its tables.
reflectance::Scheme scheme_of(const std::string& text);

/// A scheme with its tables, mixed with cosine sampling if its pdf misses part of the BRDF, as in images; or
/// the model's own sampler. It excludes the delta part, which is the same for all.
class Technique {
 public:
  /// Uses the model's own closed-form sampler, which `auto` need not choose.
  explicit Technique(const reflectance::Brdf& brdf) : brdf_(brdf) {}
  Technique(const reflectance::Brdf& brdf, const reflectance::Scheme& scheme);

  std::optional<reflectance::DirectionSample> sample(const reflectance::Vec3f& u,
                                                     const reflectance::Uniforms& xi) const;
  float pdf(const reflectance::Vec3f& u, const reflectance::Vec3f& v) const;

  /// Samples the scheme without the mixture, with values of another BRDF in the weight.
  std::optional<reflectance::DirectionSample> sample_alone(const reflectance::Brdf& valued,
                                                           const reflectance::Vec3f& u,
                                                           const reflectance::Uniforms& xi) const;

  const reflectance::Brdf& brdf() const { return brdf_; }
  bool is_own() const { return !scheme_; }
  float cosine_fraction() const { return cosine_fraction_; }
  /// Returns the time for the tables and for the estimate of what the pdf misses.
  double build_seconds() const { return build_seconds_; }
  std::size_t bytes() const { return scheme_ ? reflectance::bytes(*scheme_) : 0; }

 private:
  float pdf_alone(const reflectance::Vec3f& u, const reflectance::Vec3f& v) const;

  reflectance::Brdf brdf_;
  std::optional<reflectance::Scheme> scheme_;
  float cosine_fraction_ = 0;
  double build_seconds_ = 0;
};

}  // namespace study
