#pragma once

#include <random>
#include <string>
#include <vector>

#include "grf/read.h"
#include "renderer/reflectance/brdf.h"

namespace test {

using reflectance::Brdf;
using reflectance::Vec3f;

/// The BRDF that a text such as `ward sx=0.1` describes.
inline Brdf brdf_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_brdf(text, "test", diagnostics);
  if (!model || !grf::check(*model, reflectance::brdf_infos(), "BRDF", diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
  return *reflectance::make_brdf(*model);
}

/// Instances whose lobes a grid can resolve: those of the thesis' table 5.5 among them.
inline const std::vector<std::string>& plain_cases() {
  static const std::vector<std::string> cases = {
      "diffuse kd=1",
      "phong n=50 ks=0.8 kd=0.5",
      "phong n=0 ks=0.2 kd=0",
      "blinn n=100 ks=1 kd=0.67",
      "blinn n=10 ks=0.3 kd=(0.1, 0.5, 0.2)",
      "lewis n=100 ks=1 kd=0",
      "lewis n=20 ks=(0.5, 0.2, 0.1) kd=0.4",
      "ward sx=0.2 ks=0.5 kd=0.5",
      "ward sx=0.15 sy=0.4 ks=0.6 kd=0.3",
      "ward sx=1 ks=1 kd=0",
      "beardmaxwell omega=1 tau=0 nreal=0.37 nimag=2.82 Rs=0.4 Rd=0.75 Rv=0.5",
      "beardmaxwell omega=0.5 tau=0.4 sigma=1 Rs=1 Rd=0 Rv=0",
      "beardmaxwell Rs=0 Rd=0 Rv=1",
      "kajiya",
      "kajiya sigma=0.1 taux=1 tauy=1 nreal=2.485 nimag=3.433 ks=(0.7, 0.5, 0.3) kd=0.2",
      "hanrahan",
      "hanrahan nreal=1 g=0 albedo=1 depth=1 ks=0 kd=0",
      "hanrahan nreal=1.3 g=-0.7 albedo=(1, 0.6, 0.3) depth=0.2 rough=0.5 ks=0.8 kd=0.1",
      "westin",
      "westin sigma=0.1 tau=3 lambda=500 nreal=1.5 ks=1 kd=0.3",
      "granier",
      "granier nreal=1.4 d=1500 n=40 m=60 tilt=0.2 kd=0.1",
      "poulin d=2 h=0.01 n=100 ks=0.8 kd=0.2",
      "poulin d=3 h=0.3 n=20 ks=(0.5, 0.3, 0.7) kd=0.3",
      "poulin d=0.5 h=0 n=0 ks=1 kd=0",
      "he sigma=0.5 tau=3 lambda=800",
      "he",
      "he sigma=0.05 tau=1 lambda=(700, 500, 400) nreal=0.617 nimag=2.63 kd=0.2",
      "he sigma=4 tau=4 lambda=400",
  };
  return cases;
}

/// Both ends of every parameter's range, one at a time, and all at once.
std::vector<std::string> extreme_cases();

/// A direction at an angle from the normal, in degrees.
inline Vec3f direction(double theta_degrees, double phi_degrees) {
  const double theta = theta_degrees * std::numbers::pi / 180;
  const double phi = phi_degrees * std::numbers::pi / 180;
  return Vec3f(static_cast<float>(std::sin(theta) * std::cos(phi)),
               static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)));
}

/// Pairs of directions: random ones, and hard ones (grazing, equal, mirrored, nearly so, under the horizon).
struct Pair {
  Vec3f u, v;
};
std::vector<Pair> direction_pairs(int count, std::uint32_t seed);

}  // namespace test
