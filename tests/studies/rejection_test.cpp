#include <cmath>
#include <numbers>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "renderer/studies/goodness_of_fit.h"
#include "renderer/studies/rejection/interval.h"
#include "tests/studies/rejection_study.h"
#include "tests/support/temporary_folder.h"

namespace rejection_test {
namespace {

using studies::Density;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Density density_of(const std::string& instance, double tail = 1e-3) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_pdf(instance, "test", diagnostics);
  return studies::make_density(model.value(), tail).value();
}

TEST(RejectionDensity, HasTheMaximumOfItsClosedForm) {
  const double e = std::numbers::e;
  EXPECT_NEAR(density_of("beta alpha=2 beta=5").maximum(), 30 * 0.2 * std::pow(0.8, 4), 1e-12) << "2.4576";
  EXPECT_NEAR(density_of("beta alpha=1 beta=1").maximum(), 1, 1e-12);
  EXPECT_NEAR(density_of("beta alpha=1 beta=5").maximum(), 5, 1e-12) << "at 0";
  EXPECT_NEAR(density_of("beta alpha=3 beta=1").maximum(), 3, 1e-12) << "at 1";
  EXPECT_NEAR(density_of("normal mean=3 deviation=2").maximum(), 1 / (2 * std::sqrt(2 * Pi)), 1e-7);
  EXPECT_NEAR(density_of("gamma shape=2 scale=3").maximum(), 1 / (3 * e), 1e-12);
  EXPECT_NEAR(density_of("gamma shape=1 scale=2").maximum(), 0.5, 1e-12) << "exponential, at 0";
  EXPECT_NEAR(density_of("chisquared freedom=4").maximum(), 1 / (2 * e), 1e-12);
  EXPECT_NEAR(density_of("chisquared freedom=2").maximum(), 0.5, 1e-12);
  EXPECT_NEAR(density_of("student freedom=2").maximum(), 1 / (2 * std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(density_of("lognormal location=1 scale=0.5").maximum(),
              std::exp(-1 + 0.125) / (0.5 * std::sqrt(2 * Pi)), 1e-12);
  EXPECT_NEAR(density_of("beta alpha=2 beta=5").maximum(0.5, 1), 30 * 0.5 * std::pow(0.5, 4), 1e-12)
      << "of a part beside the mode";
}

TEST(RejectionDensity, IsCutWhereItsSupportIsUnbounded) {
  const Density normal = density_of("normal", 1e-3);
  EXPECT_NEAR(normal.low, -3.090232306, 1e-6);
  EXPECT_NEAR(normal.high, 3.090232306, 1e-6);
  const Density exponential = density_of("gamma shape=1", 1e-3);
  EXPECT_EQ(exponential.low, 0);
  EXPECT_NEAR(exponential.high, std::log(1000.0), 1e-9);
  const Density cauchy = density_of("student freedom=1", 0.01);
  EXPECT_NEAR(cauchy.high, std::tan(Pi * 0.49), 1e-6);
  EXPECT_EQ(density_of("beta", 0.01).high, 1);
  EXPECT_NEAR(normal.mass(), 0.998, 1e-9);
}

TEST(Rejection, AcceptsTheIntegralOverTheBound) {
  const double normal = 0.998 * std::sqrt(2 * Pi) / (2 * 3.090232306);
  const double exponential = 0.999 / std::log(1000.0);
  const std::vector<std::pair<std::string, double>> cases = {{"beta alpha=2 beta=5", 1 / 2.4576},
                                                             {"beta alpha=1 beta=3", 1.0 / 3},
                                                             {"normal mean=5 deviation=0.1", normal},
                                                             {"gamma shape=1 scale=7", exponential},
                                                             {"chisquared freedom=2", exponential}};
  for (const auto& [distribution, acceptance] : cases) {
    const studies::Study study = study_of(distribution, "samples=20000");
    expect_acceptance(counts_of(study), acceptance, distribution);
    EXPECT_THAT(study.summary, HasSubstr(expected_text(acceptance)));
    EXPECT_EQ(column(study.csv).size(), 20000U);
  }
  const Counts uniform = counts_of(study_of("beta alpha=1 beta=1"));
  EXPECT_EQ(uniform.samples, 2000);
  EXPECT_EQ(uniform.tries, 2000) << "a constant density accepts all";
}

TEST(Rejection, AcceptsLessUnderAHigherBound) {
  const studies::Study study = study_of("beta alpha=2 beta=5", "samples=20000 bound=hand factor=2");
  expect_acceptance(counts_of(study), 1 / (2 * 2.4576), "twice the maximum");
  EXPECT_GT(p_value_of(study), 1e-4) << "and is right";
}

// With shape 1, the density e^-x is above a bound M for x < -ln M: the integral below is M (1 - ln M).
TEST(Rejection, SamplesTheDensityUpToABoundThatIsTooLow) {
  const studies::Study study = study_of("gamma shape=1", "samples=20000 bound=hand factor=0.4");
  const double below = 0.4 * (1 - std::log(0.4)) - 0.001;
  const double acceptance = below / (0.4 * std::log(1000.0));
  EXPECT_THAT(study.summary, HasSubstr(expected_text(acceptance)));
  expect_acceptance(counts_of(study), acceptance, "e^-x up to 0.4");
  const double uniform_end = -std::log(0.4);
  double in_plateau = 0;
  for (const double x : column(study.csv)) in_plateau += x < uniform_end / 2 ? 1 : 0;
  const double share = 0.4 * uniform_end / 2 / below;
  EXPECT_NEAR(in_plateau / 20000, share, 4 * std::sqrt(share / 20000));
}

TEST(Rejection, HasTheRightDensityWithTheExactBound) {
  for (const char* distribution :
       {"normal", "gamma shape=2", "chisquared freedom=5", "student freedom=3", "beta", "lognormal"}) {
    int below_half = 0;
    for (int seed = 0; seed < 20; ++seed) {
      const studies::Study study = study_of(distribution, fmt::format("seed={}", seed));
      const double p = p_value_of(study);
      EXPECT_GT(p, 1e-4) << distribution << ", seed " << seed;
      EXPECT_GT(p_value_of_tree(study), 1e-4) << distribution << ", seed " << seed;
      below_half += p < 0.5 ? 1 : 0;
    }
    EXPECT_GE(below_half, 2) << distribution;
    EXPECT_LE(below_half, 18) << distribution;
  }
}

TEST(Rejection, HasSamplesThatAnotherTestFindsRight) {
  // Kolmogorov and Smirnov's distance to 1 - e^-x, cut at 0.999.
  std::vector<double> values = column(study_of("gamma shape=1 scale=2", "samples=10000").csv);
  std::ranges::sort(values);
  double distance = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double cdf = (1 - std::exp(-values[i] / 2)) / 0.999;
    distance = std::max(distance, std::abs(cdf - (static_cast<double>(i) + 0.5) / 10000));
  }
  EXPECT_LT(distance, 2.23 / 100) << "p = 1e-4";
  EXPECT_GT(distance, 0.2 / 100);
}

TEST(Rejection, ShowsThatALowBoundIsWrong) {
  for (const char* distribution : {"normal", "beta alpha=2 beta=5", "brdf theta=30"}) {
    const studies::Study study = study_of(distribution, "bound=hand factor=0.4", "ward sx=0.2 sy=0.2");
    EXPECT_LT(p_value_of(study), 0.01) << distribution;
    EXPECT_THAT(study.summary, HasSubstr("The bound is too low at"));
    EXPECT_THAT(study.figure.str(), HasSubstr("#cc0000")) << "in red";
    EXPECT_THAT(test::words_of(study), Contains("what this bound samples"));
  }
  const studies::Study right = study_of("normal");
  EXPECT_THAT(right.summary, Not(HasSubstr("too low")));
  EXPECT_THAT(right.figure.str(), Not(HasSubstr("#cc0000")));
}

TEST(RejectionGrid, IsAtMostTheMaximum) {
  const Density beta = density_of("beta alpha=2 beta=5");
  EXPECT_NEAR(studies::grid_maximum(beta, 1), 30 * std::pow(0.5, 5), 1e-12) << "at the centre";
  EXPECT_NEAR(studies::grid_maximum(beta, 3), 30.0 / 6 * std::pow(5.0 / 6, 4), 1e-12);
  for (int cells = 1; cells < 60; ++cells) EXPECT_LE(studies::grid_maximum(beta, cells), 2.4576 + 1e-12);
  EXPECT_NEAR(studies::grid_maximum(beta, 400), 2.4576, 1e-3);
  EXPECT_LT(p_value_of(study_of("beta alpha=2 beta=5", "bound=grid cells=1")), 0.01);
  EXPECT_THAT(test::words_of(study_of("beta alpha=2 beta=5", "cells=3")),
              Contains("Maximum: 2.4576; over 3 cells: 2.4113, 1.89 % lower."));
}

TEST(RejectionSubdivision, NeedsAtMostSoManyTries) {
  for (const char* distribution : {"normal", "student freedom=1", "lognormal scale=2", "gamma shape=30"}) {
    for (const double most_tries : {1.1, 2.0, 4.0}) {
      const Density density = density_of(distribution);
      const studies::IntervalTree tree(density, most_tries);
      EXPECT_GE(tree.acceptance(), 1 / most_tries) << distribution;
      double mass = 0;
      double end = density.low;
      for (const studies::IntervalTree::Leaf& leaf : tree.leaves()) {
        EXPECT_EQ(leaf.low, end) << "without gaps";
        for (int i = 0; i <= 16; ++i)
          EXPECT_LE(density.pdf(leaf.low + (leaf.high - leaf.low) * i / 16), leaf.bound * (1 + 1e-12));
        mass += leaf.mass;
        end = leaf.high;
      }
      EXPECT_EQ(end, density.high);
      EXPECT_NEAR(mass, density.mass(), 1e-9);
      const auto run = sample_interval(density, tree, {20000, {}}, 3);
      EXPECT_NEAR(run.acceptance() / tree.acceptance(), 1, 0.03) << distribution;
      EXPECT_EQ(run.above, 0U);
    }
  }
}

TEST(RejectionMessages, SayThatAPoleHasNoBound) {
  EXPECT_THAT(messages_of("beta beta=2 alpha=0.5"),
              HasSubstr("a.study:2:26: error: the density of 'beta' is infinite at x = 0 as 'alpha' is below "
                        "1, so that no bound is above it: use at least 1, or bound=grid"));
  EXPECT_THAT(messages_of("beta beta=0.5"), HasSubstr("infinite at x = 1 as 'beta' is below 1"));
  EXPECT_THAT(messages_of("gamma shape=0.9", "bound=hand"), HasSubstr("'shape' is below 1"));
  EXPECT_THAT(messages_of("chisquared freedom=1"), HasSubstr("'freedom' is below 2, so"));
  const studies::Study grid = study_of("chisquared freedom=1", "bound=grid cells=20");
  EXPECT_LT(p_value_of(grid), 0.01) << "the peak is cut off";
  EXPECT_THAT(test::words_of(grid), Contains("No subdivision: the density is infinite at x = 0."));
}

TEST(RejectionMessages, NameWhatIsWrong) {
  EXPECT_THAT(messages_of("brdf", {}, "specular"), HasSubstr("only a mirror (delta part)"));
  EXPECT_THAT(messages_of("brdf", {}, "diffuse kd=0"), HasSubstr("f of 'diffuse' is 0 in all directions"));
  EXPECT_THAT(messages_of("cauchy"), HasSubstr("cauchy"));
  EXPECT_THAT(messages_of("normal deviation=0"), HasSubstr("deviation"));
  EXPECT_THAT(messages_of("normal", "factor=9"), HasSubstr("factor"));
  EXPECT_THAT(messages_of("normal", "bound=none"), HasSubstr("bound"));
  EXPECT_THAT(messages_of("brdf theta=95"), HasSubstr("theta"));
  EXPECT_THAT(test::outcome_of("tool rejection\ndistribution normal\n").messages,
              HasSubstr("'rejection' takes 1 BRDF, and the state has 0"));
  EXPECT_THAT(test::outcome_of("tool rejection\nbrdf diffuse\n").messages, HasSubstr("distribution"));
}

TEST(Rejection, StopsWhereNextToNothingIsAccepted) {
  const studies::Study study = study_of("student freedom=0.5", "tail=0.0001 cells=1");
  EXPECT_EQ(counts_of(study).tries, 1e6);
  EXPECT_THAT(study.summary, HasSubstr("Stopped after 1000000 tries"));
  EXPECT_THAT(test::words_of(study), Contains("too few samples to test"));
}

TEST(Rejection, StopsWhenItIsTold) {
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(state_of("brdf"), "a.study", diagnostics);
  studies::StudyContext context;
  context.is_stopped = [] { return true; };
  const auto study = studies::study_of(state.value(), context, diagnostics);
  ASSERT_TRUE(study);
  EXPECT_EQ(counts_of(*study).tries, 0);
}

TEST(Rejection, IsTheSameFromTheSameState) {
  for (const char* distribution : {"beta alpha=2.5 beta=3", "brdf theta=33 phi=-20"}) {
    const std::string text =
        state_of(distribution, "samples=500 bound=hand factor=0.8 seed=7", "ward sx=0.1 sy=0.2");
    grf::Diagnostics diagnostics;
    const auto state = studies::read_state(text, "a.study", diagnostics);
    EXPECT_EQ(test::study_of_text(text).csv, test::study_of_text(to_text(state.value())).csv);
  }
}

/// Returns the figure without the times, which always differ.
std::string without_times(const studies::Study& study) {
  return std::regex_replace(study.figure.str(), std::regex(">[0-9.e+]+ (ns|\u00B5s)<"), "><");
}

TEST(Rejection, FollowsEachSetting) {
  std::set<std::string> figures;
  std::size_t count = 0;
  const auto add = [&](const std::string& distribution, const std::string& settings) {
    figures.insert(without_times(study_of(distribution, settings, "ward sx=0.2 sy=0.3")));
    EXPECT_EQ(figures.size(), ++count) << distribution << ' ' << settings;
  };
  for (const char* settings : {"", "samples=500", "bound=grid", "bound=hand factor=0.5",
                               "bound=hand factor=2", "cells=30", "tail=1", "nmax=1.2", "seed=5"})
    add("normal", settings);
  for (const char* settings : {"", "samples=500", "bound=grid", "bound=hand factor=0.5", "cells=30",
                               "region=square", "nmax=1.2", "seed=5"})
    add("brdf", settings);
  for (const char* distribution :
       {"brdf theta=20", "brdf phi=90", "normal mean=1", "normal deviation=2", "gamma", "gamma shape=3",
        "gamma scale=2", "chisquared", "chisquared freedom=9", "student", "student freedom=9", "beta",
        "beta alpha=4", "beta beta=2", "lognormal", "lognormal location=1", "lognormal scale=1"})
    add(distribution, "");
  EXPECT_EQ(without_times(study_of("normal")), without_times(study_of("normal"))) << "and nothing else";
}

TEST(Rejection, DescribesWhatIsPointedAt) {
  const studies::Study uniform = study_of("beta alpha=1 beta=1", "bound=hand factor=2");
  EXPECT_THAT(uniform.describe({300, 300}), HasSubstr("density 1, accepted 50 % under the bound 2"));
  EXPECT_EQ(uniform.describe({5, 5}), "");
  const studies::Study diffuse = study_of("brdf");
  EXPECT_THAT(diffuse.describe({157, 235}), HasSubstr("\u03B8 = 0\u00B0"));
  EXPECT_THAT(diffuse.describe({157, 235}), HasSubstr("f = 0.1592 1/sr, accepted 100 %"));
  EXPECT_THAT(diffuse.describe({437, 235}), HasSubstr("f = 0.1592 1/sr")) << "the other disc";
  EXPECT_THAT(diffuse.describe({326, 480}), HasSubstr("f = 0.1592 1/sr")) << "the slice";
  EXPECT_EQ(diffuse.describe({900, 480}), "");
}

TEST(Rejection, TurnsTheViewOfABrdf) {
  grf::Diagnostics diagnostics;
  const auto tool = studies::study_tool("rejection");
  ASSERT_TRUE(tool);
  const auto turned = [&](const std::string& distribution, double azimuth, double elevation) {
    auto state = studies::read_state(state_of(distribution), "a.study", diagnostics).value();
    tool->turn(state, azimuth, elevation);
    return to_text(state);
  };
  EXPECT_THAT(turned("brdf theta=30", -10, 20), HasSubstr("distribution brdf theta=40 phi=-20\n"));
  EXPECT_THAT(turned("brdf", 90, 0), HasSubstr("distribution brdf theta=0 phi=0\n")) << "not beyond";
  EXPECT_THAT(turned("normal mean=2", 10, 20), HasSubstr("distribution normal mean=2\n"));
}

TEST(Rejection, IsAPicture) {
  const test::TemporaryFolder folder;
  for (const char* distribution : {"brdf", "student"}) {
    grf::Diagnostics diagnostics;
    const std::string path = folder.path("figure.png");
    EXPECT_TRUE(write_picture(study_of(distribution).figure, path, diagnostics)) << diagnostics.to_text();
    EXPECT_EQ(test::bytes_of(path).substr(1, 3), "PNG");
  }
}

double p_value_of(const std::vector<double>& expected, const std::vector<double>& counted) {
  return studies::goodness_of_fit(expected, counted).p_value;
}

TEST(GoodnessOfFit, HasThePValuesOfTables) {
  EXPECT_NEAR(p_value_of({50, 50}, {44, 56}), 0.230139, 1e-6) << "1.44, 1 degree";
  // Three classes: exp(-x / 2) with 2 degrees of freedom.
  EXPECT_NEAR(p_value_of({25, 25, 50}, {30, 30, 40}), std::exp(-2.0), 1e-9);
  EXPECT_NEAR(p_value_of({25, 25, 46, 3, 1}, {30, 30, 36, 3, 1}),
              p_value_of({25, 25, 46, 4}, {30, 30, 36, 4}), 1e-9)
      << "small classes are pooled";
  EXPECT_EQ(studies::goodness_of_fit(std::vector<double>{3, 3}, std::vector<double>{3, 3}).degrees, 0)
      << "too few";
}

}  // namespace
}  // namespace rejection_test
