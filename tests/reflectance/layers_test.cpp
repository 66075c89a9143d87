// Coats and layers: closed forms, energy, reciprocity, and the scopes of their names.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "grf/check.h"
#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/scheme.h"
#include "tests/reflectance/albedo.h"
#include "tests/reflectance/brdf_cases.h"

namespace {

using reflectance::Brdf;
using reflectance::Rgb;
using reflectance::Vec3f;

/// Fresnel's equations for a dielectric seen from air, in double (Born and Wolf).
double fresnel(double cosine, double ior) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (ior * ior));
  const double parallel = (ior * cosine - inside) / (ior * cosine + inside);
  const double across = (cosine - ior * inside) / (cosine + ior * inside);
  return (parallel * parallel + across * across) / 2;
}

double mean_transmission(double ior) {
  double sum = 0;
  constexpr int Count = 100'000;
  for (int i = 0; i < Count; ++i) {
    const double c = (i + 0.5) / Count;
    sum += (1 - fresnel(c, ior)) * 2 * c / Count;
  }
  return sum;
}

// The base gets (1 - F(u)) (1 - F(v)) over the mean transmission, which is symmetric and loses nothing. The
// rows of the table cost up to 2 % at grazing.
TEST(Coat, ThatIsSmoothOverLambertHasAClosedForm) {
  for (const double ior : {1.2, 1.5, 2.0}) {
    const Brdf coat = test::brdf_of("coat alpha=0.0001 ior=" + std::to_string(ior) + " over diffuse kd=0.6");
    const double scale = 0.6 / std::numbers::pi / mean_transmission(ior);
    for (const double a : {0.0, 20.0, 50.0, 70.0, 85.0}) {
      for (const double b : {10.0, 40.0, 60.0, 80.0}) {
        const Vec3f u = test::direction(a, 0);
        const Vec3f v = test::direction(b, 130);
        const double expected = scale * (1 - fresnel(u.z, ior)) * (1 - fresnel(v.z, ior));
        ASSERT_NEAR(evaluate(coat, u, v).x, expected, 0.02 * expected) << ior << ' ' << a << ' ' << b;
      }
    }
  }
}

TEST(Coat, ThatIsSmoothOverAMirrorTransmitsOnce) {
  const Brdf coat = test::brdf_of("coat alpha=0.0001 ior=1.5 over specular ks=(0.8, 0.5, 0.1)");
  ASSERT_TRUE(has_specular_part(coat));
  for (const double angle : {0.0, 30.0, 60.0, 75.0, 85.0}) {
    const Vec3f u = test::direction(angle, 10);
    const double transmitted = 1 - fresnel(u.z, 1.5);
    const Rgb weight = specular_weight(coat, u);
    EXPECT_NEAR(weight.x, 0.8 * transmitted, 0.015 * transmitted) << angle;
    EXPECT_NEAR(weight.z, 0.1 * transmitted, 0.002 * transmitted) << angle;
  }
}

TEST(Coat, TintsByBeersLaw) {
  const Brdf clear = test::brdf_of("coat alpha=0.0001 ior=1.5 over diffuse kd=1");
  const Brdf tinted = test::brdf_of("coat alpha=0.0001 ior=1.5 tint=(0.25, 0.81, 0) over diffuse kd=1");
  const Vec3f u = test::direction(60, 0);
  const Vec3f v = test::direction(30, 90);
  const auto way = [](double degrees) {
    const double sine = std::sin(degrees * std::numbers::pi / 180) / 1.5;
    return 0.5 / std::sqrt(1 - sine * sine);
  };
  const Rgb ratio = evaluate(tinted, u, v) / evaluate(clear, u, v);
  EXPECT_NEAR(ratio.x, std::pow(0.25, way(60) + way(30)), 0.003);
  EXPECT_NEAR(ratio.y, std::pow(0.81, way(60) + way(30)), 0.003);
  EXPECT_NEAR(ratio.z, 0, 1e-6);
}

class Layered : public testing::TestWithParam<std::string> {};

/// The albedo with the delta part, in red, without that of the sampler or the tables under test.
double whole_albedo(const Brdf& brdf, const Vec3f& u) {
  return test::albedo(brdf, u, 1e-5) + static_cast<double>(specular_weight(brdf, u).x);
}

// E + (1 - E) A: what is above does not reflect is scaled by the albedo of what is below.
TEST_P(Layered, ReflectsWhatTheTopLeavesTimesTheAlbedoOfTheBase) {
  const std::string text = GetParam();
  const std::size_t over = text.find(" over ");
  const Brdf both = test::brdf_of(text);
  const Brdf top = test::brdf_of(text.substr(0, over));
  const Brdf base = test::brdf_of(text.substr(over + 6));
  for (const double angle : {0.0, 25.0, 50.0, 70.0, 84.0}) {
    const Vec3f u = test::direction(angle, 25);
    const double above = whole_albedo(top, u);
    const double expected = above + (1 - above) * whole_albedo(base, u);
    // Below an anisotropic layer all azimuths get the least of what is transmitted.
    EXPECT_NEAR(whole_albedo(both, u), expected, is_anisotropic(top) ? 0.03 : 0.012) << angle;
    EXPECT_LT(whole_albedo(both, u), 1.003) << angle;
  }
}

TEST_P(Layered, IsReciprocal) {
  const Brdf both = test::brdf_of(GetParam());
  for (const test::Pair& pair : test::easy_pairs()) {
    const Rgb there = evaluate(both, pair.u, pair.v);
    const Rgb back = evaluate(both, pair.v, pair.u);
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(there[i], back[i], 1e-4F * std::max(there[i], 1.0F));
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, Layered,
                         testing::Values("coat alpha=0.3 over diffuse kd=1",
                                         "coat alpha=0.1 ior=2 over ggx alpha=0.4 F0=1",
                                         "coat alpha=0.5 over ward sx=0.2 sy=0.4 ks=0.5 kd=0.4",
                                         "coat alpha=0.3 over specular ks=1",
                                         "diffuse kd=0.4 over lewis n=30 ks=0.9 kd=0",
                                         "coat alpha=0.4 over coat alpha=0.2 over diffuse kd=1",
                                         "ggx alpha=0.2 ay=0.5 nreal=2 over diffuse kd=0.9"));

/// Checks a scene of definitions and a mesh, and makes the mesh's BRDF.
std::optional<Brdf> brdf_in(const std::string& definitions, const std::string& attribute,
                            grf::Diagnostics& diagnostics, const std::string& last_end = "end") {
  const auto scene = test::scene_with(definitions, attribute, diagnostics, last_end);
  const bool is_right = scene && grf::check(*scene, reflectance::catalogue(), diagnostics);
  return is_right ? test::brdf_in(*scene, diagnostics) : std::nullopt;
}

std::string errors_in(const std::string& definitions, const std::string& attribute) {
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(brdf_in(definitions, attribute, diagnostics));
  return diagnostics.to_text();
}

float value_of(const Brdf& brdf) {
  return evaluate(brdf, test::direction(40, 0), test::direction(20, 100)).x;
}

TEST(Layers, FindTheirNamesWhereTheyAreDefined) {
  grf::Diagnostics diagnostics;
  const auto plain = brdf_in("def a = brdf diffuse kd=0.5", "coat base=a alpha=0.2 ior=1.4", diagnostics);
  ASSERT_TRUE(plain) << diagnostics.to_text();
  EXPECT_EQ(value_of(*plain), value_of(test::brdf_of("coat alpha=0.2 ior=1.4 over diffuse kd=0.5")));
  const auto hidden = brdf_in(
      "def a = brdf diffuse kd=0.5 c = brdf coat base=a alpha=0.2 ior=1.4 begin def a = brdf diffuse kd=0.1",
      "c", diagnostics, "end end");
  ASSERT_TRUE(hidden) << diagnostics.to_text();
  EXPECT_EQ(value_of(*hidden), value_of(*plain));
}

TEST(Layers, AreTermsOfSums) {
  grf::Diagnostics diagnostics;
  const std::string definitions =
      "def a = brdf diffuse kd=0.5 b = brdf phong n=5 s = brdf combine 0.5 a, 0.5 b "
      "c = brdf coat base=s alpha=0.3 l = brdf layer top=c base=b";
  const auto coat = brdf_in(definitions, "c", diagnostics);
  const auto layer = brdf_in(definitions, "l", diagnostics);
  const auto sum = brdf_in(definitions, "combine 0.25 c, 0.5 l, 2 a", diagnostics);
  ASSERT_TRUE(coat && layer && sum) << diagnostics.to_text();
  const float expected =
      0.25F * value_of(*coat) + 0.5F * value_of(*layer) + 2 * value_of(test::brdf_of("diffuse kd=0.5"));
  EXPECT_NEAR(value_of(*sum), expected, 1e-5F * expected);
}

TEST(Layers, LeaveTheirKeywordsToDefinitions) {
  grf::Diagnostics diagnostics;
  const auto brdf = brdf_in("def coat = brdf diffuse kd=0.3 layer = brdf phong", "coat", diagnostics);
  ASSERT_TRUE(brdf) << diagnostics.to_text();
  EXPECT_EQ(value_of(*brdf), value_of(test::brdf_of("diffuse kd=0.3")));
}

TEST(Layers, SayWhatIsWrong) {
  EXPECT_NE(errors_in("def a = brdf diffuse", "coat ior=1.5")
                .find("'coat' needs the names of defined BRDFs: base=NAME"),
            std::string::npos);
  EXPECT_NE(errors_in("def a = brdf diffuse", "layer top=a").find("base=NAME top=NAME"), std::string::npos);
  EXPECT_NE(errors_in("def clay = brdf diffuse", "coat base=clai").find("clay"), std::string::npos);
  EXPECT_NE(errors_in("def a = rgb (1, 1, 1)", "coat base=a").find("no BRDF called 'a'"), std::string::npos);
  EXPECT_NE(errors_in("def a = brdf diffuse", "coat base=a base=a").find("twice"), std::string::npos);
  EXPECT_NE(errors_in("def a = brdf diffuse", "coat base=a alpha=2").find("out of range"), std::string::npos);
  EXPECT_NE(errors_in("def a = brdf diffuse", "coat base=0.5").find("base=NAME"), std::string::npos);
}

std::string chain(int layers, const std::string& kind) {
  std::string text = "def c0 = brdf diffuse";
  for (int i = 1; i <= layers; ++i) {
    text += " c" + std::to_string(i) + " = brdf " + kind + " base=c" + std::to_string(i - 1);
    if (kind == "layer") text += " top=c" + std::to_string(i - 1);
  }
  return text;
}

TEST(Layers, AreAtMostEightAboveEachOther) {
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(brdf_in(chain(8, "coat"), "c8", diagnostics)) << diagnostics.to_text();
  EXPECT_NE(errors_in(chain(9, "coat"), "c9").find("over 8 layers above each other"), std::string::npos);
  EXPECT_NE(errors_in(chain(9, "layer"), "c9").find("over 8 layers above each other"), std::string::npos);
  EXPECT_NE(errors_in(chain(60'000, "coat"), "c60000").find("over 8 layers"), std::string::npos);
}

TEST(Layers, AreWrittenAsTheyAreRead) {
  grf::Diagnostics diagnostics;
  const std::string text =
      "def a = brdf diffuse kd=0.5 c = brdf coat base=a ior=1.4 tint=(1, 0.5, 0.25) l = brdf layer base=c "
      "top=a";
  const auto scene = grf::read_text(text + " begin end", "scene.grf", diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  const std::string written = grf::to_text(*scene);
  EXPECT_NE(written.find("coat base=a ior=1.4 tint=(1, 0.5, 0.25)"), std::string::npos) << written;
  EXPECT_NE(written.find("layer base=c top=a"), std::string::npos) << written;
  const auto again = grf::read_text(written, "scene.grf", diagnostics);
  ASSERT_TRUE(again) << diagnostics.to_text();
  EXPECT_EQ(grf::to_text(*again), written);
}

}  // namespace
