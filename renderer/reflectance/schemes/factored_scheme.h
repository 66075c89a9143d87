#pragma once

#include <memory>

#include "renderer/reflectance/schemes/factor_files.h"
#include "renderer/reflectance/schemes/weighted.h"

namespace reflectance {

/// Factored BRDF sampling: lobes that are products of a function of theta and one of phi, found by two
/// non-negative factorisations of the BRDF times the cosine (Lawrence, Rusinkiewicz and Ramamoorthi 2004,
/// "Efficient BRDF importance sampling using a factored representation"; thesis section 4.4.1). A lobe is
/// picked by its weight for the view, blended between the nearest views; then theta and phi are drawn. For
/// isotropic BRDFs u is rotated into the plane y = 0. With `half` the lobes are of h; where h reflects u
/// below the horizon the sample is empty, so the pdf integrates to less than 1.
struct FactoredScheme {
  static constexpr bool IsIncomplete = true;

  float view_angles = 16;
  float view_azimuths = 16;
  float rows = 32;
  float columns = 16;
  float view_factors = 2;
  float lobe_factors = 1;
  bool by_half = false;
  std::shared_ptr<const Factors> given =
      {};  ///< factors for `build` to use instead of computing them; see `use_files`
  std::shared_ptr<const Factors> factors = {};

  static ModelTable<FactoredScheme> table() {
    using Scheme = FactoredScheme;
    constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
    return {
        .keyword = "factored",
        .title = "Factored BRDF",
        .paper = "Lawrence, Rusinkiewicz and Ramamoorthi 2004",
        .parameters =
            {whole(number_parameter(&Scheme::view_angles, "uTh", 1, 256, "views over theta_u", Logarithmic)),
             whole(number_parameter(
                 &Scheme::view_azimuths, "uPh", 1, 256,
                 "views over phi_u; 1, and for any isotropic BRDF: u is rotated to the x axis", Logarithmic)),
             whole(number_parameter(&Scheme::rows, "pTh", 1, 1024, "cells over theta", Logarithmic)),
             whole(number_parameter(&Scheme::columns, "pPh", 1, 1024, "cells over phi", Logarithmic)),
             whole(number_parameter(&Scheme::view_factors, "J", 1, 8, "number of factors of u")),
             whole(number_parameter(&Scheme::lobe_factors, "K", 1, 8,
                                    "number of products of theta and phi per factor of u")),
             boolean_parameter(&Scheme::by_half, "half",
                               "factor over the half vector, for lobes about the mirror direction")},
        .description =
            "Samples a sum of a few lobes fitted to the BRDF by non-negative matrix factorisation. The "
            "parameters must be found by trial; use `half=false` for diffuse BRDFs and `half=true` for "
            "glossy ones. A hundredth of the samples is uniform over the hemisphere, so that the pdf is "
            "above 0 everywhere.",
    };
  }

  std::string validate() const {
    constexpr float MostElements = 0x1p24F;  // 128 MB, and as much again for the transposed matrix
    if (view_angles * view_azimuths * rows * columns <= MostElements) return {};
    return "uTh times uPh times pTh times pPh must be at most 16,777,216";
  }

  static std::string unsupported_reason(const Brdf&) { return {}; }

  void build(const Brdf& brdf) {
    factors = given ? given : std::make_shared<const Factors>(Factors::make(brdf, size_for(brdf)));
  }
  std::size_t bytes() const { return factors ? factors->bytes() : 0; }

  /// Loads the factors of a BRDF from NAME.txt and NAME_cdf.txt if one exists; else computes and writes them.
  /// `build` then uses them, so it must get the same BRDF. Returns false after an error.
  bool use_files(const std::string& name, const Brdf& brdf, const std::string& brdf_identity,
                 grf::Diagnostics& diagnostics) {
    const FactorFiles files = {name, brdf_identity, size_for(brdf)};
    if (files.exist()) {
      const auto loaded = files.load(diagnostics);
      if (loaded) given = std::make_shared<const Factors>(*loaded);
      return loaded.has_value();
    }
    given = std::make_shared<const Factors>(Factors::make(brdf, files.size));
    return files.save(*given, diagnostics);
  }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0 || !has_nonspecular_part(brdf)) return std::nullopt;
    const Vec3f w = factors->direction(u, xi);
    if (by_half && u.dot(w) <= 0) return std::nullopt;
    const Vec3f v = by_half ? reflected(u, w).normalized() : w;
    return weighted(brdf, u, v, pdf(brdf, u, v));
  }

  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0 || !has_nonspecular_part(brdf)) return 0;
    if (!by_half) return factors->pdf(u, v);
    return factors->pdf(u, (u + v).normalized()) / (4 * cosine_of_half(u, v));
  }

 private:
  FactorSize size_for(const Brdf& brdf) const {
    const auto whole = [](float number) { return static_cast<std::size_t>(number); };
    return {whole(view_angles),
            is_anisotropic(brdf) ? whole(view_azimuths) : 1,
            whole(rows),
            whole(columns),
            whole(view_factors),
            whole(lobe_factors),
            by_half};
  }
};

}  // namespace reflectance
