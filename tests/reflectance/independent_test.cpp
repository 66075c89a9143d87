// All models against values and albedos of an independent program: independent_values.py, which has the
// papers' formulas and its own quadrature.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/reflectance/albedo.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

namespace {

using Imath::V3d;
using nlohmann::json;
using reflectance::Brdf;
using reflectance::Rgb;
using reflectance::Vec3f;

const json& independent_table() {
  static const json table =
      json::parse(std::ifstream(GRANADA_SOURCE_DIR "/tests/reflectance/independent_values.json"));
  return table;
}

/// Reads a grey value as one number.
V3d channels_of(const json& value) {
  if (value.is_number()) return V3d(value.get<double>());
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

template <class Vector>
void expect_channels(const Vector& actual, const V3d& expected, double tolerance, const std::string& where) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(double(actual[k]), expected[k], tolerance * expected[k] + 1e-12) << "channel " << k << where;
  }
}

class Independent : public testing::TestWithParam<std::size_t> {
 protected:
  double tolerance() const {
    const std::string text = instance_["brdf"];
    if (text.find(" over ") != std::string::npos) return 0.02;  // a table of samples is between the layers
    return text.find("film") != std::string::npos ? 1e-5
                                                  : 1e-6;  // the weights of wavelengths have seven digits
  }

  const json& instance_ = independent_table()["instances"][GetParam()];
  const Brdf brdf_ = test::brdf_of(instance_["brdf"].get<std::string>());
};

TEST_P(Independent, HasTheValuesOfThePaper) {
  const json& pairs = independent_table()["pairs"];
  ASSERT_EQ(instance_["values"].size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const V3d u = test::direction_in_double(pairs[i][0], pairs[i][1]);
    const V3d v = test::direction_in_double(pairs[i][2], pairs[i][3]);
    const V3d value = std::visit([&](const auto& model) { return model.evaluate(u, v); }, brdf_);
    const V3d expected = channels_of(instance_["values"][i]);
    expect_channels(value, expected, tolerance(), " at " + pairs[i].dump());
    expect_channels(evaluate(brdf_, Vec3f(u), Vec3f(v)), expected, std::max(1e-3, tolerance()),
                    " in float at " + pairs[i].dump());
  }
}

TEST_P(Independent, HasTheMirrorPartOfThePaper) {
  const json& pairs = independent_table()["pairs"];
  EXPECT_EQ(has_specular_part(brdf_), instance_.contains("mirrors"));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const V3d expected = instance_.contains("mirrors") ? channels_of(instance_["mirrors"][i]) : V3d(0);
    const Vec3f u(test::direction_in_double(pairs[i][0], pairs[i][1]));
    expect_channels(specular_weight(brdf_, u), expected, 1e-4, " at " + pairs[i].dump());
  }
}

TEST_P(Independent, HasTheAlbedoOfAnotherQuadrature) {
  const reflectance::Reflector reflector(brdf_, reflectance::OwnScheme());
  for (const json& one : instance_["albedos"]) {
    const Vec3f u(test::direction_in_double(one["view"][0], one["view"][1]));
    const V3d expected = channels_of(one["albedo"]);
    const Rgb sampled = reflectance::albedo(reflector, u, 16384);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(double(sampled[k]), expected[k], 2e-3 * std::max(0.5, expected[k])) << k << one["view"];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Instances, Independent,
                         testing::Range(std::size_t(0), independent_table()["instances"].size()),
                         [](const testing::TestParamInfo<std::size_t>& instance) {
                           const std::string text = independent_table()["instances"][instance.param]["brdf"];
                           return text.substr(0, text.find(' ')) + "_" + std::to_string(instance.index);
                         });

/// Writes a file whose cells encode their own index, as the data base publishes it: each channel has one of
/// the cell's three indices, plus 1.
std::string merl_file_of_places() {
  const std::array<std::int32_t, 3> dimensions = {90, 90, 180};
  std::vector<double> cells(3 * 90 * 90 * 180);
  for (std::size_t half = 0; half < 90; ++half) {
    for (std::size_t difference = 0; difference < 90; ++difference) {
      for (std::size_t azimuth = 0; azimuth < 180; ++azimuth) {
        const std::size_t index = azimuth + 180 * (difference + 90 * half);
        cells[index] = 1500 * static_cast<double>(half + 1);
        cells[index + 1'458'000] = 1500 / 1.15 * static_cast<double>(difference + 1);
        cells[index + 2'916'000] = 1500 / 1.66 * static_cast<double>(azimuth + 1);
      }
    }
  }
  std::string bytes(reinterpret_cast<const char*>(dimensions.data()), sizeof(dimensions));
  return bytes.append(reinterpret_cast<const char*>(cells.data()), cells.size() * sizeof(double));
}

TEST(IndependentTable, HasThePlacesOfPairsInMeasuredData) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  const auto table = reflectance::MerlTable::load(folder.add("a.binary", merl_file_of_places()), diagnostics);
  ASSERT_NE(table, nullptr) << diagnostics.to_text();
  reflectance::Measured measured;
  measured.data = std::make_shared<const reflectance::MeasuredData>(table);
  int compared = 0;
  for (std::size_t i = 0; i < independent_table()["pairs"].size(); ++i) {
    const json& pair = independent_table()["pairs"][i];
    const json& place = independent_table()["merl"][i];
    if (place.is_null() || place[2] < 1 || place[2] > 179) continue;  // phi_d is undefined, or wraps around
    const V3d u = test::direction_in_double(pair[0], pair[1]);
    const V3d v = test::direction_in_double(pair[2], pair[3]);
    const V3d places = channels_of(place);
    measured.linear = true;  // a cell's value is at its centre, half a cell in
    expect_channels(measured.evaluate(u, v), places + V3d(0.5), 1e-4, " at " + pair.dump());
    measured.linear = false;
    const V3d cell(std::floor(places.x), std::floor(places.y), std::floor(places.z));
    const V3d share = places - cell;
    if (std::min({share.x, share.y, share.z}) < 1e-3 || std::max({share.x, share.y, share.z}) > 1 - 1e-3)
      continue;
    expect_channels(measured.evaluate(u, v), cell + V3d(1), 1e-5, " in the cell at " + pair.dump());
    ++compared;
  }
  EXPECT_GE(compared, 15);
}

TEST(IndependentTable, HasFiveAlbedosOfEachModel) {
  std::map<std::string, std::size_t> counts;
  for (const json& instance : independent_table()["instances"]) {
    const std::string text = instance["brdf"];
    const bool is_layer = text.find(" over ") != std::string::npos && !text.starts_with("coat");
    counts[is_layer ? "layer" : text.substr(0, text.find(' '))] += instance["albedos"].size();
  }
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    const bool is_file_or_sum = model.argument_kind != grf::ModelInfo::ArgumentKind::Parameters &&
                                model.argument_kind != grf::ModelInfo::ArgumentKind::Layers;
    if (is_file_or_sum) continue;  // it has no formula
    EXPECT_GE(counts[std::string(model.keyword)], 5U) << model.keyword;
  }
}

}  // namespace
