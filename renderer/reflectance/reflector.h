#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "renderer/reflectance/scheme.h"

namespace reflectance {

struct ScatterSample {
  Vec3f direction;
  Rgb weight;         ///< f cos / density, or the Dirac part's weight over its probability
  float density = 0;  ///< per solid angle; 0 for a mirror direction, which no other technique can draw
  bool is_mirror = false;
};

/// What becomes of the part of a BRDF that a scheme draws never or hardly ever.
enum class MissedPart { DrawnByCosine, Missing };

/// Of a BRDF's formula: what double costs in time, and gives in accuracy, studies want to know.
enum class Precision { Float, Double };

/// A BRDF with the scheme that samples it and the scheme's tables: all that a path needs to know of a
/// surface's reflectance. The Dirac part of a BRDF is picked with its own probability, in proportion to its
/// share of the albedo. Where the scheme misses part of the BRDF, a share of the samples, in proportion to
/// what is missed, is drawn by cosine, or estimates would lack that part: which is what a study may want.
class Reflector {
 public:
  /// Makes the scheme's tables. It must not refuse the BRDF.
  Reflector(const Brdf& brdf, const Scheme& scheme, MissedPart missed_part = MissedPart::DrawnByCosine,
            Precision precision = Precision::Float);

  /// f(u, v) in 1/sr, without the Dirac part.
  Rgb evaluate(const Vec3f& u, const Vec3f& v) const {
    return precision_ == Precision::Float ? reflectance::evaluate(brdf_, u, v) : evaluate_in_double(u, v);
  }

  /// Of `sample`, for a direction that is not the mirror part's.
  float density(const Vec3f& u, const Vec3f& v) const {
    return (1 - mirror_share(u)) * mixed(v, reflectance::density(scheme_, brdf_, u, v));
  }

  /// Both in one, the density that of `sample`: where the BRDF's own sampler serves, they have much in
  /// common.
  Reflection reflect(const Vec3f& u, const Vec3f& v) const;

  std::optional<ScatterSample> sample(const Vec3f& u, const Uniforms& xi) const;

  /// Adds a sample for each xi, without those that are empty: see `reflectance::sample_many`. The Dirac part
  /// has its share of them.
  void sample_many(const Vec3f& u, std::span<const Uniforms> xi, std::vector<ScatterSample>& out) const;

  const Brdf& brdf() const { return brdf_; }
  const Scheme& scheme() const { return scheme_; }

  /// True if light that is sampled directly can be reflected at all.
  bool has_density() const { return has_density_; }

  /// True if it is `diffuse`, sampled by cosine: all that a path needs is then in the BRDF.
  bool is_matte() const { return samples_own_ && std::holds_alternative<Diffuse>(brdf_); }

  /// The share of samples, without the mirror's, that are drawn by cosine because the scheme misses part of
  /// the BRDF.
  float cosine_share() const { return cosine_share_; }

  /// The share of the BRDF's light that the scheme misses, where that is enough to matter; else 0.
  float missed_share() const { return missed_share_; }

  /// What the scheme's tables hold.
  std::size_t bytes() const { return reflectance::bytes(scheme_); }

 private:
  float mirror_share(const Vec3f& u) const { return has_mirror_ ? share_of_mirror(u) : 0; }
  float share_of_mirror(const Vec3f& u) const;

  /// The density of scheme and cosine part together.
  float mixed(const Vec3f& v, float of_scheme) const {
    return cosine_share_ > 0 ? of_scheme + cosine_share_ * (cosine_density(v) - of_scheme) : of_scheme;
  }

  std::optional<DirectionSample> sample_density(const Vec3f& u, const Uniforms& xi) const;
  Rgb evaluate_in_double(const Vec3f& u, const Vec3f& v) const;

  Brdf brdf_;
  Scheme scheme_;
  float cosine_share_ = 0;
  float missed_share_ = 0;
  // What paths ask at every hit, found once.
  bool has_mirror_ = false;
  bool has_density_ = false;
  bool samples_own_ = false;  ///< the scheme is the BRDF's own sampler, nothing mixed in, and all in float
  Precision precision_ = Precision::Float;
};

}  // namespace reflectance
