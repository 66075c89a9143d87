// White furnace test: no model reflects more than it receives, unless its table declares it. promises_test
// covers those.
#include <gtest/gtest.h>

#include "renderer/reflectance/presets.h"
#include "tests/reflectance/albedo.h"

namespace {

class Furnace : public testing::TestWithParam<std::string> {};

TEST_P(Furnace, GivesBackAtMostWhatComesIn) {
  const auto brdf = test::brdf_of(GetParam());
  for (const double angle : {0.0, 30.0, 60.0, 80.0, 88.0}) {
    const auto u = test::direction(angle, 25);
    const auto dirac =
        std::visit([&](const auto& model) { return reflectance::specular_weight(model, u); }, brdf);
    EXPECT_LT(test::albedo(brdf, u, 1e-6) + dirac.x, 1.002) << angle;
  }
}

std::vector<std::string> conserving_cases() {
  std::vector<std::string> cases = test::plain_cases();
  std::erase_if(cases, [](const std::string& text) {
    return !test::info_of(test::brdf_of(text)).not_conserving.empty();
  });
  return cases;
}

/// The library's materials that are not the thesis', whose tables reflect more than they receive.
std::vector<std::string> presets() {
  std::vector<std::string> texts;
  for (const reflectance::PresetTable& table : reflectance::preset_tables()) {
    if (table.title.starts_with("Thesis")) continue;
    for (const reflectance::Preset& preset : table.presets) texts.emplace_back(preset.brdf);
  }
  return texts;
}

INSTANTIATE_TEST_SUITE_P(Presets, Furnace, testing::ValuesIn(presets()));
INSTANTIATE_TEST_SUITE_P(Cases, Furnace, testing::ValuesIn(conserving_cases()));

}  // namespace
