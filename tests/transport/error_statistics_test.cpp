// Long statistical tests of the error estimate and adaptive sampling, over many seeds. In the environment,
// ERROR_SEEDS=20 runs fewer seeds, and ERROR_SCENES=7 replaces the clock as the seed of random scenes.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/transport/truncation.h"
#include "tests/transport/bright_scenes.h"
#include "tests/transport/error_study.h"

namespace {

unsigned from_environment(const char* name, unsigned otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

void print_study(const std::string& name, const test::ErrorStudy& study) {
  std::printf("%-28s inside %5.1f %%, above %4.1f %%, stated / true %.2f, high / low %.2f\n", name.c_str(),
              100 * study.coverage(), 100.0 * study.above / study.runs, study.mean_quotient(),
              study.mean_width());
  std::fflush(stdout);
}

std::vector<test::ErrorCase> chosen_cases() {
  using test::BrightScene;
  const std::string diffuse = "brdf diffuse kd=0.6";
  const std::string glossy = "brdf ward sx=0.03 sy=0.03 ks=0.5 kd=0.2";
  std::vector<test::ErrorCase> cases;
  cases.push_back(test::cornell_case(128, 12));
  cases.push_back(test::cornell_case(64, 4));
  cases.push_back(test::cornell_case(64, 64));
  for (test::SampleScene& scene : test::error_scenes()) cases.push_back({std::move(scene), 64});
  cases.push_back(test::checker_case(64, 16, 16));
  cases.push_back(test::checker_case(96, 200, 8));
  cases.push_back(BrightScene(96).strips(6, 0.4, 0.05, 20).with("strips", 16));
  cases.push_back(BrightScene(96).strips(6, 0.4, 0.05, 20).wall(diffuse).with("strips on a wall", 16));
  cases.push_back(BrightScene(64).strips(5, 1, 0.07, 10).wall(diffuse).with("strips, 8 samples", 8));
  cases.push_back(BrightScene(64).strips(5, 0.4, 0.05, 20).with("strips, 1024 samples", 1024));
  cases.push_back(BrightScene(128).lamp(64, 64, 100, 0.6, 0.3, 5).with("a line on black", 32));
  // Both long edges cover 1 % of a row of pixels.
  cases.push_back(BrightScene(96).lamp(48, 48, 60, 20.02, 0, 6.4).with("hardly touched rows", 32, 0.012F));
  // Bright by chance would be as frequent elsewhere.
  cases.push_back(BrightScene(64).lamp(55.2, 11.9, 2.6, 2, 0.7, 30).with("a lamp of six pixels", 4));
  cases.push_back(BrightScene(96).lamps(6, 16, 12, 0.8, 0.5, 20).wall(diffuse).with("dots", 32));
  cases.push_back(BrightScene(96).lamps(5, 17.7, 16, 3.5, 0, 8).with("corners at tile borders", 16));
  cases.push_back(BrightScene(64).lamps(3, 17.7, 16, 3.5, 0, 8).wall(diffuse).with("corners on a wall", 64));
  cases.push_back(
      BrightScene(64).ball(20, 30, 15, glossy).ball(45, 40, 10, glossy).wall(diffuse).with("highlights", 16));
  cases.push_back(
      BrightScene(96).ball(40, 50, 30, glossy).lamp(80, 20, 8, 8, 0.4, 30).with("highlights on black", 32));
  cases.push_back(BrightScene(256).lamp(128, 128, 90, 60, 0.4, 15).with("a lamp on black", 16));
  cases.push_back(BrightScene(512).strips(8, 0.8, 0.03, 10).wall(diffuse).with("512 pixels", 4));
  cases.push_back(BrightScene(64).wall(diffuse).with("a wall", 16));
  return cases;
}

/// Renders a scene with this many seeds, and with four times as many if the fraction of true errors within
/// intervals is near the required minimum: with a coverage of 92 %, 100 seeds often show less than 88 %.
test::ErrorStudy study_of(const test::ErrorCase& tested, int seeds) {
  test::ErrorStudy study;
  test::study_intervals(tested.scene, seeds, tested.samples, study);
  if (study.coverage() >= 0.92) return study;
  test::ErrorStudy longer;
  test::study_intervals(tested.scene, 4 * seeds, tested.samples, longer);
  return longer;
}

TEST(ErrorEstimate, HoldsWithLampsInView) {
  const int seeds = static_cast<int>(from_environment("ERROR_SEEDS", 100));
  const unsigned first = from_environment("ERROR_SCENES", std::random_device()() % 1'000'000);
  std::vector<test::ErrorCase> cases = chosen_cases();
  const std::size_t chosen = cases.size();
  for (unsigned i = 0; i < chosen; ++i) cases.push_back(test::random_case(first + i));
  EXPECT_GE(cases.size(), 40U);
  double coverage = 0;
  double quotient = 0;
  for (const test::ErrorCase& tested : cases) {
    const test::ErrorStudy own = study_of(tested, seeds);
    print_study(tested.scene.name, own);
    EXPECT_GE(own.coverage(), 0.88) << tested.scene.name << "; ERROR_SCENES=" << first;
    coverage += own.coverage() / static_cast<double>(cases.size());
    quotient += own.mean_quotient() / static_cast<double>(cases.size());
  }
  std::printf("all: inside %.1f %%, stated / true %.2f\n", 100 * coverage, quotient);
  EXPECT_GE(coverage, 0.93) << "ERROR_SCENES=" << first;
  EXPECT_LE(coverage, 0.97) << "ERROR_SCENES=" << first;
  EXPECT_GT(quotient, 0.95) << "ERROR_SCENES=" << first;
  EXPECT_LT(quotient, 1.1) << "ERROR_SCENES=" << first;
}

TEST(TargetError, HoldsOver200SeedsOfFourScenes) {
  test::ErrorStudy all;
  const int seeds = static_cast<int>(from_environment("ERROR_SEEDS", 200));
  for (const test::SampleScene& scene : test::error_scenes()) {
    test::ErrorStudy own;
    test::study_errors(scene, seeds, 64, own);
    print_study(scene.name, own);
    all += own;
  }
  EXPECT_GE(all.coverage(), 0.93);
  EXPECT_GT(all.stated_over_true(), 0.87);
  EXPECT_LT(all.stated_over_true(), 1.3);
  EXPECT_LE(all.missed_fraction(), 0.07);
}

/// A room of random walls, lit by the one behind the eye, and open at a random side or at none.
test::SampleScene random_room(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::string text = fmt::format("light begin rgb ({0},{0},{0}) ({1},{2},0.99) (0,0.5,0) (0.5,0,0) end ",
                                 uniform(1, 10), uniform(-0.9, 0.4), uniform(-0.9, 0.4));
  const std::array walls = {"(-1,-1,1) (1,-1,1) (1,-1,-1) (-1,-1,-1)", "(-1,1,-1) (1,1,-1) (1,1,1) (-1,1,1)",
                            "(-1,-1,1) (-1,-1,-1) (-1,1,-1) (-1,1,1)", "(1,-1,-1) (1,-1,1) (1,1,1) (1,1,-1)",
                            "(-1,-1,-1) (1,-1,-1) (1,1,-1) (-1,1,-1)", "(1,-1,1) (-1,-1,1) (-1,1,1) (1,1,1)"};
  const auto open = static_cast<std::size_t>(uniform(0, 8));
  for (std::size_t wall = 0; wall < walls.size(); ++wall) {
    if (wall == open) continue;
    const std::string brdf = uniform(0, 1) < 0.3
                                 ? fmt::format("brdf ward sx={0} sy={0} ks=0.4 kd=0.4", uniform(0.1, 0.4))
                                 : fmt::format("brdf diffuse kd={}", uniform(0.3, 0.9));
    const std::string colour =
        fmt::format(" rgb ({},{},{})", uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1));
    text += test::quad(brdf + colour, walls[wall]);
  }
  test::RenderSetup setup;
  setup.eye = transport::Vec3f(0, 0, 0.95F);
  setup.field_of_view = 80;
  setup.width = 48;
  setup.height = 32;
  setup.depth = 3 + static_cast<int>(seed % 12);
  setup.background = open < walls.size() ? static_cast<float>(uniform(0.1, 2)) : 0;
  return {fmt::format("room {}", seed), test::scene_of(text), test::settings_of(setup)};
}

/// Studies renders that stop at a target error, with paths that are truncated for it, against images of all
/// bounces.
void study_truncated(const test::SampleScene& scene, double target, int seeds, test::ErrorStudy& study,
                     double& mean_depth) {
  constexpr int Samples = 64;
  test::ErrorStudy of_all_bounces;
  const test::StudiedScene studied = test::study_intervals(scene, seeds, Samples, of_all_bounces);
  transport::RenderSettings settings = scene.settings;
  settings.samples = transport::RenderSettings::Unlimited;
  settings.target_error = target;
  for (int seed = 0; seed < seeds; ++seed) {
    settings.seed = static_cast<std::uint32_t>(1'000'000 + seed);
    transport::RenderSettings truncated = settings;
    const auto truncations = truncations_of(scene.scene, settings);
    if (const auto truncation = truncation_for(truncations, target)) follow(*truncation, truncated);
    mean_depth += truncated.integrator.depth / static_cast<double>(seeds);
    transport::Render render(scene.scene, truncated);
    render.run();
    const double share = render.samples_per_pixel() / Samples;
    const double error = std::sqrt(studied.images.relmse(render.film().mean(), false, share));
    const transport::ErrorEstimate stated = *render.error_estimate();
    ++study.runs;
    study.inside += error >= stated.low && error <= stated.high ? 1 : 0;
    study.above += error > stated.high ? 1 : 0;
    study.quotients += stated.error / error;
    study.widths += stated.high / stated.low;
    ++study.stopped;
    study.missed += error > transport::RenderSettings::ErrorMargin * target ? 1 : 0;
  }
}

TEST(TargetError, HoldsWithTruncatedPaths) {
  const int seeds = static_cast<int>(from_environment("ERROR_SEEDS", 50));
  const unsigned first = from_environment("ERROR_SCENES", std::random_device()() % 1'000'000);
  std::vector<test::SampleScene> scenes = test::error_scenes();
  for (unsigned i = 0; i < 12; ++i) scenes.push_back(random_room(first + i));
  test::ErrorStudy all;
  int truncated = 0;
  for (const test::SampleScene& scene : scenes) {
    for (const double target : {0.1, 0.05}) {
      test::ErrorStudy own;
      double depth = 0;
      study_truncated(scene, target, seeds, own, depth);
      print_study(fmt::format("{} {} depth {:.1f} of {}", scene.name.substr(scene.name.rfind('/') + 1),
                              target, depth, scene.settings.integrator.depth),
                  own);
      truncated += depth < scene.settings.integrator.depth ? 1 : 0;
      all += own;
    }
  }
  print_study("all", all);
  EXPECT_GE(truncated, 16) << "few scenes were truncated";
  EXPECT_GE(all.coverage(), 0.93) << "ERROR_SCENES=" << first;
  EXPECT_LE(all.missed_fraction(), 0.05) << "ERROR_SCENES=" << first;
}

// With probability 1/1,000, one of 144 blocks is off by 4.5 standard deviations.
TEST(AdaptiveSampling, HasTheMeanOfUniformSamplingOver1000Renders) {
  EXPECT_LT(test::largest_difference(test::caustic_scene(), 64, 1000), 4.5);
  EXPECT_LT(test::largest_difference(test::sun_scene(), 64, 1000), 4.5);
}

}  // namespace
