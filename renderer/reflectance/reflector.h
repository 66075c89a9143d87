#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "renderer/reflectance/scheme.h"

namespace reflectance {

/// A direction in which a path continues.
struct ScatterSample {
  Vec3f direction;
  Rgb weight;     ///< f cos / pdf, or the delta part's weight over its probability
  float pdf = 0;  ///< solid-angle pdf; 0 for a delta direction, which no other technique can sample
  bool is_specular = false;
};

/// How to treat light that a scheme's pdf misses (almost) entirely.
enum class MissedPart { DrawnByCosine, Missing };

/// Arithmetic of a BRDF's formula, for studies of the accuracy and cost of double.
enum class Precision { Float, Double };

/// A BRDF with its sampling scheme and the scheme's tables: all that a path needs to know of a surface's
/// reflectance. The delta part is picked with a probability proportional to its albedo. If the scheme misses
/// part of the BRDF, a proportional fraction of the samples is cosine-weighted; a study may turn this off and
/// see the bias.
class Reflector {
 public:
  /// Builds the scheme's tables. The scheme must support the BRDF.
  Reflector(const Brdf& brdf, const Scheme& scheme, MissedPart missed_part = MissedPart::DrawnByCosine,
            Precision precision = Precision::Float);

  /// Returns the reflector of another BRDF of the same model, by the same scheme, which must have no tables.
  Reflector with(const Brdf& brdf) const;

  /// Evaluates f(u, v) in 1/sr, without the delta part.
  Rgb evaluate(const Vec3f& u, const Vec3f& v) const {
    return precision_ == Precision::Float ? reflectance::evaluate(brdf_, u, v) : evaluate_in_double(u, v);
  }

  /// Returns the pdf of `sample` for a direction that is not the delta part's.
  float pdf(const Vec3f& u, const Vec3f& v) const {
    return (1 - specular_probability(u)) * mixed(v, reflectance::pdf(scheme_, brdf_, u, v));
  }

  /// Evaluates the BRDF and the pdf of `sample` together, which share work if the BRDF's own sampler is used.
  Reflection reflect(const Vec3f& u, const Vec3f& v) const;

  std::optional<ScatterSample> sample(const Vec3f& u, const Uniforms& xi) const;

  /// Appends a sample per xi, without empty ones; see `reflectance::sample_many`. The delta part gets its
  /// fraction of them.
  void sample_many(const Vec3f& u, std::span<const Uniforms> xi, std::vector<ScatterSample>& out) const;

  const Brdf& brdf() const { return brdf_; }  ///< Returns the BRDF; `scheme` samples it.
  const Scheme& scheme() const { return scheme_; }

  /// Returns true if directly sampled light can be reflected: the BRDF is not only a delta part.
  bool has_nonspecular_part() const { return has_nonspecular_part_; }

  /// Returns true if it is `diffuse` with cosine sampling, so that a path needs nothing but the BRDF.
  bool is_diffuse() const { return samples_own_ && std::holds_alternative<Diffuse>(brdf_); }

  /// Returns the fraction of samples, without delta ones, that are cosine-weighted since the scheme misses
  /// part of the BRDF.
  float cosine_fraction() const { return cosine_fraction_; }

  /// Returns the fraction of the BRDF's light that the scheme misses, or 0 if it is negligible.
  float missed_fraction() const { return missed_fraction_; }

  /// Returns the memory of the scheme's tables, in bytes.
  std::size_t bytes() const { return reflectance::bytes(scheme_); }

 private:
  void find_facts();
  float specular_probability(const Vec3f& u) const {
    return has_specular_part_ ? compute_specular_probability(u) : 0;
  }
  float compute_specular_probability(const Vec3f& u) const;

  /// Returns the pdf of the mixture of scheme and cosine sampling.
  float mixed(const Vec3f& v, float of_scheme) const {
    return cosine_fraction_ > 0 ? of_scheme + cosine_fraction_ * (cosine_pdf(v) - of_scheme) : of_scheme;
  }

  std::optional<DirectionSample> sample_nonspecular(const Vec3f& u, const Uniforms& xi) const;
  Rgb evaluate_in_double(const Vec3f& u, const Vec3f& v) const;

  Brdf brdf_;
  Scheme scheme_;
  float cosine_fraction_ = 0;
  float missed_fraction_ = 0;
  bool mixes_cosine_ = false;  ///< if the scheme misses part of the BRDF
  // Facts that paths ask at every hit, found once.
  bool has_specular_part_ = false;
  bool has_nonspecular_part_ = false;
  bool samples_own_ = false;  ///< the scheme is the BRDF's own sampler, with nothing mixed in, in float
  Precision precision_ = Precision::Float;
};

}  // namespace reflectance
