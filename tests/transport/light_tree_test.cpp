// Sampling one of many emitters by the light tree.
#include "renderer/transport/lights/light_tree.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "tests/statistics/chi_square.h"
#include "tests/transport/solid_angles.h"

namespace {

using grf::Vec3f;
using test::Vec3l;
using transport::Emitter;
using transport::LightTree;
using transport::Rgb;

class Emitters {
 public:
  explicit Emitters(std::uint32_t seed) : random_(seed) {}

  float number(float least = 0, float most = 1) {
    return std::uniform_real_distribution<float>(least, most)(random_);
  }
  Vec3f vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }

  /// Emitters of all orientations in a cube of edge 2; sizes and radiances differ widely.
  std::vector<Emitter> any(std::size_t count) {
    std::vector<Emitter> emitters;
    for (std::size_t i = 0; i < count; ++i) {
      const float size = std::pow(10.0F, number(-3, -1));
      emitters.push_back({vector(), vector() * size, vector() * size, random_() % 2 == 0,
                          Rgb(std::pow(10.0F, number(-1, 2)))});
    }
    return emitters;
  }

  /// Only a ceiling of small lights that shine down.
  std::vector<Emitter> ceiling(std::size_t count) {
    std::vector<Emitter> emitters;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3f corner{number(-5, 5), number(-5, 5), 3};
      emitters.push_back({corner, Vec3f(0, 0.1F, 0), Vec3f(0.1F, 0, 0), false, Rgb(number(0.5F, 2))});
    }
    return emitters;
  }

 private:
  std::mt19937 random_;
};

double sum_of_probabilities(const LightTree& tree, const std::vector<Emitter>& emitters, const Vec3f& from,
                            const Vec3f& normal) {
  double sum = 0;
  for (std::uint32_t i = 0; i < emitters.size(); ++i) {
    sum += double(tree.probability(emitters, from, normal, i));
  }
  return sum;
}

TEST(LightTree, ProbabilitiesAddUpToOneWhereAllShine) {
  for (const std::size_t count : {1U, 2U, 3U, 17U, 1000U}) {
    Emitters make(static_cast<std::uint32_t>(count));
    const auto emitters = make.ceiling(count);
    const LightTree tree(emitters);
    for (int i = 0; i < 20; ++i) {
      const Vec3f from{make.number(-5, 5), make.number(-5, 5), make.number(0, 2.8F)};
      EXPECT_NEAR(sum_of_probabilities(tree, emitters, from, {0, 0, 1}), 1, 1e-5) << count;
    }
  }
}

TEST(LightTree, ChoosesByItsProbabilities) {
  constexpr int Tests = 40;
  Emitters make(3);
  for (int test = 0; test < Tests; ++test) {
    const auto emitters = make.any(2 + test);
    const LightTree tree(emitters);
    const Vec3f from = make.vector() * 1.5F;
    const Vec3f normal = make.vector().normalized();
    constexpr int Samples = 20000;
    std::vector<double> expectation;
    for (std::uint32_t i = 0; i < emitters.size(); ++i) {
      expectation.push_back(Samples * double(tree.probability(emitters, from, normal, i)));
    }
    std::vector<double> counts(emitters.size());
    double none = 0;
    for (int i = 0; i < Samples; ++i) {
      const auto choice = tree.choose(emitters, from, normal, (i + double(make.number())) / Samples);
      if (!choice) {
        ++none;
        continue;
      }
      ASSERT_FLOAT_EQ(choice->probability, tree.probability(emitters, from, normal, choice->emitter));
      counts[choice->emitter] += 1;
    }
    // One stratum per sample: counts are exact up to a few, as each emitter is a run of strata.
    for (std::size_t i = 0; i < emitters.size(); ++i) EXPECT_NEAR(counts[i], expectation[i], 3) << i;
    const double sum = sum_of_probabilities(tree, emitters, from, normal);
    EXPECT_LT(sum, 1 + 1e-5);
    EXPECT_NEAR(none, Samples * (1 - sum), 3.0 * double(emitters.size()));
  }
}

TEST(LightTree, MissesNoLight) {
  Emitters make(4);
  const auto emitters = make.any(200);
  const LightTree tree(emitters);
  int lit = 0;
  for (int k = 0; k < 500; ++k) {
    const Vec3f from = make.vector() * (k % 2 == 0 ? 1.0F : 20.0F);
    const Vec3f normal = make.vector().normalized();
    for (std::uint32_t i = 0; i < emitters.size(); ++i) {
      const Emitter& emitter = emitters[i];
      const Vec3l corner = Vec3l(emitter.corner) - Vec3l(from);
      const Vec3l a(emitter.edge1);
      const Vec3l b(emitter.edge2);
      std::vector<Vec3l> corners = {corner, corner + a, corner + a + b, corner + b};
      if (emitter.is_triangle) corners.erase(corners.begin() + 2);
      const bool shows_front = a.cross(b).dot(corner) < 0;
      const double irradiance = shows_front ? test::lambert_irradiance(corners, Vec3l(normal)) : 0;
      const float probability = tree.probability(emitters, from, normal, i);
      const double solid_angle = test::solid_angle_of_parallelogram(corner, a, b);
      if (irradiance > 1e-4 * solid_angle) {
        ASSERT_GT(probability, 0) << k << ' ' << i << ' ' << irradiance;
        ++lit;
      } else if (irradiance == 0) {
        ASSERT_EQ(probability, 0) << k << ' ' << i;
      }
    }
  }
  EXPECT_GT(lit, 10000);
}

TEST(LightTree, PrefersWhatGivesMoreLight) {
  Emitters make(5);
  const auto emitters = make.ceiling(1000);
  const LightTree tree(emitters);
  // The variance of one sample, compared with sampling by power.
  double by_tree = 0;
  double by_power = 0;
  double total_power = 0;
  for (const Emitter& emitter : emitters) total_power += emitter.power();
  const Vec3f from(1, 2, 2.5F);
  double irradiance = 0;
  for (std::uint32_t i = 0; i < emitters.size(); ++i) {
    const Emitter& emitter = emitters[i];
    const Vec3l corner = Vec3l(emitter.corner) - Vec3l(from);
    const Vec3l a(emitter.edge1);
    const Vec3l b(emitter.edge2);
    const double part = double(emitter.radiance.x) *
                        test::lambert_irradiance({corner, corner + a, corner + a + b, corner + b}, {0, 0, 1});
    irradiance += part;
    by_tree += part * part / double(tree.probability(emitters, from, {0, 0, 1}, i));
    by_power += part * part / (double(emitter.power()) / total_power);
  }
  by_tree = by_tree / (irradiance * irradiance) - 1;
  by_power = by_power / (irradiance * irradiance) - 1;
  EXPECT_LT(by_tree, 2);
  EXPECT_GT(by_power, 20 * by_tree);
}

TEST(LightTree, DoesNotDependOnTheNumberOfThreads) {
  Emitters make(6);
  const auto emitters = make.any(20000);
  LightTree one;
  tbb::task_arena(1).execute([&] { one = LightTree(emitters); });
  LightTree many;
  tbb::task_arena(7).execute([&] { many = LightTree(emitters); });
  for (std::uint32_t i = 0; i < emitters.size(); i += 7) {
    const Vec3f from = make.vector() * 2.0F;
    const Vec3f normal = make.vector().normalized();
    ASSERT_EQ(one.probability(emitters, from, normal, i), many.probability(emitters, from, normal, i));
  }
}

TEST(LightTree, TakesEmittersInOnePlaceAndWithoutPower) {
  const Emitter bright{Vec3f(0, 0, 1), Vec3f(0, 1, 0), Vec3f(1, 0, 0), false, Rgb(1)};
  Emitter black = bright;
  black.radiance = Rgb(0);
  Emitter flat = bright;
  flat.edge2 = flat.edge1;
  std::vector<Emitter> emitters(50, bright);
  emitters.push_back(black);
  emitters.push_back(flat);
  const LightTree tree(emitters);
  const Vec3f up(0, 0, 1);
  EXPECT_NEAR(tree.probability(emitters, Vec3f(0), up, 0), 1.0 / 50, 1e-6);
  EXPECT_EQ(tree.probability(emitters, Vec3f(0), up, 50), 0);
  EXPECT_EQ(tree.probability(emitters, Vec3f(0), up, 51), 0);
  EXPECT_NEAR(sum_of_probabilities(tree, emitters, Vec3f(0), up), 1, 1e-5);
  EXPECT_FALSE(tree.choose(emitters, Vec3f(0), -up, 0.5));
  EXPECT_FALSE(tree.choose(emitters, Vec3f(0, 0, 2), -up, 0.5));
}

}  // namespace
