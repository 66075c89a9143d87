// The comparison of materials with Cycles, if Blender is installed.
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/benchmarks/render/materials.h"
#include "tests/benchmarks/render/renderers.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

using benchmark::Masking;
using benchmark::Material;
using benchmark::mean_in_white;

const Material& material_of(const std::string& name) {
  for (const Material& material : benchmark::materials()) {
    if (material.name == name) return material;
  }
  throw std::invalid_argument(name);
}

test::Outcome compare(const std::string& folder, const std::vector<std::string>& options) {
  std::vector<std::string> command = {GRANADA_BIN_DIR "/material_comparison", "--folder", folder};
  command.insert(command.end(), options.begin(), options.end());
  return test::run(command);
}

TEST(CyclesMaterials, AgreeWithBpt) {
  if (!benchmark::blender_version()) GTEST_SKIP() << "Blender is not installed";
  const test::TemporaryFolder folder;
  const test::Outcome outcome = compare(folder.path("run"), {});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST(CyclesMaterials, FailIfTheyDiffer) {
  if (!benchmark::blender_version()) GTEST_SKIP() << "Blender is not installed";
  const test::TemporaryFolder folder;
  const test::Outcome outcome = compare(
      folder.path("run"), {"--scale-tolerances", "0.001", "--materials", "glass on red", "--size", "32"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
}

// Smooth facets reflect what Fresnel's equations say: the mean for glass is the integral of these over the
// disc, from 0.04 in its centre to 0.0811 at 0.85 of its radius.
TEST(CyclesMaterials, KnowTheMeanOfSmoothSpheres) {
  EXPECT_NEAR(mean_in_white(material_of("white metal single"), 0.05, Masking::HeightCorrelated), 1, 1e-3);
  EXPECT_NEAR(mean_in_white(material_of("white metal"), 1, Masking::HeightCorrelated), 1, 1e-12);
  EXPECT_NEAR(mean_in_white(material_of("glass single"), 0.05, Masking::HeightCorrelated), 0.04868, 1e-4);
}

// With alpha = 1, the distribution of facets is 1 / pi, and G1(c) = 2 c / (1 + c). So the albedo at the
// cosine c is 1 - c log(1 + 1 / c) with height-correlated masking, and 2 (1 - log 2) / (1 + c) with separable
// masking. The means over the disc of radius 0.85 are integrals of these by c^2.
TEST(CyclesMaterials, KnowBothWaysOfMasking) {
  const Material& metal = material_of("white metal single");
  constexpr double Area = 0.85 * 0.85;
  const double log2 = std::log(2);
  const double least = std::sqrt(1 - Area);
  const auto correlated = [](double c) {
    return c * c * c / 3 * std::log(1 + 1 / c) + (c * c / 2 - c + std::log(1 + c)) / 3;
  };
  const auto separable = [](double c) { return c - std::log(1 + c); };
  EXPECT_NEAR(mean_in_white(metal, 1, Masking::HeightCorrelated),
              1 - 2 / Area * (correlated(1) - correlated(least)), 1e-4);
  EXPECT_NEAR(mean_in_white(metal, 1, Masking::Separable),
              4 * (1 - log2) / Area * (separable(1) - separable(least)), 1e-4);
}

}  // namespace
