#pragma once

#include <memory>

#include "renderer/reflectance/schemes/cascade_tables.h"
#include "renderer/reflectance/schemes/weighted.h"

namespace reflectance {

/// Cumulative distributions of the half vector (Lawrence, Rusinkiewicz and Ramamoorthi 2005, "Adaptive
/// numerical cumulative distribution functions for efficient importance sampling"; thesis section 4.4.2).
/// For each of 32 view angles, and of 16 view azimuths where the BRDF is anisotropic, there is the curve of
/// theta_h and, for each of its pieces, the curve of phi_h. A view takes the nearest tables. Where h reflects
/// u under the horizon the sample carries nothing, so that the density's integral is below 1.
struct CascadeScheme {
  static constexpr bool MayMiss = true;

  float theta_count = 256;
  float phi_count = 32;
  bool compress = false;
  std::shared_ptr<const CascadeTables> tables = {};

  static ModelTable<CascadeScheme> table() {
    return {
        .keyword = "cascadeCDF",
        .title = "Tabulated distributions of the half vector",
        .paper = "Lawrence, Rusinkiewicz and Ramamoorthi 2005",
        .parameters = {number_parameter(&CascadeScheme::theta_count, "nTh", 1, 4096, "cells over theta_h",
                                        grf::ParameterScale::Logarithmic),
                       number_parameter(&CascadeScheme::phi_count, "nPh", 1, 4096, "cells over phi_h",
                                        grf::ParameterScale::Logarithmic),
                       boolean_parameter(&CascadeScheme::compress, "compress",
                                         "keep only the points that the curves need")},
        .about =
            "Samples any BRDF by tables of its values times the cosine, as a distribution of the half "
            "vector. Lobes that are narrower than a cell are sampled badly. Compressed tables are about a "
            "twentieth as large and nearly as good.",
    };
  }

  std::string wrong_together() const {
    if (theta_count != std::round(theta_count) || phi_count != std::round(phi_count))
      return "nTh and nPh are whole numbers";
    constexpr float MostCells = 0x1p18F;  // 600 MB for an anisotropic BRDF
    return theta_count * phi_count <= MostCells ? "" : "nTh times nPh is over 262,144 cells";
  }

  static std::string refusal(const Brdf&) { return {}; }

  void build(const Brdf& brdf) {
    tables = std::make_shared<const CascadeTables>(
        brdf, CascadeTables::Size{static_cast<std::size_t>(theta_count), static_cast<std::size_t>(phi_count)},
        compress);
  }
  std::size_t bytes() const { return tables ? tables->bytes() : 0; }

  std::optional<DirectionSample> sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const {
    if (u.z <= 0 || !has_density(brdf)) return std::nullopt;
    const Vec3f h = tables->half_vector(u, xi.direction);
    if (u.dot(h) <= 0) return std::nullopt;
    const Vec3f v = reflected(u, h).normalized();
    return weighted(brdf, u, v, density(brdf, u, v));
  }

  float density(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
    if (u.z <= 0 || v.z <= 0 || !has_density(brdf)) return 0;
    return tables->half_density(u, (u + v).normalized()) / (4 * cosine_of_half(u, v));
  }
};

}  // namespace reflectance
