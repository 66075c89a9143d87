#pragma once

#include <memory>

#include "renderer/reflectance/schemes/cascade_tables.h"
#include "renderer/reflectance/schemes/weighted.h"

namespace reflectance {

/// Tabulated cdfs of the half vector (Lawrence, Rusinkiewicz and Ramamoorthi 2005, "Adaptive numerical
/// cumulative distribution functions for efficient importance sampling"; thesis section 4.4.2). Each of 32
/// view angles, times 16 azimuths if the BRDF is anisotropic, has a cdf of theta_h and, per piece of it, a
/// cdf of phi_h. A view uses the nearest tables. Where h reflects u below the horizon the sample is empty, so
/// the pdf integrates to less than 1.
struct CascadeScheme {
  static constexpr bool IsIncomplete = true;

  float theta_count = 256;
  float phi_count = 32;
  bool compress = false;
  std::shared_ptr<const CascadeTables> tables = {};

  static ModelTable<CascadeScheme> table() {
    return {
        .keyword = "cascadeCDF",
        .title = "Tabulated cdfs of the half vector",
        .paper = "Lawrence, Rusinkiewicz and Ramamoorthi 2005",
        .parameters = {whole(number_parameter(&CascadeScheme::theta_count, "nTh", 1, 4096,
                                              "cells over theta_h", grf::ParameterScale::Logarithmic)),
                       whole(number_parameter(&CascadeScheme::phi_count, "nPh", 1, 4096, "cells over phi_h",
                                              grf::ParameterScale::Logarithmic)),
                       boolean_parameter(&CascadeScheme::compress, "compress",
                                         "simplify the cdfs to the points needed")},
        .description =
            "Samples half vectors by inverting tabulated cdfs of the BRDF times the cosine, for any BRDF. "
            "Lobes narrower than a cell are sampled badly. Compressed tables are about a twentieth as large "
            "and nearly as good.",
    };
  }

  std::string validate() const {
    constexpr float MostCells = 0x1p18F;  // 600 MB for an anisotropic BRDF
    return theta_count * phi_count <= MostCells ? "" : "nTh times nPh must be at most 262,144 cells";
  }

  static std::string unsupported_reason(const Brdf&) { return {}; }

  void build(const Brdf& brdf) {
    tables = std::make_shared<const CascadeTables>(
        brdf, CascadeTables::Size{static_cast<std::size_t>(theta_count), static_cast<std::size_t>(phi_count)},
        compress);
  }
  std::size_t bytes() const { return tables ? tables->bytes() : 0; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0 || !has_nonspecular_part(brdf)) return std::nullopt;
    const Vec3f h = tables->half_vector(u, xi.direction);
    if (u.dot(h) <= 0) return std::nullopt;
    const Vec3f v = reflected(u, h).normalized();
    return weighted(brdf, u, v, pdf(brdf, u, v));
  }

  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0 || !has_nonspecular_part(brdf)) return 0;
    return tables->half_pdf(u, (u + v).normalized()) / (4 * cosine_of_half(u, v));
  }
};

}  // namespace reflectance
