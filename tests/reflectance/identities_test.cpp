// Known properties of models: published numbers, closed forms, limits in which one model equals another, and
// textbook formulas where they keep their digits.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "renderer/reflectance/reflector.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/statistics/quadrature.h"

namespace {

using reflectance::Brdf;
using reflectance::Rgb;
using reflectance::Vec3f;
using test::brdf_of;
using test::easy_pairs;
using test::Pair;

/// Returns the albedo of the first channel, with the delta part.
double albedo_with_specular(const std::string& text, double theta) {
  const Brdf brdf = brdf_of(text);
  const Vec3f u = test::direction(theta, 25);
  const auto reflected = [&](const Vec3f& v) { return evaluate(brdf, u, v).x * double(v.z); };
  const int depth = test::info_of(brdf).not_continuous.empty() ? 0 : 4;
  const statistics::Quadrature quadrature(reflected, reflectance::mirrored(u), depth > 0 ? 1e-7 : 1e-8,
                                          depth);
  return quadrature.over_hemisphere() + specular_weight(brdf, u).x;
}

void expect_same(const std::string& one, const std::string& other, float tolerance) {
  for (const Pair& pair : test::direction_pairs(5000, 21)) {
    const Rgb expected = evaluate(brdf_of(other), pair.u, pair.v);
    const Rgb actual = evaluate(brdf_of(one), pair.u, pair.v);
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(actual[k], expected[k], tolerance * expected[k]) << pair.u << pair.v;
    }
  }
}

/// Compares the first channel of a BRDF with a function of cu, cv, the unit vector h and u.h.
template <class Function>
void expect_printed(const std::string& text, Function printed) {
  const Brdf brdf = brdf_of(text);
  for (const Pair& pair : easy_pairs()) {
    const Imath::V3d u(pair.u);
    const Imath::V3d v(pair.v);
    const Imath::V3d h = (u + v).normalized();
    const double expected = printed(u.z, v.z, h, u.dot(h));
    ASSERT_NEAR(evaluate(brdf, pair.u, pair.v).x, expected, 2e-5 * expected) << u << v;
  }
}

double fifth(double x) { return std::pow(x, 5); }
double schlick(double f0, double c) { return f0 + (1 - f0) * fifth(1 - c); }
double fresnel(double c, double n, double k) {
  return reflectance::glsl::TorranceFormula<double>().fresnel(c, n, k);
}

struct AlbedoRow {
  std::string brdf;
  double at_0, at_45, at_80;
};

class Albedo : public testing::TestWithParam<AlbedoRow> {};

TEST_P(Albedo, IsThatOfTheLiterature) {
  const AlbedoRow& row = GetParam();
  EXPECT_NEAR(albedo_with_specular(row.brdf, 0), row.at_0, 1e-4 * std::max(1.0, row.at_0));
  EXPECT_NEAR(albedo_with_specular(row.brdf, 45), row.at_45, 1e-4 * std::max(1.0, row.at_45));
  EXPECT_NEAR(albedo_with_specular(row.brdf, 80), row.at_80, 1e-4 * std::max(1.0, row.at_80));
}

// The instances of the thesis' table 5.5.
INSTANTIATE_TEST_SUITE_P(
    Table, Albedo,
    testing::Values(AlbedoRow{"minnaert k=0.8 kd=1", 1.1111, 1.1909, 1.5770},
                    AlbedoRow{"phong n=100 ks=0.4 kd=0.6", 0.6246, 0.6174, 0.6043},
                    AlbedoRow{"blinn n=100 ks=1 kd=0.67", 0.9069, 0.7908, 0.6817},
                    AlbedoRow{"lewis n=100 ks=1 kd=0", 1.0000, 0.7071, 0.1752},
                    AlbedoRow{"torrance m=0.35 nreal=0.617 nimag=2.63 ks=0.7 kd=0.3", 0.8106, 0.7835, 0.8098},
                    AlbedoRow{"ward sx=0.2 ks=0.5 kd=0.5", 0.9475, 0.8191, 0.6081},
                    AlbedoRow{"schlick SC=0.7 Sr=0.31 Sp=1", 0.5293, 0.5927, 1.8992},
                    AlbedoRow{"oren s=0 r=1", 1, 1, 1}, AlbedoRow{"eon rough=0.7 kd=1", 1, 1, 1},
                    AlbedoRow{"lafortune n=100 kp=0.96", 1.0216, 1.0036, 0.9708},
                    AlbedoRow{"coupled Rm=1 R0=0.05", 1, 1, 1},
                    AlbedoRow{"ashikhmin nu=25 nv=25 ks=0.39 kd=0.6", 0.6889, 0.6314, 0.4353}),
    [](const auto& instance) { return instance.param.brdf.substr(0, instance.param.brdf.find(' ')); });

// Lobes too narrow for quadrature, by their own samplers: their limit is a mirror.
TEST(NarrowLobe, ReflectsWhatAMirrorDoes) {
  constexpr double Cosine = 0.7660444431;
  const std::pair<std::string, double> rows[] = {
      {"torrance rough=0.0003 nreal=0.617 nimag=2.63 ks=1 kd=0", fresnel(Cosine, 0.617, 2.63)},
      {"ashikhmin ex=1000000 Rs=0.3 Rd=0", schlick(0.3, Cosine)},
      {"ashikhmin ex=1000000 ey=10000 Rs=0.3 Rd=0", schlick(0.3, Cosine)},
      {"schlick SC=0.3 Sr=1e-7", schlick(0.3, Cosine)},
      {"strauss s=1 ks=1 kd=0", Cosine},
      {"lafortune n=1000000 kp=0", 2e-6 * M_PI * Cosine},
      {"lafortune n=10000 kp=0 Cx=-1.002 Cy=-1.002 Cz=1.002", 2e-4 * M_PI * Cosine * std::pow(1.002, 10000)},
      {"neumann r=0.001", 1},
  };
  const Vec3f u = test::direction(40, 25);
  for (const auto& [text, expected] : rows) {
    const reflectance::Reflector reflector(brdf_of(text), reflectance::OwnScheme());
    std::mt19937 random(22);
    std::uniform_real_distribution<float> uniform(0, 1);
    constexpr int Samples = 20000;
    double sum = 0;
    for (int i = 0; i < Samples; ++i) {
      const reflectance::Uniforms xi = {{uniform(random), uniform(random)}, uniform(random)};
      const auto sample = reflector.sample(u, xi);
      if (sample) sum += sample->weight.x;
    }
    EXPECT_NEAR(sum / Samples, expected, 0.01 * expected) << text;
  }
}

class NoGain : public testing::TestWithParam<std::string> {};

TEST_P(NoGain, InAWhiteFurnace) {
  for (const double theta : {0.0, 30.0, 60.0, 75.0, 85.0, 89.0, 89.9}) {
    EXPECT_LE(albedo_with_specular(GetParam(), theta), 1.0002) << theta;
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, NoGain,
                         testing::Values("diffuse kd=1", "minnaert k=1.5 kd=1", "lewis n=20 ks=0.7 kd=0.3",
                                         "torrance rough=0.2 nreal=0.001 nimag=100 ks=1 kd=0",
                                         "torrance rough=1 nreal=0.001 nimag=100 ks=1 kd=0",
                                         "coupled Rm=1 R0=0.3", "ashikhmin ex=25 Rs=0.39 Rd=1",
                                         "ashikhmin ex=1000 Rs=0 Rd=1", "ashikhmin ex=5 ey=200 Rs=1",
                                         "neumann r=0.3", "neumann r=0.5 ry=1.7", "neumann r=1 retro=true"),
                         [](const auto& instance) {
                           return instance.param.substr(0, instance.param.find(' ')) + "_" +
                                  std::to_string(instance.index);
                         });

TEST(Fresnel, OfAConductorAtNormalIncidence) {
  for (const double n : {0.001, 0.177, 0.617, 1.0, 2.485, 100.0}) {
    for (const double k : {0.0, 0.5, 3.638, 100.0}) {
      const double expected = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
      EXPECT_NEAR(fresnel(1, n, k), expected, 1e-12) << n << " " << k;
    }
  }
}

// Cook and Torrance 1981, equation of F in g and c.
TEST(Fresnel, OfADielectricIsCookAndTorrances) {
  for (const double n : {1.1, 1.5, 2.4}) {
    for (const double c : {0.05, 0.3, 0.7, 0.99, 1.0}) {
      const double g = std::sqrt(n * n + c * c - 1);
      const double ratio = (g - c) / (g + c);
      const double inner = (c * (g + c) - 1) / (c * (g - c) + 1);
      const double expected = ratio * ratio / 2 * (1 + inner * inner);
      EXPECT_NEAR(fresnel(c, n, 0), expected, 1e-12) << n << " " << c;
    }
  }
}

TEST(Fresnel, AtItsLimits) {
  EXPECT_EQ(fresnel(0.5, 1, 0), 0);
  EXPECT_EQ(fresnel(0, 1.5, 0), 1);
  EXPECT_EQ(fresnel(0.3, 0, 2), 1);
  EXPECT_NEAR(fresnel(1e-9, 0.617, 2.63), 1, 1e-7);
  EXPECT_EQ(fresnel(0.1, 0.5, 0), 1) << "total reflection";
  EXPECT_NEAR(fresnel(0.8, 1e-3, 100), 1, 1e-6);
}

// The textbook form, which loses its digits where n is near 1.
TEST(Fresnel, IsTheTextbookForm) {
  for (const double n : {0.2, 0.9, 1.5, 3.0}) {
    for (const double k : {0.3, 2.0, 7.0}) {
      for (const double c : {0.1, 0.5, 0.9}) {
        const double s2 = 1 - c * c;
        const double t = n * n - k * k - s2;
        const double q = std::sqrt(t * t + 4 * n * n * k * k);
        const double a = std::sqrt((q + t) / 2);
        const double rs = (q + c * c - 2 * a * c) / (q + c * c + 2 * a * c);
        const double rp =
            rs * (c * c * q + s2 * s2 - 2 * a * c * s2) / (c * c * q + s2 * s2 + 2 * a * c * s2);
        EXPECT_NEAR(fresnel(c, n, k), (rs + rp) / 2, 1e-12);
      }
    }
  }
}

TEST(Fresnel, IsInFloatWhatItIsInDouble) {
  reflectance::glsl::TorranceFormula<float> in_float;
  for (const float n : {0.001F, 0.1F, 0.617F, 0.9999F, 1.0001F, 1.5F, 100.0F}) {
    for (const float k : {0.0F, 1e-4F, 0.3F, 3.0F, 100.0F}) {
      for (const float c : {1e-6F, 0.01F, 0.3F, 0.8F, 1.0F}) {
        const double exact = fresnel(c, n, k);
        EXPECT_NEAR(in_float.fresnel(c, n, k), exact, 1e-4 * exact) << n << " " << k << " " << c;
      }
    }
  }
}

TEST(Minnaert, IsLambertForK1) { expect_same("minnaert k=1 kd=0.7", "diffuse kd=0.7", 1e-6F); }

TEST(Minnaert, HasItsClosedAlbedo) {
  for (const double theta : {0.0, 50.0, 80.0}) {
    const double cosine = std::cos(theta * M_PI / 180);
    EXPECT_NEAR(albedo_with_specular("minnaert k=3 kd=0.5", theta), 2 * 0.5 / 4 * cosine * cosine, 1e-5);
  }
}

TEST(Oren, IsLambertForS0) { expect_same("oren s=0 r=0.7", "diffuse kd=0.7", 1e-6F); }

// Oren and Nayar 1994, equations 31 to 34.
TEST(Oren, IsAsPrinted) {
  const Brdf brdf = brdf_of("oren s=0.5 r=0.8");
  for (const Pair& pair : easy_pairs()) {
    const double theta_u = std::acos(double(pair.u.z));
    const double theta_v = std::acos(double(pair.v.z));
    const double phi = std::atan2(pair.u.y, pair.u.x) - std::atan2(pair.v.y, pair.v.x);
    const double cp = std::cos(phi);
    const double alpha = std::max(theta_u, theta_v);
    const double beta = std::min(theta_u, theta_v);
    const double s2 = 0.25;
    const double c1 = 1 - 0.5 * s2 / (s2 + 0.33);
    const double lower = cp < 0 ? std::pow(2 * beta / M_PI, 3) : 0;
    const double c2 = 0.45 * s2 / (s2 + 0.09) * (std::sin(alpha) - lower);
    const double c3 = 0.125 * s2 / (s2 + 0.09) * std::pow(4 * alpha * beta / (M_PI * M_PI), 2);
    const double direct =
        c1 + cp * c2 * std::tan(beta) + (1 - std::abs(cp)) * c3 * std::tan((alpha + beta) / 2);
    const double between = 0.17 * 0.8 * s2 / (s2 + 0.13) * (1 - cp * std::pow(2 * beta / M_PI, 2));
    EXPECT_NEAR(evaluate(brdf, pair.u, pair.v).x, 0.8 / M_PI * (direct + between), 1e-5);
  }
}

TEST(Oren, GainsAsMuchAsItsFitDoes) {
  EXPECT_NEAR(albedo_with_specular("oren s=0.2 r=1", 80), 1.019, 5e-4);
  EXPECT_NEAR(albedo_with_specular("oren s=0.3 r=1", 89.9), 1.05, 5e-3);
}

TEST(Eon, IsLambertForRoughness0) { expect_same("eon rough=0 kd=0.7", "diffuse kd=0.7", 1e-6F); }

TEST(Sheen, ReflectsItsAlbedo) {
  for (const double rough : {0.2, 0.5, 1.0}) {
    for (const double theta : {10.0, 60.0, 85.0}) {
      const double cosine = std::cos(theta * M_PI / 180);
      EXPECT_NEAR(albedo_with_specular("sheen rough=" + std::to_string(rough), theta),
                  reflectance::glsl::SheenFormula<double>().sheen_albedo(cosine, rough), 1e-4)
          << rough << " at " << theta;
    }
  }
}

// Zeltner, Burley and Chiang 2022: no view gets more than a white surface gives.
TEST(Sheen, ShinesMostTowardsGrazing) {
  reflectance::glsl::SheenFormula<double> sheen;
  for (int i = 1; i <= 100; ++i) {
    EXPECT_GT(sheen.sheen_albedo(0.02, 0.01 * i), sheen.sheen_albedo(0.9, 0.01 * i));
    for (int k = 0; k <= 100; ++k) EXPECT_LT(sheen.sheen_albedo(0.01 * k, 0.01 * i), 1) << i << " " << k;
  }
}

TEST(Torrance, IsAsPrinted) {
  expect_printed("torrance m=0.4 nreal=1.5 ks=0.8 kd=0.2",
                 [](double cu, double cv, const Imath::V3d& h, double c) {
                   const double t2 = (1 - h.z * h.z) / (h.z * h.z);
                   const double d = std::exp(-t2 / 0.16) / (0.16 * std::pow(h.z, 4));
                   const double g = std::min({1.0, 2 * h.z * cu / c, 2 * h.z * cv / c});
                   return 0.2 / M_PI + 0.8 * d * g * fresnel(c, 1.5, 0) / (4 * M_PI * cu * cv);
                 });
}

TEST(Torrance, OfAPerfectConductorNearlyReflectsAll) {
  EXPECT_NEAR(albedo_with_specular("torrance m=0.05 nreal=0.001 nimag=100 ks=1 kd=0", 10), 1, 2e-3);
}

TEST(Lafortune, IsPhongsLobe) {
  for (const std::string n : {"0", "20", "100000"}) {
    expect_same("lafortune kp=0.3 n=" + n, "phong ks=1 kd=0.3 n=" + n, 1e-5F);
  }
}

TEST(Lafortune, IsAsPrinted) {
  const Brdf brdf = brdf_of("lafortune n=7 kp=0.2 Cx=-0.8 Cy=0.6 Cz=1.1");
  for (const Pair& pair : easy_pairs()) {
    const double b = -0.8 * pair.u.x * pair.v.x + 0.6 * pair.u.y * pair.v.y + 1.1 * pair.u.z * pair.v.z;
    const double expected = 0.2 / M_PI + (b > 0 ? std::pow(b, 7) : 0);
    EXPECT_NEAR(evaluate(brdf, pair.u, pair.v).x, expected, 1e-5 * expected);
  }
}

TEST(Lafortune, RefusesAPeakThatIsNoNumber) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_brdf("lafortune n=31 Cz=10", "test", diagnostics);
  ASSERT_TRUE(model);
  EXPECT_FALSE(grf::check(*model, reflectance::brdf_infos(), "BRDF", diagnostics));
  EXPECT_NE(diagnostics.to_text().find("n log(max(|Cx|, |Cy|, |Cz|)) must be at most 69"), std::string::npos)
      << diagnostics.to_text();
  EXPECT_NO_THROW(brdf_of("lafortune n=29 Cz=10"));
}

TEST(Coupled, ReflectsAllAtEveryAngle) {
  for (const double theta : {0.0, 30.0, 70.0, 85.0, 89.9}) {
    EXPECT_NEAR(albedo_with_specular("coupled Rm=1 R0=0.05", theta), 1, 1e-4) << theta;
    EXPECT_NEAR(albedo_with_specular("coupled Rm=1 R0=0.6", theta), 1, 1e-4) << theta;
  }
}

TEST(Coupled, HasAMirrorOfItsFresnelReflectance) {
  const Vec3f u = test::direction(60, 10);
  const Rgb weight = specular_weight(brdf_of("coupled Rm=0.5 Ro=(0.04, 0.2, 0.9)"), u);
  EXPECT_NEAR(weight.x, schlick(0.04, 0.5), 1e-6);
  EXPECT_NEAR(weight.y, schlick(0.2, 0.5), 1e-6);
  EXPECT_NEAR(weight.z, schlick(0.9, 0.5), 1e-6);
}

TEST(Ashikhmin, IsAsPrinted) {
  expect_printed(
      "ashikhmin ex=8 ey=30 Rs=0.4 Rd=0.7", [](double cu, double cv, const Imath::V3d& h, double c) {
        const double e = (8 * h.x * h.x + 30 * h.y * h.y) / (h.x * h.x + h.y * h.y);
        const double lobe = std::sqrt(9.0 * 31) / (8 * M_PI) * std::pow(h.z, e) / (c * std::max(cu, cv));
        const double brackets = (1 - fifth(1 - cu / 2)) * (1 - fifth(1 - cv / 2));
        return lobe * schlick(0.4, c) + 28 * 0.7 / (23 * M_PI) * (1 - 0.4) * brackets;
      });
}

TEST(Ashikhmin, IsIsotropicForEqualExponents) {
  expect_same("ashikhmin ex=40", "ashikhmin ex=40 ey=40", 0);
  EXPECT_FALSE(is_anisotropic(brdf_of("ashikhmin nu=40")));
  EXPECT_TRUE(is_anisotropic(brdf_of("ashikhmin nu=40 nv=41")));
}

TEST(Ashikhmin, IsVeryWideForExponentsOf0) {
  EXPECT_NEAR(albedo_with_specular("ashikhmin ex=0 Rs=1 Rd=0", 0), 0.14, 5e-3);
}

// Schlick 1994; the lines of the formula as his paper has them.
double schlick_layer(double cu, double cv, const Imath::V3d& h, double r, double p) {
  const auto g = [&](double c) { return c / (r + (1 - r) * c); };
  const double t2 = h.z * h.z;
  const double z = r / std::pow(1 + r * t2 - t2, 2);
  const double w2 = h.x * h.x / (h.x * h.x + h.y * h.y);
  const double a = std::sqrt(p / (p * p - p * p * w2 + w2));
  const double both = g(cu) * g(cv);
  return (both * z * a + 1 - both) / (4 * M_PI * cu * cv);
}

TEST(Schlick, IsAsPublished) {
  expect_printed("schlick SC=0.6 Sr=0.2 Sp=0.5", [](double cu, double cv, const Imath::V3d& h, double c) {
    return schlick(0.6, c) * schlick_layer(cu, cv, h, 0.2, 0.5);
  });
  expect_printed("schlick SC=0.1 Sr=0.2 Sp=0.5 Ly=true DC=0.8 Dr=0.7 Dp=0.9",
                 [](double cu, double cv, const Imath::V3d& h, double c) {
                   const double s = schlick(0.1, c);
                   return s * schlick_layer(cu, cv, h, 0.2, 0.5) +
                          (1 - s) * schlick(0.8, c) * schlick_layer(cu, cv, h, 0.7, 0.9);
                 });
}

TEST(Schlick, KeepsToAThinLobeForIsotropyTowards0) {
  expect_same("schlick Sp=0", "schlick Sp=0.0001", 0);
  // Where h is across the lobe the factor of the azimuth is sqrt(p), along it 1/sqrt(p) ...
  expect_printed("schlick Sp=0.0001", [](double cu, double cv, const Imath::V3d& h, double c) {
    return schlick(0.7, c) * schlick_layer(cu, cv, h, 0.31, 1e-4);
  });
  // ... and the light between facets does not know of it.
  const Vec3f u = test::direction(30, 0);
  const Vec3f v = test::direction(10, 0);
  EXPECT_GT(evaluate(brdf_of("schlick Sp=1"), u, v).x, evaluate(brdf_of("schlick Sp=0"), u, v).x);
  EXPECT_GT(evaluate(brdf_of("schlick Sp=0"), u, v).x, 0);
}

TEST(Schlick, IsAMirrorWithoutRoughness) {
  const Vec3f u = test::direction(60, 10);
  const Brdf one = brdf_of("schlick SC=0.7 Sr=0");
  EXPECT_NEAR(specular_weight(one, u).x, schlick(0.7, 0.5), 1e-6);
  EXPECT_EQ(evaluate(one, u, reflectance::mirrored(u)), Rgb(0));
  EXPECT_TRUE(has_specular_part(one));
  EXPECT_FALSE(has_nonspecular_part(one));

  const Brdf two = brdf_of("schlick SC=0.7 Sr=0.31 Ly=true DC=0.5 Dr=0");
  EXPECT_NEAR(specular_weight(two, u).x, (1 - schlick(0.7, 0.5)) * schlick(0.5, 0.5), 1e-6);
  EXPECT_TRUE(has_specular_part(two) && has_nonspecular_part(two));
  EXPECT_EQ(evaluate(two, u, test::direction(20, 100)),
            evaluate(brdf_of("schlick SC=0.7 Sr=0.31"), u, test::direction(20, 100)));

  EXPECT_FALSE(has_specular_part(brdf_of("schlick Sr=0.31 Ly=false Dr=0"))) << "there is no second layer";
  EXPECT_EQ(specular_weight(brdf_of("schlick Sr=0.31 Ly=false Dr=0"), u), Rgb(0));
}

TEST(Schlick, GainsTowardsGrazingAsPublished) {
  EXPECT_NEAR(albedo_with_specular("schlick SC=0.7 Sr=0.31", 70.3), 1, 2e-3);
  EXPECT_NEAR(albedo_with_specular("schlick SC=1 Sr=1", 60), 1, 2e-3);
}

TEST(Strauss, HasHisReflectivityCurves) {
  reflectance::glsl::StraussFormula<double> formula;
  EXPECT_EQ(formula.strauss_fresnel(0), 0);
  EXPECT_NEAR(formula.strauss_fresnel(1), 1, 1e-12);
  EXPECT_NEAR(formula.strauss_shadowing(1), 1, 1e-12);
  EXPECT_EQ(formula.strauss_shadowing(0), 0);
  const auto inverse_square = [](double x) { return 1 / (x * x); };
  for (const double x : {0.1, 0.5, 0.9}) {
    const double f =
        (inverse_square(x - 1.12) - inverse_square(1.12)) / (inverse_square(1 - 1.12) - inverse_square(1.12));
    const double g = (inverse_square(1 - 1.01) - inverse_square(x - 1.01)) /
                     (inverse_square(1 - 1.01) - inverse_square(1.01));
    EXPECT_NEAR(formula.strauss_fresnel(x), f, 1e-12);
    EXPECT_NEAR(formula.strauss_shadowing(1 - x), g, 1e-9);
  }
}

TEST(Strauss, IsMatteForSmoothnessOf0AndAMirrorFor1) {
  EXPECT_NEAR(albedo_with_specular("strauss s=0 m=1 ks=0 kd=0.8", 30), 0.8, 1e-5);
  EXPECT_NEAR(albedo_with_specular("strauss s=1 m=0 ks=1 kd=1", 30), std::cos(M_PI / 6), 2e-3)
      << "a normalised Phong lobe";
}

TEST(Strauss, HasTheColourOfAMetalInItsHighlight) {
  const Vec3f u(0, 0, 1);
  const Rgb metal = evaluate(brdf_of("strauss s=0.9 m=1 ks=1 kd=(1, 0.5, 0.25)"), u, u);
  const Rgb plastic = evaluate(brdf_of("strauss s=0.9 m=0 ks=1 kd=(1, 0.5, 0.25)"), u, u);
  EXPECT_NEAR(metal.y / metal.x, 0.5, 0.02);
  EXPECT_GT(plastic.y / plastic.x, 0.9);
}

TEST(Strauss, GainsLittle) {
  for (const double theta : {0.0, 45.0, 75.0, 85.0, 89.0}) {
    for (const std::string s : {"0", "0.2", "0.4", "0.7", "0.95"}) {
      EXPECT_LE(albedo_with_specular("strauss m=0 ks=1 kd=1 s=" + s, theta), 1.004) << s << " " << theta;
    }
  }
}

TEST(Neumann, IsLambertForR2) {
  expect_same("neumann r=2 ks=0.6 kd=0.1", "diffuse kd=0.7", 1e-6F);
  expect_same("neumann r=2 retro=true ks=0.6 kd=0.1", "diffuse kd=0.7", 1e-6F);
}

TEST(Neumann, ReflectsThePartOfItsDiscThatIsOverTheHorizon) {
  EXPECT_NEAR(albedo_with_specular("neumann r=0.2 ks=0.8", 0), 0.8, 1e-3);
  EXPECT_NEAR(albedo_with_specular("neumann r=0.2", 80), 0.527, 1e-3);
}

// The area of an ellipse within the unit disc, by the midpoint rule.
TEST(Neumann, KnowsTheAreaOfEllipsesThatCrossTheHorizon) {
  for (const auto& [a, b] : {std::pair(0.5, 0.7), std::pair(1.5, 0.3), std::pair(0.9, 1.2),
                             std::pair(1.0, 1.3), std::pair(2.0, 0.0001), std::pair(1.1, 2.0)}) {
    constexpr int Count = 100000;
    double area = 0;
    for (int i = 0; i < Count; ++i) {
      const double x = (i + 0.5) / Count;
      const double ellipse = x < a ? b * std::sqrt(1 - x * x / (a * a)) : 0;
      area += 4 * std::min(ellipse, std::sqrt(1 - x * x)) / Count;
    }
    EXPECT_NEAR(reflectance::glsl::NeumannFormula<double>().neumann_area(a, b), area, 1e-5 * area) << a << b;
  }
}

TEST(Parts, AreThoseThatABrdfHas) {
  EXPECT_TRUE(has_diffuse_part(brdf_of("oren")) && !has_glossy_part(brdf_of("oren")));
  EXPECT_TRUE(has_diffuse_part(brdf_of("eon")) && !has_glossy_part(brdf_of("eon")));
  EXPECT_TRUE(has_diffuse_part(brdf_of("coupled")) && has_specular_part(brdf_of("coupled")));
  EXPECT_FALSE(has_glossy_part(brdf_of("coupled")));
  EXPECT_FALSE(has_nonspecular_part(brdf_of("coupled Rm=0")));
  EXPECT_TRUE(has_glossy_part(brdf_of("lafortune kp=0")) && !has_diffuse_part(brdf_of("lafortune kp=0")));
  EXPECT_TRUE(has_glossy_part(brdf_of("ashikhmin Rs=0"))) << "it has a reflectance towards grazing";
  EXPECT_FALSE(has_diffuse_part(brdf_of("strauss s=1")));
  EXPECT_FALSE(has_nonspecular_part(brdf_of("phong ks=0 kd=0")));
  EXPECT_FALSE(has_nonspecular_part(brdf_of("specular")));
  EXPECT_TRUE(is_anisotropic(brdf_of("lafortune Cx=-0.5")) && !is_anisotropic(brdf_of("lafortune")));
  EXPECT_TRUE(is_anisotropic(brdf_of("neumann ry=0.1")) && !is_anisotropic(brdf_of("neumann r=0.3")));
  EXPECT_TRUE(is_anisotropic(brdf_of("schlick Sp=0.5")) && !is_anisotropic(brdf_of("schlick Dp=0.5")));
  EXPECT_FALSE(is_anisotropic(brdf_of("torrance")));
}

}  // namespace
