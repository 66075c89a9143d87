// Rejection trees: geometry of the disc, exact pdfs, the bounds of rejection, and degenerate tables.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/reflector.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"
#include "tests/statistics/chi_square.h"

namespace {

using reflectance::Box;
using reflectance::DiscGrid;
using reflectance::Reflector;
using reflectance::RejectionSettings;
using reflectance::RejectionTree;
using reflectance::RejectionTrees;
using reflectance::SplitMix;
using reflectance::Uniforms;
using reflectance::Vec3f;

/// Area and bounds of the part of a box inside the disc, by counting points.
struct Counted {
  double area = 0;
  Box bounds = {2, 2, -2, -2};
};
Counted counted(const Box& box) {
  constexpr int Steps = 1000;
  Counted result;
  for (int i = 0; i < Steps * Steps; ++i) {
    const double x = box.x0 + (i % Steps + 0.5) / Steps * (box.x1 - box.x0);
    const double y = box.y0 + (i / Steps + 0.5) / Steps * (box.y1 - box.y0);
    if (x * x + y * y >= 1) continue;
    result.area += box.area() / (Steps * Steps);
    result.bounds = {std::min(result.bounds.x0, x), std::min(result.bounds.y0, y),
                     std::max(result.bounds.x1, x), std::max(result.bounds.y1, y)};
  }
  return result;
}

TEST(Disc, KnowsAreasAndBoundsOfCutBoxes) {
  // All eight cases of the thesis' figure 5.6, three corners, the middle of a side, all of it.
  for (const Box& box :
       {Box{0.5, 0.5, 0.9, 0.9}, Box{-0.9, 0.5, -0.5, 0.9}, Box{0.5, -0.9, 0.9, -0.5},
        Box{-0.9, -0.9, -0.5, -0.5}, Box{0, 0.75, 0.25, 1}, Box{-0.25, 0.75, 0, 1}, Box{0, -1, 0.25, -0.75},
        Box{-0.25, -1, 0, -0.75}, Box{0.75, 0, 1, 0.25}, Box{0.75, -0.25, 1, 0}, Box{-1, 0, -0.75, 0.25},
        Box{-1, -0.25, -0.75, 0}, Box{0, 0, 0.8, 0.8}, Box{-0.1, 0.97, 0.1, 1}, Box{-0.3, 0.98, 0.3, 1},
        Box{-1, -1, 1, 1}, Box{-1, -1, 0, 0}, Box{0.1, 0.1, 0.2, 0.2}}) {
    const Counted expected = counted(box);
    const double side = std::max(box.x1 - box.x0, box.y1 - box.y0);
    const Box bounds = reflectance::inside_disc(box);
    EXPECT_NEAR(reflectance::disc_area(box), expected.area, 2e-3 * box.area());
    EXPECT_NEAR(bounds.x0, expected.bounds.x0, 0.03 * side);
    EXPECT_NEAR(bounds.y0, expected.bounds.y0, 0.03 * side);
    EXPECT_NEAR(bounds.x1, expected.bounds.x1, 0.03 * side);
    EXPECT_NEAR(bounds.y1, expected.bounds.y1, 0.03 * side);
    EXPECT_GE(2 * reflectance::disc_area(box), bounds.area() * (1 - 1e-9));
  }
  EXPECT_EQ(reflectance::disc_area({0.8, 0.8, 1, 1}), 0);
}

// Outside the disc a sum of areas would be rounded to more than 0, and trees would have nodes there.
TEST(Disc, HasNoAreaInCellsOutside) {
  for (const int resolution : {50, 200, 333}) {
    for (int y = 0; y < resolution; ++y) {
      for (int x = 0; x < resolution; ++x) {
        const reflectance::Box box = reflectance::DiscGrid::box({x, y, x + 1, y + 1}, resolution);
        const double corner = std::min({std::hypot(box.x0, box.y0), std::hypot(box.x0, box.y1),
                                        std::hypot(box.x1, box.y0), std::hypot(box.x1, box.y1)});
        if (corner <= 1 || box.x0 * box.x1 < 0 || box.y0 * box.y1 < 0) continue;
        EXPECT_EQ(reflectance::disc_area(box), 0) << x << ' ' << y << " of " << resolution;
      }
    }
  }
}

TEST(Disc, IsTheSumOfItsCells) {
  for (const int resolution : {2, 3, 7, 64, 333}) {
    const DiscGrid grid(resolution);
    double sum = 0;
    for (int y = 0; y < resolution; ++y) {
      for (int x = 0; x < resolution; ++x) sum += grid.area(x, y);
    }
    EXPECT_NEAR(sum, std::numbers::pi, 1e-6) << resolution;
  }
}

std::vector<float> values_of(const DiscGrid& grid, const std::function<float(double, double)>& function) {
  std::vector<float> values;
  for (int y = 0; y < grid.resolution(); ++y) {
    for (int x = 0; x < grid.resolution(); ++x) {
      const Box box = DiscGrid::box({x, y, x + 1, y + 1}, grid.resolution());
      values.push_back(function((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2));
    }
  }
  return values;
}

float bump(double x, double y) {
  return static_cast<float>(std::exp(-60 * ((x - 0.6) * (x - 0.6) + y * y)) + 0.1 * (1 + x));
}

TEST(RejectionTree, DrawsCellsByTheirExactShare) {
  const DiscGrid grid(24);
  for (const float most_tries : {1.05F, 2.0F, 100.0F, reflectance::AnyTries}) {
    const RejectionTree tree(values_of(grid, bump), grid, most_tries, true);
    constexpr int Samples = 400000;
    std::vector<int> counts(grid.resolution() * grid.resolution());
    for (int i = 0; i < Samples; ++i) {
      SplitMix more({{float(i), 1}, 2});
      const auto leaf = tree.leaf_of(more.next());
      const auto point =
          tree.draw(leaf, more.next_pair(), more, [&](double x, double y) { return tree.at(x, y); });
      ASSERT_TRUE(point);
      ++counts[grid.index(DiscGrid::cell_of(point->x, 24), DiscGrid::cell_of(point->y, 24))];
    }
    double statistic = 0;
    double mass = 0;
    int terms = 0;
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 24; ++x) {
        const Box box = DiscGrid::box({x, y, x + 1, y + 1}, 24);
        const double share = double(tree.at((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)) *
                             tree.pdf_of_one() * grid.area(x, y);
        mass += share;
        if (share * Samples < 5) continue;
        const double off = counts[grid.index(x, y)] - share * Samples;
        statistic += off * off / (share * Samples);
        ++terms;
      }
    }
    EXPECT_NEAR(mass, 1, 1e-6);
    EXPECT_LT(std::abs(statistic - terms), 4.5 * std::sqrt(2.0 * terms)) << most_tries;
  }
}

/// Returns the mean number of tries, with leaves weighted by probability.
double mean_tries(const RejectionTree& tree) {
  double tries = 0;
  constexpr int Samples = 20000;
  for (int i = 0; i < Samples; ++i) {
    SplitMix more({{float(i), 3}, 4});
    const auto leaf = tree.leaf_of(more.next());
    tries +=
        tree.draw(leaf, more.next_pair(), more, [&](double x, double y) { return tree.at(x, y); })->tries;
  }
  return tries / Samples;
}

TEST(RejectionTree, NeedsNoMoreTriesThanItIsToldAndMoreNodesForFewer) {
  const DiscGrid grid(200);
  std::size_t before = 1U << 30U;
  for (const float most_tries : {1.01F, 1.3F, 2.0F, 3.0F, 10.0F}) {
    const RejectionTree tree(values_of(grid, bump), grid, most_tries, true);
    EXPECT_LT(mean_tries(tree), most_tries + 0.02) << most_tries;
    EXPECT_LE(tree.nodes().size(), before);
    before = tree.nodes().size();
  }
}

TEST(RejectionTree, IsNotDeeperThanItMayBe) {
  const DiscGrid grid(64);
  const auto deepest = [&](int most_depth) {
    const RejectionTree tree(values_of(grid, bump), grid, 1.05F, false, most_depth);
    int depth = 0;
    double mass = 0;
    tree.visit_leaves([&](const RejectionTree::Leaf& leaf, int of_leaf) {
      EXPECT_LT(leaf.node->children, 0);
      EXPECT_EQ(leaf.cells.x1 - leaf.cells.x0, 64 >> of_leaf);
      depth = std::max(depth, of_leaf);
      mass += leaf.node->integral;
    });
    EXPECT_NEAR(mass, tree.nodes()[0].integral, 1e-5);
    return depth;
  };
  EXPECT_EQ(deepest(0), 0);
  EXPECT_EQ(deepest(1), 1);
  EXPECT_EQ(deepest(4), 4);
  EXPECT_EQ(deepest(RejectionTree::AnyDepth), 6) << "single cells";
  const RejectionTree any(values_of(grid, bump), grid, 1.5F, false);
  const RejectionTree six(values_of(grid, bump), grid, 1.5F, false, 6);
  EXPECT_EQ(any.nodes().size(), six.nodes().size());
}

TEST(RejectionTree, IsDefinedForOneSpike) {
  const DiscGrid grid(100);
  std::vector<float> values(100 * 100);
  values[grid.index(70, 40)] = 1e30F;
  for (const float most_tries : {1.01F, 2.0F, reflectance::AnyTries}) {
    const RejectionTree tree(values, grid, most_tries, true);
    EXPECT_TRUE(std::isfinite(tree.pdf_of_one()));
    int hits = 0;
    int empty = 0;
    for (int i = 0; i < 2000; ++i) {
      SplitMix more({{float(i), 5}, 6});
      const auto point = tree.draw(tree.leaf_of(more.next()), more.next_pair(), more,
                                   [&](double x, double y) { return tree.at(x, y); });
      if (!point) {
        ++empty;
      } else if (DiscGrid::cell_of(point->x, 100) == 70 && DiscGrid::cell_of(point->y, 100) == 40) {
        ++hits;
      }
    }
    EXPECT_NEAR(hits, (2000 - empty) * 0.99, 30) << most_tries;
    EXPECT_TRUE(empty == 0 || !std::isfinite(most_tries));
  }
}

TEST(RejectionTree, OfNothingIsUniform) {
  const DiscGrid grid(10);
  const RejectionTree tree(std::vector<float>(100), grid, 2, true);
  EXPECT_NEAR(tree.at(0.3, 0.2) * tree.pdf_of_one(), 1 / std::numbers::pi, 1e-6);
  EXPECT_EQ(tree.nodes().size(), 1U);
}

// If rejection in the whole disc often reaches its bound, the pdf integrates to the fraction accepted.
TEST(RejectionTree, AccountsForItsBound) {
  const DiscGrid grid(200);
  std::vector<float> values(200 * 200);
  values[grid.index(100, 100)] = 1;
  const RejectionTree tree(values, grid, reflectance::AnyTries, true);
  constexpr int Samples = 4000;
  int drawn = 0;
  for (int i = 0; i < Samples; ++i) {
    SplitMix more({{float(i), 7}, 8});
    const auto value = [&](double x, double y) { return tree.at(x, y); };
    if (tree.draw(tree.leaf_of(0), more.next_pair(), more, value)) ++drawn;
  }
  const double mass = tree.pdf_of_one() * tree.nodes()[0].integral;
  EXPECT_LT(mass, 0.2);
  EXPECT_NEAR(drawn, mass * Samples, 4.5 * std::sqrt(mass * Samples));
}

RejectionSettings small(int thetas, int resolution) {
  RejectionSettings settings;
  settings.thetas = thetas;
  settings.resolution = resolution;
  return settings;
}

TEST(RejectionTrees, AreTheSameWithoutTheirTables) {
  for (const std::string text : {"phong n=100 ks=0.4 kd=0.6", "lewis n=100 ks=1 kd=0", "ward sx=0.15 sy=0.4",
                                 "schlick SC=0.7 Sr=0.31", "minnaert k=0.8 kd=1"}) {
    const reflectance::Brdf brdf = test::brdf_of(text);
    RejectionSettings settings = small(6, 100);
    const RejectionTrees kept(brdf, settings);
    settings.keep_table = false;
    const RejectionTrees freed(brdf, settings);
    std::uint32_t i = 0;
    for (const test::Pair& pair : test::direction_pairs(3000, 5)) {
      ASSERT_EQ(kept.pdf(brdf, pair.u, pair.v), freed.pdf(brdf, pair.u, pair.v)) << text;
      const Uniforms xi = reflectance::halton_point(i++);
      const auto of_kept = kept.draw(brdf, pair.u, xi);
      const auto of_freed = freed.draw(brdf, pair.u, xi);
      ASSERT_EQ(of_kept.has_value(), of_freed.has_value()) << text;
      if (of_kept) {
        ASSERT_EQ(of_kept->direction, of_freed->direction) << text;
      }
    }
  }
}

TEST(RejectionTrees, ManySamplesAreSharedByTheDensity) {
  const reflectance::Brdf brdf = test::brdf_of("phong n=50 ks=0.8 kd=0.5");
  reflectance::Scheme scheme = test::scheme_of("adaptive mode=reject nQT=20 res=100");
  build(scheme, brdf);
  const Vec3f u = test::direction(40, 25);
  std::vector<reflectance::DirectionSample> many;
  for (int batch = 0; batch < 400; ++batch) {
    std::vector<Uniforms> xi(250);
    for (int i = 0; i < 250; ++i) xi[i] = reflectance::halton_point(batch * 250 + i);
    sample_many(scheme, brdf, u, xi, many);
  }
  ASSERT_EQ(many.size(), 100000U);
  const auto pdf = [&](const Vec3f& v) { return double(reflectance::pdf(scheme, brdf, u, v)); };
  const statistics::ChiSquareTest test(pdf, reflectance::mirrored(u), 3);
  std::size_t next = 0;
  // Counts vary less than those of independent samples, so only deviations are detected.
  EXPECT_GT(test.p_value([&] { return std::optional(many[next++].direction); }, 100000), 1e-4);
  for (const auto& sample : many) ASSERT_EQ(sample.pdf, pdf(sample.direction));
}

TEST(RejectionTrees, ManySamplesVaryLessThanSingleOnes) {
  const reflectance::Brdf brdf = test::brdf_of("phong n=50 ks=0.8 kd=0.5");
  reflectance::Scheme scheme = test::scheme_of("adaptive mode=reject nQT=20 res=100");
  build(scheme, brdf);
  const Vec3f u = test::direction(40, 25);
  const auto seen = [](const Vec3f& v) { return v.x < -0.5F && v.y < 0.1F; };
  double squares_many = 0;
  double squares_single = 0;
  constexpr int Count = 64;
  double share = 0;
  std::vector<std::pair<double, double>> runs;
  SplitMix random({{1, 2}, 3});
  for (int run = 0; run < 500; ++run) {
    std::vector<Uniforms> xi;
    for (int i = 0; i < Count; ++i) xi.push_back({random.next_pair(), random.next_pair().x});
    std::vector<reflectance::DirectionSample> many;
    sample_many(scheme, brdf, u, xi, many);
    double of_many = 0;
    double of_single = 0;
    for (const auto& sample : many) of_many += seen(sample.direction);
    for (const auto& one : xi) of_single += seen(sample(scheme, brdf, u, one)->direction);
    runs.emplace_back(of_many, of_single);
    share += of_many + of_single;
  }
  share /= 2 * 500;
  for (const auto& [of_many, of_single] : runs) {
    squares_many += (of_many - share) * (of_many - share);
    squares_single += (of_single - share) * (of_single - share);
  }
  EXPECT_LT(squares_many, 0.5 * squares_single);
}

TEST(SampleMany, FallsBackToSingleSamples) {
  const reflectance::Brdf brdf = test::brdf_of("ward");
  const reflectance::Scheme scheme = reflectance::OwnScheme();
  const Vec3f u = test::direction(40, 25);
  std::vector<Uniforms> xi;
  for (int i = 0; i < 50; ++i) xi.push_back(reflectance::halton_point(i));
  std::vector<reflectance::DirectionSample> many;
  sample_many(scheme, brdf, u, xi, many);
  std::size_t next = 0;
  for (const Uniforms& one : xi) {
    if (const auto single = sample(scheme, brdf, u, one)) {
      ASSERT_LT(next, many.size());
      EXPECT_EQ(single->direction, many[next++].direction);
    }
  }
  EXPECT_EQ(next, many.size());
}

TEST(RejectionTrees, AreTheSameOnOneThread) {
  const reflectance::Brdf brdf = test::brdf_of("ward sx=0.15 sy=0.4");
  const auto pdfs = [&] {
    const RejectionTrees trees(brdf, small(5, 60));
    std::vector<float> all;
    for (const test::Pair& pair : test::direction_pairs(3000, 5)) {
      all.push_back(trees.pdf(brdf, pair.u, pair.v));
    }
    return std::pair(all, trees.bytes());
  };
  const auto parallel = pdfs();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(parallel, pdfs());
}

TEST(RejectionTrees, HoldLessWithoutTables) {
  const reflectance::Brdf brdf = test::brdf_of("phong n=100 ks=0.4 kd=0.6");
  RejectionSettings settings = small(10, 200);
  const std::size_t kept = RejectionTrees(brdf, settings).bytes();
  settings.keep_table = false;
  const std::size_t freed = RejectionTrees(brdf, settings).bytes();
  EXPECT_EQ(kept - freed, 10 * 200 * 200 * sizeof(half));
  EXPECT_LT(freed, 100000U);
}

TEST(RejectionTrees, HaveAsManyAzimuthsAsTheBrdfNeeds) {
  EXPECT_EQ(RejectionTrees(test::brdf_of("ward sx=0.2"), small(3, 20)).trees().size(), 3U);
  EXPECT_EQ(RejectionTrees(test::brdf_of("ward sx=0.2 sy=0.3"), small(3, 20)).trees().size(), 48U);
  EXPECT_EQ(RejectionTrees(test::brdf_of("diffuse kd=0"), small(3, 20)).trees().size(), 0U);
}

/// Compares the albedo by samples with quadrature.
void expect_albedo(const std::string& brdf, const std::string& scheme, double degrees) {
  const Reflector subject(test::brdf_of(brdf), test::scheme_of(scheme));
  const Vec3f u = test::direction(degrees, 25);
  const statistics::Quadrature quadrature(
      [&](const Vec3f& v) { return subject.evaluate(u, v).x * double(v.z); }, reflectance::mirrored(u), 1e-8);
  double sum = 0;
  double squares = 0;
  constexpr int Samples = 50000;
  SplitMix random({{5, 6}, 7});
  for (int i = 0; i < Samples; ++i) {
    const auto sample = subject.sample(u, {random.next_pair(), random.next_pair().x});
    const double weight = sample ? sample->weight.x : 0;
    ASSERT_TRUE(std::isfinite(weight) && weight >= 0);
    sum += weight;
    squares += weight * weight;
  }
  const double mean = sum / Samples;
  const double deviation = std::sqrt(std::max(0.0, squares / Samples - mean * mean) / Samples);
  const double exact = quadrature.over_hemisphere() + reflectance::specular_weight(subject.brdf(), u).x;
  EXPECT_NEAR(mean, exact, 4.5 * deviation + 2e-4 * exact + 1e-9)
      << brdf << " / " << scheme << " " << degrees;
}

TEST(Degenerate, OneTreeIsUnbiasedForAllViews) {
  for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
    expect_albedo("phong n=20 ks=0.8 kd=0.5", "adaptive nQT=1 nAnisoQT=1 res=50", degrees);
    expect_albedo("ward sx=0.15 sy=0.4", "adaptive nQT=1 nAnisoQT=1 res=50", degrees);
    expect_albedo("blinn n=10", "reject nQT=1 nAnisoQT=1 res=2", degrees);
  }
}

TEST(Degenerate, AGrazingViewThatTheBrdfIsBlackForIsDefined) {
  // The lobe is below the horizon for every view from above.
  expect_albedo("lafortune n=50 kp=0 Cx=-1 Cy=-1 Cz=-1", "adaptive nQT=5 res=50", 30);
  expect_albedo("lafortune n=4 kp=0 Cx=-1 Cy=-1 Cz=-0.5", "adaptive nQT=5 res=50", 80);
}

TEST(Degenerate, TriesOfNearlyOneAreDefined) {
  expect_albedo("lewis n=100 ks=1 kd=0", "adaptive nQT=1 res=800 nmax=1.01", 45);
}

TEST(Degenerate, FineGridsAreDefined) {
  expect_albedo("lewis n=100 ks=1 kd=0", "adaptive nQT=1 res=4096", 45);
}

TEST(Degenerate, NarrowLobesAreUnbiased) {
  expect_albedo("lewis n=5000 ks=1 kd=0", "adaptive nQT=90 res=200", 30);
  expect_albedo("lewis n=5000 ks=1 kd=0", "reject nQT=90 res=200", 30);
}

TEST(Degenerate, BlackAndMirrorBrdfs) {
  for (const std::string scheme : {"adaptive nQT=3 res=20", "reject nQT=3 res=20"}) {
    const Reflector black(test::brdf_of("diffuse kd=0"), test::scheme_of(scheme));
    const Vec3f u = test::direction(30, 0);
    EXPECT_FALSE(black.sample(u, {{0.3F, 0.4F}, 0.5F}));
    EXPECT_EQ(black.pdf(u, u), 0);
    const std::string reason = unsupported_reason(test::scheme_of(scheme), test::brdf_of("specular"));
    EXPECT_NE(reason.find("specular"), std::string::npos);
    EXPECT_EQ(unsupported_reason(test::scheme_of(scheme), test::brdf_of("coupled")), "");
  }
}

}  // namespace
