// Trees of known functions, and the test of samples in their cells.
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "grf/read.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/drawn_samples.h"
#include "renderer/studies/subdivision/subject.h"
#include "tests/statistics/chi_square.h"

namespace subdivision_test {
namespace {

using reflectance::Box;
using reflectance::DiscGrid;
using reflectance::Vec3f;
using studies::Angles;
using studies::Degree;
using studies::Subdivision;
using Cell = Subdivision::Cell;

constexpr double Pi = std::numbers::pi;

reflectance::Brdf brdf_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  return reflectance::make_brdf(grf::read_brdf(text, "BRDF", diagnostics).value(), diagnostics).value();
}

Subdivision tree_of(const std::string& brdf, double theta, double phi,
                    const studies::SubdivisionLimits& limits) {
  return {brdf_of(brdf), Angles{theta * Degree, phi * Degree}, limits};
}

// f is constant, so that rejection in the square around the disc accepts the disc's part of it. 4 / pi tries
// are no reason to split.
TEST(Subdivision, OfADiffuseBrdfIsOneCell) {
  const Subdivision tree = tree_of("diffuse kd=0.5", 30, 0, {2, 8, 100});
  ASSERT_EQ(tree.cells().size(), 1U);
  const Cell& cell = tree.cells().front();
  EXPECT_EQ(cell.depth, 0);
  EXPECT_DOUBLE_EQ(cell.mass, 1);
  EXPECT_NEAR(cell.acceptance, Pi / 4, 1e-6);
  EXPECT_NEAR(cell.maximum, 0.5 / Pi, 1e-6) << "f is kd / pi";
  EXPECT_NEAR(tree.mean_tries(), 4 / Pi, 1e-6);
  EXPECT_NEAR(tree.integral(), 0.5, 1e-6) << "the albedo";
}

// The quarters of the disc fill as much of their squares as the disc of its own: n_max below that splits
// along the rim as far as it may.
TEST(Subdivision, OfADiffuseBrdfIsSplitAtTheRimForFewerTries) {
  const Subdivision once = tree_of("diffuse", 30, 0, {1.2, 1, 128});
  ASSERT_EQ(once.cells().size(), 4U);
  for (const Cell& cell : once.cells()) {
    EXPECT_EQ(cell.depth, 1);
    EXPECT_NEAR(cell.mass, 0.25, 1e-6);
    EXPECT_NEAR(cell.acceptance, Pi / 4, 1e-6);
  }
  const Subdivision more = tree_of("diffuse", 30, 0, {1.2, 8, 128});
  EXPECT_GT(more.cells().size(), 4U);
  for (const Cell& cell : more.cells()) {
    const Box box = DiscGrid::box(cell.range, 128);
    const double nearest = std::hypot(std::clamp(0.0, box.x0, box.x1), std::clamp(0.0, box.y0, box.y1));
    const double farthest = std::hypot(std::max(-box.x0, box.x1), std::max(-box.y0, box.y1));
    if (cell.depth > 2) {
      EXPECT_LT(nearest, 1) << "none is split outside the disc";
    }
    if (farthest < 1) {
      EXPECT_NEAR(cell.acceptance, 1, 1e-3) << "inside it all tries are accepted";
    }
  }
}

TEST(Subdivision, KeepsTheRuleOfSplitting) {
  for (const std::string brdf : {"ward sx=0.2 sy=0.2", "ward sx=0.1 sy=0.4", "phong n=200 ks=0.5 kd=0.4",
                                 "lewis n=500 ks=1 kd=0", "ashikhmin nu=10 nv=200"}) {
    for (const double nmax : {1.1, 2.0, 8.0}) {
      for (const int depth : {0, 3, 5, 20}) {
        const Subdivision tree = tree_of(brdf, 50, 20, {nmax, depth, 100});
        double mass = 0;
        double area = 0;
        for (const Cell& cell : tree.cells()) {
          mass += cell.mass;
          area += disc_area(DiscGrid::box(cell.range, 100));
          EXPECT_LE(cell.depth, depth);
          // V <= n_max I, as the acceptance is I / V.
          EXPECT_TRUE(cell.acceptance * nmax >= 1 - 1e-6 || cell.depth == depth || cell.range.is_one())
              << brdf << ' ' << nmax << ' ' << depth << ": " << cell.acceptance << " at " << cell.depth;
          EXPECT_LE(cell.acceptance, 1 + 1e-6);
        }
        EXPECT_NEAR(mass, 1, 1e-5);
        EXPECT_NEAR(area, Pi, 1e-6);
        EXPECT_LE(tree.deepest(), depth);
      }
    }
  }
}

TEST(Subdivision, AWayEndsInTheCellOfItsPoint) {
  for (const double phi : {0.0, 35.0, 180.0}) {
    const Subdivision tree = tree_of("phong n=80 ks=0.7 kd=0.2", 60, phi, {1.5, 20, 200});
    std::set<std::size_t> seen;
    for (int i = 0; i < 400; ++i) {
      const double radius = std::sqrt((i + 0.5) / 400);
      const double angle = 2.4 * i;
      const double x = radius * std::cos(angle);
      const double y = radius * std::sin(angle);
      const auto index = tree.cell_at(x, y);
      ASSERT_TRUE(index);
      seen.insert(*index);
      const Cell& cell = tree.cells()[*index];
      const auto way = tree.path_to(x, y);
      ASSERT_EQ(way.size(), static_cast<std::size_t>(cell.depth) + 1);
      EXPECT_EQ(way.front().probability, 1);
      double mass = 1;
      for (const auto& step : way) mass *= step.probability;
      EXPECT_NEAR(mass, cell.mass, 1e-5 * cell.mass);
      EXPECT_EQ(way.back().range.x0, cell.range.x0);
      EXPECT_EQ(way.back().range.y1, cell.range.y1);
      // The point is inside each node's square, wherever that was turned.
      for (const auto& step : way) {
        const auto corners = tree.corners(step.range);
        for (std::size_t k = 0; k < 4; ++k) {
          const plot::Point side = corners[(k + 1) % 4] - corners[k];
          const plot::Point to = plot::Point(x, y) - corners[k];
          EXPECT_GT(side.x * to.y - side.y * to.x, -1e-5);
        }
      }
    }
    EXPECT_GT(seen.size(), 10U);
    EXPECT_FALSE(tree.cell_at(0.8, 0.7)) << "outside the disc";
  }
}

TEST(Subdivision, TurnsWithTheView) {
  // The largest bound is at the mirror direction.
  for (const double phi : {0.0, 90.0, -120.0}) {
    const Subdivision tree = tree_of("phong n=200 ks=0.9 kd=0.1", 40, phi, {2, 8, 200});
    const Vec3f mirror = reflectance::mirrored(studies::direction_of({40 * Degree, phi * Degree}));
    const auto brightest = std::ranges::max_element(tree.cells(), {}, &Cell::maximum);
    EXPECT_NEAR(tree.cells()[*tree.cell_at(mirror.x, mirror.y)].maximum, brightest->maximum,
                0.3 * brightest->maximum);
    EXPECT_LT(tree.cells()[*tree.cell_at(-mirror.x, -mirror.y)].maximum, 0.1 * brightest->maximum);
  }
}

TEST(Subdivision, IntegratesPdfsDownToTheRim) {
  for (const double phi : {0.0, 30.0}) {
    const Subdivision tree = tree_of("diffuse", 30, phi, {2, 8, 200});
    const auto uniform = tree.integrals([](const Vec3f&) { return 1 / (2 * Pi); }, {});
    double sum = 0;
    double beyond = 0;
    for (std::size_t i = 0; i < uniform.size(); ++i) {
      sum += uniform[i];
      if (i % 200 >= 190) beyond += uniform[i];
    }
    EXPECT_NEAR(sum, 1, 1e-3);
    EXPECT_NEAR(beyond, 0.05, 1e-4) << "half of a cap of height 0.1, of a hemisphere of height 1";
    const auto cosine = tree.integrals([](const Vec3f& v) { return v.z / Pi; }, {});
    EXPECT_NEAR(cosine[tree.grid_index(0.1, 0.2)], 1e-4 / Pi, 1e-8) << "a cell's area over pi";
    EXPECT_NEAR(tree.sums_over_cells(cosine).front(), 1, 1e-3);
  }
}

TEST(GoodnessOfFit, AgreesWithTheTable) {
  // A die that was thrown 60 times: chi-square is 13.4, and 5 degrees of freedom have 15.086 at 1 %.
  const std::vector<double> expected(6, 10.0);
  const auto die = studies::goodness_of_fit(expected, std::vector<double>{5, 8, 9, 8, 10, 20});
  EXPECT_NEAR(die.statistic, 13.4, 1e-9);
  EXPECT_EQ(die.degrees, 5);
  EXPECT_NEAR(die.p_value, 0.0199, 1e-4);
  // Small cells are pooled, as in the tests' own function.
  const std::vector<double> small = {1, 2, 3, 30, 4, 60};
  const std::vector<double> counts = {0, 5, 1, 41, 3, 50};
  EXPECT_NEAR(studies::goodness_of_fit(small, counts).p_value, statistics::chi_square_p_value(small, counts),
              1e-9);
  EXPECT_EQ(studies::goodness_of_fit(small, counts).degrees, 2);
  EXPECT_EQ(studies::goodness_of_fit(std::vector<double>{50, 50, 0}, std::vector<double>{50, 29, 21}).p_value,
            0);
  EXPECT_EQ(studies::goodness_of_fit({}, {}).p_value, 1);
}

struct Sampled {
  reflectance::SampledInstance instance;
  Subdivision tree;
  Vec3f u;

  Sampled(const std::string& brdf, const std::string& pdf, double theta)
      : instance(instance_of(brdf, pdf)),
        tree(instance.reflector.brdf(), Angles{theta * Degree, 0}, {2, 8, 200}),
        u(studies::direction_of({theta * Degree, 0})) {}

  static reflectance::SampledInstance instance_of(const std::string& brdf, const std::string& pdf) {
    grf::Diagnostics diagnostics;
    return reflectance::read_sampled_instance(brdf, pdf, diagnostics).value();
  }

  /// Returns the p-value if samples should have a pdf.
  double p_value(std::uint32_t seed, const std::function<double(const Vec3f&)>& pdf,
                 transport::SamplePattern pattern = transport::SamplePattern::Sobol) const {
    const auto drawn = studies::draw_samples(instance.reflector, u, 2500, seed, pattern);
    return studies::cell_samples(drawn, instance.reflector, u, tree, tree.integrals(pdf, {})).fit.p_value;
  }
};

TEST(CellSamples, FollowThePdfsOfTheSchemesAndNoOthers) {
  for (const std::string pdf : {"adaptive mode=reject nQT=30 res=200", "adaptive", "factored half=true",
                                "hemisphere", "own", "diffuse", "sphere exp=20"}) {
    const Sampled sampled("ward sx=0.2 sy=0.2", pdf, 45);
    const reflectance::Reflector& reflector = sampled.instance.reflector;
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      EXPECT_GT(sampled.p_value(seed, [&](const Vec3f& v) { return reflector.pdf(sampled.u, v); }), 1e-4)
          << pdf << ' ' << seed;
      // A fifth of the samples from elsewhere.
      const auto wrong = [&](const Vec3f& v) {
        return 0.8 * reflector.pdf(sampled.u, v) + 0.2 * (v.y > 0 ? 2 * v.z / Pi : 0);
      };
      EXPECT_LT(sampled.p_value(seed, wrong), 1e-4) << pdf << ' ' << seed;
    }
  }
}

// P-values of independent samples are uniform in [0,1]; those of Sobol' points are near 1.
TEST(CellSamples, OfIndependentNumbersHaveUniformPValues) {
  const Sampled sampled("ward sx=0.2 sy=0.2", "adaptive mode=reject nQT=30 res=200", 45);
  const auto pdf = [&](const Vec3f& v) { return double(sampled.instance.reflector.pdf(sampled.u, v)); };
  double mean = 0;
  int small = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const double p = sampled.p_value(seed, pdf, transport::SamplePattern::Independent);
    EXPECT_GT(p, 1e-4);
    mean += p / 40;
    small += p < 0.25 ? 1 : 0;
  }
  EXPECT_NEAR(mean, 0.5, 4 * std::sqrt(1 / 12.0 / 40));
  EXPECT_NEAR(small, 10, 4 * std::sqrt(40 * 0.25 * 0.75));
}

TEST(CellSamples, CountSpecularAndRejectedSamplesAsSuch) {
  const Sampled coupled("coupled", "adaptive mode=reject nQT=10 res=60", 60);
  const auto drawn = studies::draw_samples(coupled.instance.reflector, coupled.u, 1000, 1);
  const auto pdf = [&](const Vec3f& v) { return double(coupled.instance.reflector.pdf(coupled.u, v)); };
  const auto samples = studies::cell_samples(drawn, coupled.instance.reflector, coupled.u, coupled.tree,
                                             coupled.tree.integrals(pdf, {}));
  EXPECT_GT(samples.specular, 10U);
  EXPECT_EQ(samples.count(), 1000U);
  double counted = 0;
  for (const double cell : samples.counted) counted += cell;
  EXPECT_EQ(counted, static_cast<double>(samples.points.size()));
  EXPECT_GT(samples.fit.p_value, 1e-4);
}

}  // namespace
}  // namespace subdivision_test
