// OpenPBR: identities with the models that it is made of, closed forms of its specification, and its energy.
#include "renderer/reflectance/openpbr.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using reflectance::Brdf;
using reflectance::Rgb;
using reflectance::Vec3f;

using OpenPbrInDouble = reflectance::glsl::OpenPbrFormula<double>;

/// Expects equal values of two BRDFs in all channels.
void expect_same_brdfs(const std::string& one, const std::string& other, float tolerance = 1e-5F) {
  const Brdf a = test::brdf_of(one);
  const Brdf b = test::brdf_of(other);
  for (const test::Pair& pair : test::easy_pairs()) {
    const Rgb of_a = evaluate(a, pair.u, pair.v);
    const Rgb of_b = evaluate(b, pair.u, pair.v);
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(of_a[i], of_b[i], tolerance * (of_b[i] + 1e-3F)) << one;
  }
}

TEST(OpenPbr, OfMetalIsGgxWithATint) {
  expect_same_brdfs("openpbr metalness=1 baseColor=(0.9, 0.6, 0.3) specularColor=(0.7, 0.9, 1) roughness=0.6",
                    "ggx alpha=0.36 F0=(0.9, 0.6, 0.3) F82=(0.7, 0.9, 1)");
  expect_same_brdfs(
      "openpbr metalness=1 baseWeight=0.5 baseColor=(0.8, 0.6, 0.4) roughness=0.5 anisotropy=0.6 "
      "rotation=0.3",
      "ggx alpha=0.25 anisotropy=0.6 rotation=0.3 F0=(0.4, 0.3, 0.2)");
}

// Light that is reflected twice has the weight twice, and is not seen where the facets mirror.
TEST(OpenPbr, ScalesTheReflectanceOfMetal) {
  const Vec3f u = test::direction(0, 0);
  const std::string metal = "openpbr metalness=1 baseColor=0.6 roughness=0.1 specularWeight=";
  const float whole = evaluate(test::brdf_of(metal + "1"), u, u).x;
  EXPECT_NEAR(evaluate(test::brdf_of(metal + "0.5"), u, u).x / whole, 0.5, 1e-4);
  EXPECT_NEAR(evaluate(test::brdf_of(metal + "9"), u, u).x / whole, 1, 1e-4) << "at most all of it";
}

TEST(OpenPbr, OverBlackIsADielectric) {
  expect_same_brdfs("openpbr baseColor=0 roughness=0.7 ior=1.7", "ggx alpha=0.49 nreal=1.7");
  expect_same_brdfs("openpbr baseWeight=0 roughness=0.7 ior=1.7 filmWeight=1 filmThickness=0.4 filmIor=1.3",
                    "thinfilm alpha=0.49 nreal=1.7 thickness=400 film=1.3");
  expect_same_brdfs("openpbr baseColor=0 roughness=0.5 filmWeight=1 filmThickness=0.01 filmIor=1",
                    "ggx alpha=0.25 nreal=1.5", 0.02F);
}

TEST(OpenPbr, WithoutSpecularReflectionIsEon) {
  expect_same_brdfs("openpbr baseColor=(0.9, 0.5, 0.2) specularWeight=0 diffuseRough=0.7",
                    "eon rough=0.7 kd=(0.9, 0.5, 0.2)");
}

TEST(OpenPbr, MixesMetalAndDielectric) {
  const std::string rest = " baseColor=(0.9, 0.5, 0.2) roughness=0.5";
  const Brdf dielectric = test::brdf_of("openpbr metalness=0" + rest);
  const Brdf metal = test::brdf_of("openpbr metalness=1" + rest);
  const Brdf mixture = test::brdf_of("openpbr metalness=0.25" + rest);
  for (const test::Pair& pair : test::easy_pairs()) {
    const float expected =
        0.75F * evaluate(dielectric, pair.u, pair.v).y + 0.25F * evaluate(metal, pair.u, pair.v).y;
    ASSERT_NEAR(evaluate(mixture, pair.u, pair.v).y, expected, 1e-5F * expected);
  }
}

/// The value of a nearly smooth black dielectric where it mirrors, in one channel.
double mirrored_at_normal(const std::string& text) {
  const Vec3f u = test::direction(0, 0);
  return evaluate(test::brdf_of("openpbr baseColor=0 roughness=0.1 " + text), u, u).x;
}

TEST(OpenPbr, ScalesTheReflectanceAtNormalIncidence) {
  EXPECT_NEAR(mirrored_at_normal("specularWeight=0.3") / mirrored_at_normal(""), 0.3, 1e-4);
  EXPECT_NEAR(mirrored_at_normal("specularWeight=3") / mirrored_at_normal(""), 3, 1e-3);
  EXPECT_NEAR(mirrored_at_normal("specularWeight=25 ior=2.5") / mirrored_at_normal("") * 0.04, 0.9025, 1e-3)
      << "at most";
}

// A coat of the index of refraction of air has no surface, and a base below it is as if its roughness were
// the root of the root of r^4 + 2 rc^4.
TEST(OpenPbr, WidensTheHighlightBelowARoughCoat) {
  const double roughened = std::pow(std::pow(0.3, 4) + 2 * std::pow(0.5, 4), 0.25);
  expect_same_brdfs("openpbr metalness=1 roughness=0.3 coatWeight=1 coatIor=1 coatRoughness=0.5",
                    "openpbr metalness=1 roughness=" + std::to_string(roughened), 1e-4F);
}

// Below a smooth coat, the reflectance at normal incidence is that between both indices of refraction, and
// the coat transmits nearly 1 - F. Its own lobe is too narrow to be seen here.
TEST(OpenPbr, ReflectsLessBelowACoat) {
  const std::string bare = "openpbr baseColor=0 roughness=0.5 coatDarkening=0 coatRoughness=0.001 ior=1.6";
  const Vec3f u = test::direction(10, 0);
  const auto remaining = [&](const std::string& coat) {
    return evaluate(test::brdf_of(bare + coat), u, u).x / evaluate(test::brdf_of(bare), u, u).x;
  };
  EXPECT_NEAR(remaining(" coatWeight=1 coatIor=1.6"), 0, 1e-5);
  const double between = std::pow(0.1 / 3.1, 2) / std::pow(0.6 / 2.6, 2);
  EXPECT_NEAR(remaining(" coatWeight=1 coatIor=1.5"), between * 0.96, 0.003);
}

double ratio_at(const std::string& one, const std::string& other, const Vec3f& u, const Vec3f& v) {
  return double(evaluate(test::brdf_of(one), u, v).x) / double(evaluate(test::brdf_of(other), u, v).x);
}

// The absorption of the coat is by Beer's law, along the refracted ray.
TEST(OpenPbr, AbsorbsLightInTheCoat) {
  const std::string coat =
      "openpbr coatWeight=1 coatRoughness=0.01 coatDarkening=0 specularWeight=0 coatIor=1.5 coatColor=";
  const auto path = [](double degrees) {
    const double sine = std::sin(degrees * M_PI / 180) / 1.5;
    return 1 / std::sqrt(1 - sine * sine);
  };
  EXPECT_NEAR(ratio_at(coat + "0.25", coat + "1", test::direction(60, 0), test::direction(30, 90)),
              std::pow(0.25, (path(60) + path(30)) / 2), 1e-4);
}

// Elias and Elias 2001: a Lambert base of albedo E below a smooth coat is darker by (1 - K)/(1 - E K), where
// the inside of the coat reflects K of diffuse light, 0.596 for an index of 1.5 by integration over Fresnel's
// equations.
TEST(OpenPbr, DarkensBelowTheCoat) {
  double outside = 0;
  constexpr int Count = 10000;
  for (int i = 0; i < Count; ++i) {
    const double c = (i + 0.5) / Count;
    const double inner = std::sqrt(1 - (1 - c * c) / 2.25);
    const double across = (c - 1.5 * inner) / (c + 1.5 * inner);
    const double parallel = (1.5 * c - inner) / (1.5 * c + inner);
    outside += c * (across * across + parallel * parallel) / Count;
  }
  const double inside = 1 - (1 - outside) / 2.25;
  ASSERT_NEAR(inside, 0.596, 0.001);
  for (const double albedo : {0.2, 0.5, 0.9}) {
    const std::string coat =
        "openpbr coatWeight=1 coatRoughness=0.01 specularWeight=0 coatIor=1.5 baseColor=" +
        std::to_string(albedo) + " coatDarkening=";
    const double darkening = (1 - inside) / (1 - albedo * inside);
    const Vec3f u = test::direction(30, 0);
    const Vec3f v = test::direction(10, 90);
    EXPECT_NEAR(ratio_at(coat + "1", coat + "0", u, v), darkening, 0.012) << albedo;
    EXPECT_NEAR(ratio_at(coat + "0.5", coat + "0", u, v), (1 + darkening) / 2, 0.006) << albedo;
  }
}

TEST(OpenPbr, BelowFibresLosesWhatTheseReflect) {
  const Brdf with = test::brdf_of("openpbr baseColor=0.5 fuzzWeight=0.6 fuzzColor=0 fuzzRoughness=0.4");
  const Brdf without = test::brdf_of("openpbr baseColor=0.5");
  const Brdf fibres = test::brdf_of("sheen rough=0.4");
  for (const double degrees : {10.0, 40.0, 70.0}) {
    const Vec3f u = test::direction(degrees, 0);
    const Vec3f v = reflectance::mirrored(u);
    const double expected = 1 - 0.6 * test::albedo(fibres, u, 1e-6);
    EXPECT_NEAR(evaluate(with, u, v).x / evaluate(without, u, v).x, expected, 1e-3) << degrees;
  }
}

double albedo_of_openpbr(const std::string& text, double degrees) {
  return test::albedo("openpbr " + text, degrees, 25, 1e-6);
}

TEST(OpenPbr, OfWhiteReflectsAllLight) {
  for (const char* material : {"metalness=0", "metalness=1", "metalness=0.5", "metalness=0 diffuseRough=1",
                               "metalness=0 filmWeight=1 filmIor=2", "ior=2.5 diffuseRough=0.5"}) {
    for (const char* roughness : {"0.3", "0.5", "0.8", "1"}) {
      for (const double degrees : {0.0, 40.0, 70.0, 85.0}) {
        const std::string text = std::string("baseColor=1 roughness=") + roughness + " " + material;
        const bool is_film = text.find("film") != std::string::npos;
        EXPECT_NEAR(albedo_of_openpbr(text, degrees), 1, is_film ? 0.035 : 0.022)
            << text << " at " << degrees;
      }
    }
  }
}

// What is below a coat or fibres loses what these do not let through twice.
TEST(OpenPbr, OfWhiteUnderLayersReflectsNearlyAllLight) {
  for (const char* layers : {"coatWeight=1 coatRoughness=0.3", "coatWeight=0.5 coatRoughness=0.6 metalness=1",
                             "fuzzWeight=0.5", "coatWeight=0.5 coatRoughness=0.6 fuzzWeight=0.3"}) {
    for (const double degrees : {0.0, 40.0, 70.0, 85.0}) {
      const double albedo = albedo_of_openpbr(std::string("baseColor=1 roughness=0.5 ") + layers, degrees);
      EXPECT_GT(albedo, 0.93) << layers << " at " << degrees;
      EXPECT_LT(albedo, 1.02) << layers << " at " << degrees;
    }
  }
}

/// The mean of u.h over what facets reflect, by the midpoint rule over normals that are seen.
double mean_cosine(double c, double alpha) {
  const auto hidden = [alpha](double cosine) {
    return (std::sqrt(1 + alpha * alpha * (1 - cosine * cosine) / (cosine * cosine)) - 1) / 2;
  };
  const double sine = std::sqrt(1 - c * c);
  double total = 0;
  double sum = 0;
  constexpr int Count = 300;
  // Over slopes of normals, weighted by their distribution and by u.h.
  for (int i = 0; i < Count; ++i) {
    const double part = (i + 0.5) / Count;
    const double slope = alpha * std::sqrt(part / (1 - part));
    for (int k = 0; k < Count; ++k) {
      const double azimuth = 2 * M_PI * (k + 0.5) / Count;
      const double z = 1 / std::sqrt(1 + slope * slope);
      const double half = slope * z * std::cos(azimuth) * sine + z * c;
      const double v = 2 * half * z - c;
      if (!(half > 0 && v > 1e-9)) continue;
      const double weight = half / z / (1 + hidden(c) + hidden(v));
      total += weight;
      sum += weight * half;
    }
  }
  return sum / total;
}

TEST(OpenPbr, KnowsTheMeanCosineOfFacets) {
  for (const double alpha : {0.01, 0.04, 0.16, 0.36, 0.64, 1.0}) {
    for (const double c : {0.05, 0.15, 0.35, 0.55, 0.75, 0.98}) {
      EXPECT_NEAR(OpenPbrInDouble().ggx_mean_cosine(c, alpha), mean_cosine(c, alpha), 0.016)
          << alpha << ' ' << c;
    }
  }
}

}  // namespace
