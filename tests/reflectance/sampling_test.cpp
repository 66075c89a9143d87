// Every sampling scheme on every BRDF: samples follow the pdf, weights are f cos / pdf, and the Monte Carlo
// albedo agrees with quadrature.
#include <cctype>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "renderer/reflectance/reflector.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/disc_chi_square.h"
#include "tests/support/thoroughness.h"

namespace {

using reflectance::Brdf;
using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Scheme;
using reflectance::Uniforms;
using reflectance::Vec3f;

const std::vector<double> Angles = {0, 30, 60, 85, 89.9};

/// Returns one of the angles per case, alternating between instances, or all in a long run.
std::vector<double> angles_for(std::size_t instance, const std::vector<double>& angles) {
  if (test::tries_all()) return angles;
  return {angles[instance % angles.size()]};
}

struct Case {
  std::string brdf;
  std::string scheme;
  int depth = 0;                    ///< minimal depth of quadratures
  int resolution = 0;               ///< of the disc grid in whose cells the pdf is constant; 0: none
  std::vector<double> angles = {};  ///< of the view, in degrees from the normal
};

struct SchemeCase {
  std::string text;
  int depth = 0;
  int resolution = 0;
};

/// Returns both kinds of the table schemes in turn. Their cells are few, since quadratures take time at each
/// edge.
std::vector<SchemeCase> schemes_for(std::size_t brdf) {
  const bool is_even = brdf % 2 == 0;
  return {
      {"own"},
      {"diffuse"},
      {"hemisphere"},
      {"sphere"},
      {"anisotropic"},
      {"adaptive", 2},
      {"adaptive mode=reject nQT=20 res=100", 0, 100},
      {"reject nQT=20 res=100", 0, 100},
      {is_even ? "factored uTh=8 uPh=8 pTh=8 pPh=8" : "factored uPh=8 pTh=12 pPh=8 K=2 half=true", 2},
      {is_even ? "cascadeCDF nTh=24 nPh=8 compress=true" : "cascadeCDF nTh=16 nPh=8", 2},
  };
}

struct BrdfCase {
  std::string text;
  int depth = 0;
  std::size_t index = 0;
};

std::vector<BrdfCase> brdf_cases() {
  std::vector<BrdfCase> list;
  for (const std::string& text : test::plain_cases()) list.push_back({text, 0, list.size()});
  for (const std::string& text : test::stepped_cases()) list.push_back({text, 4, list.size()});
  return list;
}

/// Returns every BRDF by its own scheme and a third of the others, or all in a long run.
std::vector<Case> cases() {
  std::vector<Case> list;
  for (const auto& [brdf, depth, index] : brdf_cases()) {
    const std::vector<SchemeCase> schemes = schemes_for(index);
    for (std::size_t i = 0; i < schemes.size(); ++i) {
      if (i > 0 && (i + index) % 3 != 0 && !test::tries_all()) continue;
      list.push_back({brdf, schemes[i].text, std::max(depth, schemes[i].depth), schemes[i].resolution,
                      angles_for(index + list.size(), Angles)});
    }
  }
  return list;
}

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint32_t seed) : random_(seed) {}
  Uniforms next() { return {{uniform(), uniform()}, uniform()}; }

 private:
  float uniform() { return static_cast<float>(random_() >> 8U) * 0x1p-24F; }
  std::mt19937 random_;
};

/// Returns nothing for a delta direction, which has no pdf.
std::optional<Vec3f> direction_of(const Reflector& reflector, const Vec3f& u, const Uniforms& xi) {
  const auto sample = reflector.sample(u, xi);
  if (!sample || sample->is_specular) return std::nullopt;
  return sample->direction;
}

class Sampling : public testing::TestWithParam<Case> {
 protected:
  Reflector reflector() const {
    return Reflector(test::brdf_of(GetParam().brdf), test::scheme_of(GetParam().scheme));
  }
};

void expect_to_follow(const auto& test, const Reflector& subject, double angle) {
  RandomNumbers random(7);
  const Vec3f u = test::direction(angle, 25);
  const double p = test.p_value([&] { return direction_of(subject, u, random.next()); }, 100000);
  EXPECT_GT(p, statistics::significance(static_cast<int>(cases().size() * Angles.size()))) << angle;
  EXPECT_LT(test.mass(), 1.001) << angle;
}

TEST_P(Sampling, FollowsItsDensity) {
  const Reflector subject = reflector();
  for (const double angle : GetParam().angles) {
    const Vec3f u = test::direction(angle, 25);
    const auto pdf = [&](const Vec3f& v) { return static_cast<double>(subject.pdf(u, v)); };
    if (GetParam().resolution > 0) {
      expect_to_follow(statistics::DiscChiSquareTest(pdf, u, GetParam().resolution), subject, angle);
    } else {
      const Vec3f peak = reflectance::mirrored(u);
      expect_to_follow(statistics::ChiSquareTest(pdf, peak, GetParam().depth), subject, angle);
    }
  }
}

TEST_P(Sampling, WeightsAreValueTimesCosineOverDensity) {
  const Reflector subject = reflector();
  RandomNumbers random(8);
  for (const double angle : GetParam().angles) {
    const Vec3f u = test::direction(angle, 25);
    int over_an_edge = 0;
    for (int i = 0; i < 5000; ++i) {
      const auto sample = subject.sample(u, random.next());
      if (!sample || sample->is_specular) continue;
      const Vec3f& v = sample->direction;
      ASSERT_NEAR(v.length(), 1, 1e-5);
      ASSERT_GT(v.z, 0);
      const float pdf = subject.pdf(u, v);
      if (std::abs(sample->pdf - pdf) > (GetParam().depth > 0 ? 1e-2F : 1e-3F) * pdf) {
        // A rounded direction can be over the edge of a cell, where the pdf steps.
        ASSERT_NEAR(sample->pdf, pdf, 0.3F * pdf);
        ++over_an_edge;
        continue;
      }
      const Rgb expected = subject.evaluate(u, v) * v.z / pdf;
      for (int k = 0; k < 3; ++k)
        ASSERT_NEAR(sample->weight[k], expected[k],
                    (GetParam().depth > 0 ? 1e-2F : 2e-3F) * expected[k] + 1e-6F)
            << v;
    }
    EXPECT_LE(over_an_edge, 2) << angle;
  }
}

void expect_albedo(const Reflector& subject, const Vec3f& u, double exact, const std::string& scheme) {
  constexpr int Samples = 100000;
  RandomNumbers random(9);
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < Samples; ++i) {
    const auto sample = subject.sample(u, random.next());
    const double weight = sample ? sample->weight.x : 0;
    sum += weight;
    squares += weight * weight;
  }
  const double mean = sum / Samples;
  const double deviation = std::sqrt(std::max(0.0, squares / Samples - mean * mean) / Samples);
  EXPECT_NEAR(mean, exact, 4.5 * deviation + 2e-4 * exact) << scheme << u;
}

/// Returns every third BRDF, or all in a long run.
std::vector<BrdfCase> albedo_cases() {
  std::vector<BrdfCase> list = brdf_cases();
  if (!test::tries_all()) std::erase_if(list, [](const BrdfCase& brdf) { return brdf.index % 3 != 0; });
  return list;
}

// Tests all schemes at once: the quadrature takes longest.
class Albedo : public testing::TestWithParam<BrdfCase> {};

TEST_P(Albedo, IsThatOfQuadratureByAnyScheme) {
  const Brdf brdf = test::brdf_of(GetParam().text);
  std::vector<Reflector> subjects;
  const std::vector<SchemeCase> schemes = schemes_for(GetParam().index);
  for (const SchemeCase& scheme : schemes) subjects.emplace_back(brdf, test::scheme_of(scheme.text));
  for (const double angle : angles_for(GetParam().index, {0, 30, 60, 85})) {
    const Vec3f u = test::direction(angle, 25);
    const statistics::Quadrature quadrature(
        [&](const Vec3f& v) { return evaluate(brdf, u, v).x * double(v.z); }, reflectance::mirrored(u), 1e-6,
        GetParam().depth);
    const double exact = quadrature.over_hemisphere() + reflectance::specular_weight(brdf, u).x;
    for (std::size_t i = 0; i < schemes.size(); ++i) expect_albedo(subjects[i], u, exact, schemes[i].text);
  }
}

/// Returns the first word, which names the model, without characters that test names forbid.
std::string first_word(const std::string& text) {
  std::string word;
  for (const char c : text) {
    if (c == ' ' && !word.empty()) break;
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) word += c;
  }
  return word;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return first_word(info.param.scheme) + "_" + first_word(info.param.brdf) + "_" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(Cases, Sampling, testing::ValuesIn(cases()), name_of);
INSTANTIATE_TEST_SUITE_P(Cases, Albedo, testing::ValuesIn(albedo_cases()),
                         [](const testing::TestParamInfo<BrdfCase>& brdf) {
                           return first_word(brdf.param.text) + "_" + std::to_string(brdf.param.index);
                         });

// Tests the test: a slightly wrong sampler must not pass.
TEST(ChiSquareTest, RejectsAWrongSampler) {
  const Vec3f u = test::direction(30, 25);
  const Reflector right(test::brdf_of("lewis n=20 ks=0.5 kd=0.5"), reflectance::OwnScheme());
  const Reflector wrong(test::brdf_of("lewis n=22 ks=0.5 kd=0.5"), reflectance::OwnScheme());
  const auto pdf = [&](const Vec3f& v) { return static_cast<double>(right.pdf(u, v)); };
  RandomNumbers random(10);
  const statistics::ChiSquareTest test(pdf, reflectance::mirrored(u));
  EXPECT_LT(test.p_value([&] { return direction_of(wrong, u, random.next()); }, 100000), 1e-6);
}

TEST(Extremes, WeightsStayFinite) {
  RandomNumbers random(11);
  std::vector<std::string> texts = test::extreme_cases();
  texts.insert(texts.end(), test::hard_cases().begin(), test::hard_cases().end());
  for (const std::string& text : texts) {
    const Reflector subject(test::brdf_of(text), reflectance::OwnScheme());
    for (const test::Pair& pair : test::direction_pairs(2000, 12)) {
      const auto sample = subject.sample(pair.u, random.next());
      if (!sample) continue;
      for (int k = 0; k < 3; ++k) {
        ASSERT_TRUE(std::isfinite(sample->weight[k]) && sample->weight[k] >= 0) << text << pair.u;
      }
    }
  }
}

TEST(Mirror, IsDrawnAlwaysByWhateverScheme) {
  const Vec3f u = test::direction(50, 10);
  for (const Scheme& scheme : {Scheme(reflectance::OwnScheme()), Scheme(reflectance::DiffuseScheme()),
                               Scheme(reflectance::SpecularScheme())}) {
    const Reflector mirror(test::brdf_of("specular ks=(0.9, 0.8, 0.7)"), scheme);
    RandomNumbers random(13);
    for (int i = 0; i < 100; ++i) {
      const auto sample = mirror.sample(u, random.next());
      ASSERT_TRUE(sample && sample->is_specular);
      EXPECT_EQ(sample->direction, reflectance::mirrored(u));
      EXPECT_EQ(sample->weight, Rgb(0.9F, 0.8F, 0.7F));
    }
    EXPECT_FALSE(mirror.has_nonspecular_part());
  }
}

TEST(SpecularScheme, RefusesABrdfWithoutAMirrorPart) {
  EXPECT_NE(unsupported_reason(reflectance::SpecularScheme(), test::brdf_of("ward")), "");
  EXPECT_EQ(unsupported_reason(reflectance::SpecularScheme(), test::brdf_of("specular")), "");
}

}  // namespace
