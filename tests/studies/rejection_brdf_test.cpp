#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/plot/fit_file.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/rejection/disc.h"
#include "tests/studies/rejection_study.h"

namespace rejection_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(RejectionBrdf, AcceptsAllOfADiffuseOneOnTheDisc) {
  const studies::Study disc = study_of("brdf theta=30");
  EXPECT_EQ(counts_of(disc).samples, 2000);
  EXPECT_EQ(counts_of(disc).tries, 2000);
  const studies::Study square = study_of("brdf theta=30", "region=square samples=20000");
  expect_acceptance(counts_of(square), Pi / 4, "square");
  EXPECT_THAT(square.summary, HasSubstr(expected_text(Pi / 4)));
}

// At normal incidence the Phong lobe ks cos^n over kd / pi has the albedo kd + 2 pi ks / (n + 2).
TEST(RejectionBrdf, AcceptsTheAlbedoOverTheBound) {
  const double albedo = 0.1 + 2 * Pi / 52;
  const double acceptance = albedo / ((0.1 / Pi + 1) * Pi);
  const studies::Study study = study_of("brdf theta=0", "samples=20000", "phong n=50 ks=1 kd=0.1");
  EXPECT_THAT(study.summary, HasSubstr(expected_text(acceptance)));
  expect_acceptance(counts_of(study), acceptance, "phong");
}

/// A function on the disc of a BRDF's text.
struct DiscOf {
  reflectance::Reflector reflector;
  studies::DiscFunction function;

  explicit DiscOf(const std::string& instance, double theta = 45, double phi = 0)
      : reflector(read(instance)),
        function(reflector.brdf(), {theta * studies::Degree, phi * studies::Degree}) {}

  static reflectance::Reflector read(const std::string& instance) {
    grf::Diagnostics diagnostics;
    return reflectance::read_instance(instance, diagnostics).value();
  }
};

TEST(RejectionBrdf, FindsThePeak) {
  const DiscOf phong("phong n=5000 ks=0.7 kd=0.3", 50);
  const std::vector<studies::Peak> peaks = find_peaks(phong.function);
  EXPECT_NEAR(peaks.front().value, 0.7 + 0.3 / Pi, 1e-5) << "in the mirror direction";
  EXPECT_NEAR(peaks.front().at.x, -std::sin(50 * studies::Degree), 1e-3);
  for (const char* instance : {"ward sx=0.1 sy=0.4", "ashikhmin ex=1000 ey=20", "schlick Sr=0.05", "strauss",
                               "oren s=0.5", "minnaert", "he", "torrance", "lafortune", "hanrahan"}) {
    for (const double theta : {0.0, 40.0, 75.0}) {
      const DiscOf of(instance, theta, 25);
      const double peak = find_peaks(of.function).front().value;
      double largest = 0;
      for (int i = 0; i < 200000; ++i) {  // a low-discrepancy sequence (Roberts 2018)
        const double radius = std::sin(studies::LimitDegrees * studies::Degree) *
                              std::sqrt(std::fmod(0.5 + i * 0.7548776662466927, 1));
        const double angle = 2 * Pi * std::fmod(0.5 + i * 0.5698402909980532, 1);
        largest = std::max(largest, of.function(radius * std::cos(angle), radius * std::sin(angle)));
      }
      EXPECT_GE(peak, largest * (1 - 1e-5)) << instance << ", theta " << theta;
    }
  }
}

// f of this model grows as 1 / cos towards the horizon.
TEST(RejectionBrdf, IsCutAtTheHorizon) {
  const studies::Study study = study_of("brdf theta=80", "samples=2000", "schlick SC=0.7 Sr=0.31");
  EXPECT_GT(counts_of(study).tries, 5e5);
  EXPECT_THAT(study.summary, Not(HasSubstr("too low")));
  EXPECT_THAT(test::words_of(study),
              Contains("The maximum is at the horizon: directions beyond 89.9\u00B0 are left out."));
}

TEST(RejectionBrdf, HasTheAlbedoAsIntegral) {
  for (const char* instance : {"diffuse kd=0.4", "phong n=2000 ks=1 kd=0.1", "ward sx=0.05 sy=0.3",
                               "ashikhmin ex=1000 ey=20", "oren s=0.5", "minnaert k=0.8"}) {
    for (const double theta : {5.0, 60.0}) {
      const DiscOf of(instance, theta, 25);
      const auto cells =
          integrate([&](double x, double y) { return of.function(x, y); }, find_peaks(of.function));
      const double albedo = reflectance::mean(reflectance::albedo(of.reflector, of.function.u()));
      EXPECT_NEAR(cells.total, albedo, 0.002 * albedo) << instance << ", theta " << theta;
    }
  }
}

TEST(RejectionBrdf, HasTheRightDensityWithTheExactBound) {
  for (const char* brdf : {"ward sx=0.1 sy=0.3", "phong n=30 ks=1 kd=0.2", "oren s=0.5"}) {
    for (const char* region : {"disc", "square"}) {
      int below_half = 0;
      for (int seed = 0; seed < 10; ++seed) {
        const studies::Study study =
            study_of("brdf theta=50 phi=20", fmt::format("seed={} region={}", seed, region), brdf);
        const double p = p_value_of(study);
        EXPECT_GT(p, 1e-4) << brdf << ", seed " << seed;
        EXPECT_GT(p_value_of_tree(study), 1e-4) << brdf << ", seed " << seed;
        below_half += p < 0.5 ? 1 : 0;
      }
      EXPECT_GE(below_half, 1) << brdf;
      EXPECT_LE(below_half, 9) << brdf;
    }
  }
}

TEST(RejectionBrdf, GivesDirectionsOfTheBrdf) {
  const studies::Study study = study_of("brdf theta=40 phi=30", "samples=300", "ward sx=0.2 sy=0.1");
  grf::Diagnostics diagnostics;
  const auto fit = plot::read_fit(study.fit, "a.fit", diagnostics);
  ASSERT_TRUE(fit) << diagnostics.to_text();
  EXPECT_EQ(fit->points.size(), 300U);
  EXPECT_NEAR(fit->theta, 40 * Pi / 180, 1e-6);
  EXPECT_NEAR(fit->phi, 30 * Pi / 180, 1e-6);
  const DiscOf of("ward sx=0.2 sy=0.1", 40, 30);
  for (const plot::FitPoint& point : fit->points) {
    EXPECT_NEAR(point.direction.length(), 1, 1e-5);
    EXPECT_FLOAT_EQ(point.value, reflectance::mean(of.reflector.evaluate(of.function.u(), point.direction)));
  }
  std::istringstream csv(study.csv);
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "x,y,z,f");
  std::getline(csv, line);
  float x = 0;
  float y = 0;
  float z = 0;
  float f = 0;
  ASSERT_EQ(std::sscanf(line.c_str(), "%f,%f,%f,%f", &x, &y, &z, &f), 4);
  EXPECT_FLOAT_EQ(f, fit->points.front().value);
  EXPECT_FLOAT_EQ(x, fit->points.front().direction.x);
  EXPECT_TRUE(study_of("normal").fit.empty()) << "a number is no direction";
}

TEST(RejectionTree, AcceptsAtLeastHalf) {
  for (const char* instance : {"ward sx=0.2 sy=0.2", "phong n=500 ks=1 kd=0.1", "ashikhmin ex=200 ey=20"}) {
    const DiscOf of(instance);
    const studies::DiscTree tree(of.function, 100, 2);
    EXPECT_GE(tree.acceptance(), 0.5) << instance;
    EXPECT_LE(tree.grid_maximum(), find_peaks(of.function).front().value) << instance;
    const auto run = tree.sample({20000, {}}, 1);
    EXPECT_EQ(run.accepted.size(), 20000U);
    EXPECT_NEAR(run.acceptance() / tree.acceptance(), 1, 0.03) << instance;
    double area = 0;
    tree.visit_leaves([&](const reflectance::Box& box) { area += box.area(); });
    EXPECT_NEAR(area, 4, 1e-9) << "the leaves fill the square";
    EXPECT_NEAR(tree.bound_at(find_peaks(of.function).front().at) / tree.grid_maximum(), 1, 1e-3);
  }
  const DiscOf of("phong n=500 ks=1 kd=0.1");
  EXPECT_GT(studies::DiscTree(of.function, 100, 1.2).leaves(),
            studies::DiscTree(of.function, 100, 4).leaves());
  EXPECT_EQ(studies::DiscTree(DiscOf("diffuse").function, 100, 2).leaves(), 1U) << "pi / 4 is enough";
}

TEST(RejectionBrdf, MayBeASum) {
  const std::string tool = "tool rejection\ndistribution brdf theta=30\n";
  const studies::Study sum =
      test::study_of_text(tool + "def paint = brdf diffuse kd=0.4\nbrdf combine 0.5 paint 0.5 paint\n");
  EXPECT_EQ(sum.csv.substr(0, 8), "x,y,z,f\n");
  EXPECT_EQ(sum.csv, test::study_of_text(tool + "brdf diffuse kd=0.4\n").csv);
  EXPECT_EQ(sum.fit, "") << "which has no definitions";
}

}  // namespace
}  // namespace rejection_test
