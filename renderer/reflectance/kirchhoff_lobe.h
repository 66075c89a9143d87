#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/reflectance/beckmann_lobe.h"
#include "renderer/reflectance/cosine_and_lobe.h"
#include "renderer/reflectance/model.h"

namespace reflectance {

/// Returns the parameters that `he` and `westin` share.
template <class Model>
std::vector<Parameter<Model>> kirchhoff_parameters() {
  constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
  return {in_unit("um", number_parameter<Model>(&Model::sigma, "sigma", 0, 1e3F, "rms height", Logarithmic)),
          in_unit("um", number_parameter<Model>(&Model::tau, "tau", 1e-3F, 1e6F, "autocorrelation length",
                                                Logarithmic)),
          in_unit("nm", rgb_parameter<Model>(&Model::lambda, "lambda", 1, 1e6F, "wavelength", Logarithmic)),
          number_parameter<Model>(&Model::nreal, "nreal", 0, 100,
                                  "index of refraction; 0 is a perfect conductor"),
          number_parameter<Model>(&Model::nimag, "nimag", 0, 100, "its imaginary part, for metals"),
          reflectance_parameter<Model>(&Model::ks, "ks",
                                       "weight of the specular and the directional-diffuse part"),
          reflectance_parameter<Model>(&Model::kd, "kd", "albedo of the diffuse part")};
}

/// The parameters and sampler shared by `he` and `westin`. If the surface is rough in wavelengths the lobe is
/// that of Beckmann facets. If it is smooth, the first terms of the series are Gaussians of v on the unit
/// disc about the mirror direction. Roughness sets their probabilities; tails and lobes wider than the disc
/// are cosine-weighted.
template <class Model>
struct KirchhoffLobe : CosineAndLobe<Model> {
  float sigma = 0.2F;
  float tau = 2;
  Rgb lambda = Rgb(645, 525, 445);
  float nreal = 0;
  float nimag = 0;
  Rgb ks = Rgb(1);
  Rgb kd = Rgb(0);

  bool has_glossy_part() const { return !is_black(ks) && sigma > 0; }

  float diffuse_albedo(const Vec3f& u) const { return mean(kd) + wide_fraction() * directional_albedo(u); }
  float lobe_albedo_estimate(const Vec3f& u) const { return (1 - wide_fraction()) * directional_albedo(u); }

  Vec3f lobe_direction(const Vec3f& u, const Uniforms& xi) const {
    const float smooth = smooth_fraction(u);
    if (xi.choice >= smooth) return beckmann_direction(u, slope(), slope(), xi.direction);
    const float width = xi.choice < smooth / 2 ? diffraction() : wider(u);
    const float radius = width * std::sqrt(-std::log1p(-xi.direction.x));
    const float phi = 2 * Pi * xi.direction.y;
    const Vec2f place(radius * std::cos(phi) - u.x, radius * std::sin(phi) - u.y);
    return {place.x, place.y, std::sqrt(std::max(0.0F, 1 - place.dot(place)))};
  }
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const {
    const float smooth = smooth_fraction(u);
    const float disc = (gaussian(u, v, diffraction()) + gaussian(u, v, wider(u))) / 2;
    return smooth * disc * v.z + (1 - smooth) * beckmann_pdf(u, v, slope(), slope());
  }

 private:
  const Model& model() const { return static_cast<const Model&>(*this); }

  float slope() const { return std::max(1e-6F, 2 * sigma / tau); }

  /// The width of the first term on the disc, for the longest wavelength.
  float diffraction() const { return largest(lambda) / (1000 * Pi * tau); }
  /// The width of a later term than the largest: the m-th is sqrt(m) times as wide.
  float wider(const Vec3f& u) const { return diffraction() * std::sqrt(4 + 2 * typical_roughness(u)); }
  static float gaussian(const Vec3f& u, const Vec3f& v, float width) {
    const float x = (u.x + v.x) / width;
    const float y = (u.y + v.y) / width;
    return std::exp(-(x * x + y * y)) / (Pi * width * width);
  }

  /// The g of the series, for a typical v.
  float typical_roughness(const Vec3f& u) const {
    const float v = std::min(1.0F, std::sqrt(u.z * u.z + 2 * diffraction()) + slope());
    const float height = 2000 * Pi * sigma / mean(lambda) * (u.z + v);
    return height * height;
  }
  float smooth_fraction(const Vec3f& u) const { return 4 / (4 + typical_roughness(u)); }

  /// The fraction of the lobe that misses the disc, or is in its tails.
  float wide_fraction() const {
    const float width2 = diffraction() * diffraction();
    return std::max(0.1F, width2 / (1 + width2));
  }
  float directional_albedo(const Vec3f& u) const {
    return mean(ks) * model().shadowing(u) * -std::expm1(-typical_roughness(u));
  }
};

}  // namespace reflectance
