// How well the pdfs of sampling schemes match their targets. An error in a table or a probability keeps
// estimates unbiased, so that no other test sees it, but makes the picture noisy. The limits are about 10 %
// above the measured values; none can be 0 unless the lobe is the BRDF's own times the cosine.
#include <cctype>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/reflector.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"

namespace {

using reflectance::Reflector;
using reflectance::Vec3f;

struct FitCase {
  std::string scheme;
  std::string brdf;
  double most;  ///< limit of the misplaced fraction, for any of the views
};

/// Returns the total variation distance of the pdf from f cos(theta_v): half the integral of |p - f
/// cos/albedo|.
double misplaced_fraction(const Reflector& reflector, const Vec3f& u) {
  constexpr std::uint32_t Count = 20000;
  constexpr double Share = 2 * M_PI / Count;
  std::vector<std::pair<double, double>> values;
  double albedo = 0;
  for (std::uint32_t i = 0; i < Count; ++i) {
    const Vec3f v = reflectance::uniform_direction(reflectance::halton_point(i).direction);
    values.emplace_back(reflector.pdf(u, v), reflectance::mean(reflector.evaluate(u, v)) * v.z);
    albedo += values.back().second * Share;
  }
  double sum = 0;
  for (const auto& [pdf, value] : values) sum += std::abs(pdf - value / albedo) * Share / 2;
  return sum;
}

class Fit : public testing::TestWithParam<FitCase> {};

TEST_P(Fit, DensityIsNearTheBrdfTimesTheCosine) {
  const Reflector reflector(test::brdf_of(GetParam().brdf), test::scheme_of(GetParam().scheme));
  constexpr std::pair<double, double> Views[] = {{7, 20}, {34, 65}, {34, 250}, {58, 150}, {74, 20}, {74, 65}};
  for (const auto& [theta, phi] : Views) {
    EXPECT_LT(misplaced_fraction(reflector, test::direction(theta, phi)), GetParam().most)
        << theta << " " << phi;
  }
}

std::string name_of_fit(const testing::TestParamInfo<FitCase>& instance) {
  const std::string text =
      instance.param.scheme + " " + instance.param.brdf.substr(0, instance.param.brdf.find(' '));
  std::string name;
  for (const char c : text) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, Fit,
    testing::Values(
        FitCase{"own", "minnaert k=3 kd=1", 0.02}, FitCase{"own", "phong n=20 ks=1 kd=0.1", 0.3},
        FitCase{"own", "ward sx=0.2 sy=0.4 ks=0.6 kd=0.3", 0.3},
        FitCase{"own", "torrance rough=0.4 nreal=0.2 nimag=3.6 ks=0.7 kd=0.3", 0.05},
        FitCase{"own", "ashikhmin ex=10 ey=40 Rs=0.5 Rd=0.4", 0.19},
        FitCase{"own", "schlick SC=0.7 Sr=0.31", 0.17}, FitCase{"own", "strauss s=0.7 m=0.5", 0.23},
        FitCase{"own", "neumann r=0.5", 0.31}, FitCase{"own", "kajiya", 0.29},
        FitCase{"own", "beardmaxwell sigma=0.4", 0.095}, FitCase{"own", "hanrahan", 0.095},
        FitCase{"own", "granier tilt=0.2", 0.4}, FitCase{"own", "poulin d=2 h=0.01 n=20", 0.28},
        FitCase{"own", "he sigma=0.5 tau=3 lambda=800", 0.32}, FitCase{"own", "lafortune n=10 Cx=-0.8", 0.22},
        FitCase{"own", "0.5 diffuse kd=0.8 + 0.4 lewis n=60 ks=1 kd=0", 0.27},
        FitCase{"hemisphere", "lewis n=50 ks=1 kd=0", 0.2}, FitCase{"sphere", "phong n=50 ks=1 kd=0", 0.2},
        FitCase{"anisotropic", "ashikhmin ex=15 ey=60 Rs=1 Rd=0", 0.23},
        FitCase{"reject nQT=30 res=200", "blinn n=20 ks=0.5 kd=0.5", 0.02},
        FitCase{"adaptive", "blinn n=20 ks=0.5 kd=0.5", 0.03},
        FitCase{"adaptive nQT=20", "ward sx=0.3 sy=0.6 ks=0.6 kd=0.3", 0.047},
        FitCase{"factored J=6 K=4", "lewis n=6 ks=1 kd=0", 0.115},
        FitCase{"factored half=true J=4 K=2", "blinn n=20 ks=1 kd=0", 0.075},
        FitCase{"factored uPh=8 J=8 K=2 half=true", "ward sx=0.3 sy=0.6 ks=0.6 kd=0.3", 0.17},
        FitCase{"cascadeCDF nTh=64 nPh=32", "blinn n=20 ks=1 kd=0", 0.037},
        FitCase{"cascadeCDF nTh=64 nPh=32 compress=true", "blinn n=20 ks=1 kd=0", 0.056},
        FitCase{"cascadeCDF nTh=24 nPh=16", "ward sx=0.3 sy=0.6 ks=0.6 kd=0.3", 0.105}),
    name_of_fit);

}  // namespace
