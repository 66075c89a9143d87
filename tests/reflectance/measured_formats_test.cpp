// Files of measured BRDFs other than those of MERL and RGL: what they are worth, and what is wrong with them.
// The files and values are made by measured_files.py from the published descriptions of the formats.
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/measured.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/rgl_cases.h"
#include "tests/support/temporary_folder.h"

namespace {

using Imath::V3d;
using reflectance::Measured;
using reflectance::MeasuredData;
using testing::HasSubstr;

constexpr std::size_t UtiaCount = 3 * 288 * 288;

/// Makes a file of the UTIA data base of what each index of it has.
template <class Number>
std::string utia_bytes(const Number& number) {
  std::string bytes;
  for (std::size_t i = 0; i < UtiaCount; ++i) {
    const double value = number(i);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  return bytes;
}

class MeasuredFormats : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  grf::Diagnostics diagnostics_;

  std::shared_ptr<const MeasuredData> load(const std::string& name, const std::string& bytes) {
    diagnostics_ = {};
    return Measured::load(folder_.add(name, bytes), diagnostics_, {});
  }
  /// Expects an error at a line and column, or of the whole file, with a text in it.
  void expect_error(const std::string& name, const std::string& bytes, const std::string& place,
                    const std::string& message) {
    EXPECT_EQ(load(name, bytes), nullptr) << message;
    EXPECT_EQ(diagnostics_.error_count(), 1U);
    EXPECT_THAT(diagnostics_.to_text(), HasSubstr(name + place + " error: "));
    EXPECT_THAT(diagnostics_.to_text(), HasSubstr(message));
  }
  /// Returns the text of a file of measured/, with a part of it replaced.
  static std::string changed(const std::string& name, const std::string& part, const std::string& by) {
    grf::Diagnostics diagnostics;
    std::string text = *grf::read_file(test::measured_path(name), diagnostics);
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), by);
  }
};

V3d vector_of(const nlohmann::json& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

TEST_F(MeasuredFormats, HaveTheValuesOfTheirDescriptions) {
  std::ifstream file(test::measured_path("values.json"));
  std::map<std::string, std::shared_ptr<const MeasuredData>> data;
  // The number at an index, as in the script.
  data["utia"] =
      load("a.bin", utia_bytes([](std::size_t i) { return 0.05 + double(i * 7919 % 100003) / 100003; }));
  std::map<std::string, int> counts;
  for (const nlohmann::json& entry : nlohmann::json::parse(file)) {
    const std::string name = entry["file"];
    ++counts[name];
    if (!data[name]) data[name] = Measured::load(test::measured_path(name), diagnostics_, {});
    ASSERT_NE(data[name], nullptr) << name << diagnostics_.to_text();
    const V3d value(data[name]->value(vector_of(entry["view"]), vector_of(entry["light"]), true));
    EXPECT_LT((value - vector_of(entry["value"])).length(), 2e-6) << entry << " is " << value;
  }
  EXPECT_EQ(counts.size(), 7U);
}

TEST_F(MeasuredFormats, AreAnisotropicIfTheirDataAre) {
  for (const auto& [name, is_anisotropic] :
       {std::pair("zemax.bsdf", false), std::pair("lighttools.bsdf", false), std::pair("degrees.astm", false),
        std::pair("scattered.csv", true)}) {
    EXPECT_EQ(is_anisotropic, reflectance::is_anisotropic(test::brdf_of("measured " + std::string(name))))
        << name;
  }
  EXPECT_TRUE(reflectance::is_anisotropic(test::brdf_of("utia of diffuse")));
}

TEST_F(MeasuredFormats, AreFoundByContent) {
  for (const char* name : {"zemax.bsdf", "lighttools.bsdf", "degrees.astm", "scattered.csv"}) {
    const auto data = load("a.txt", changed(name, "0.1", "0.1"));
    EXPECT_NE(data, nullptr) << name << diagnostics_.to_text();
  }
  expect_error("a.txt", "no data", ":",
               "the formats that are read are MERL, UTIA, Zemax, LightTools, ASTM E1392, CSV");
  expect_error("a.bsdf", "tensor_file\0", ":", "which the BRDF 'rgl' reads");
}

TEST_F(MeasuredFormats, OfScattersInterpolateThroughTheirValuesInBothOrders) {
  // Values that are all the same are so everywhere.
  const auto data =
      load("a.csv", "theta_u,phi_u,theta_v,phi_v,r,g,b\n0.1,0,0.2,1,3,2,1\n0.5,0,0.9,3,3,2,1\n");
  ASSERT_NE(data, nullptr);
  for (const auto& [u, v] : test::direction_pairs(100, 5)) {
    if (u.z <= 0 || v.z <= 0) continue;
    EXPECT_LT((V3d(data->value(V3d(u), V3d(v), true)) - V3d(3, 2, 1)).length(), 1e-5);
    EXPECT_LT((V3d(data->value(V3d(u), V3d(v), false)) - V3d(3, 2, 1)).length(), 1e-5);
  }
  const V3d near(0, 0, 1);
  EXPECT_EQ(data->state(near, near), reflectance::DataState::Missing);
  EXPECT_EQ(data->state(V3d(std::sin(0.1), 0, std::cos(0.1)),
                        V3d(std::sin(0.2) * std::cos(1), std::sin(0.2) * std::sin(1), std::cos(0.2))),
            reflectance::DataState::Sound);
}

TEST_F(MeasuredFormats, WeighValuesOfTheSamePlace) {
  const std::string names = "ux,uy,uz,vx,vy,vz,value,";
  const auto weighed =
      load("a.csv", names + "weight\n0,0,1,0,0,1,1,3\n0,0,1,0,0,1,2,1\n0.6,0,0.8,0,0,1,9,1\n");
  EXPECT_NEAR(weighed->value({0, 0, 1}, {0, 0, 1}, true).x, 1.25, 1e-6);
  const auto deviating =
      load("a.csv", names + "deviation\n0,0,1,0,0,1,1,1\n0,0,1,0,0,1,2,2\n0.6,0,0.8,0,0,1,9,1\n");
  EXPECT_NEAR(deviating->value({0, 0, 1}, {0, 0, 1}, true).x, (1 + 2 / 4.0) / (1 + 1 / 4.0), 1e-6);
}

TEST_F(MeasuredFormats, TakeNegativeValuesForZeroAndSaySo) {
  const auto data = load("a.bin", utia_bytes([](std::size_t) { return -0.25; }));
  ASSERT_NE(data, nullptr);
  EXPECT_EQ(data->value({0, 0, 1}, {0, 0, 1}, true), reflectance::Rgb(0));
  EXPECT_EQ(data->state({0, 0, 1}, {0, 0, 1}), reflectance::DataState::Negative);
  const auto listed = load("a.csv", "theta_u,phi_u,theta_v,phi_v,value\n0,0,0,0,1\n0.1,0,0,0,-1\n");
  ASSERT_NE(listed, nullptr);
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("a.csv:3:1: warning: 1 of 2 values are negative"));
  ASSERT_NE(load("a.csv", "theta_u,phi_u,theta_v,phi_v,value\n0,0,0,0,1\n0.1,0,0,0,1e53\n"), nullptr);
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("a.csv:3:1: warning: 1 of 2 values are not finite"));
}

TEST_F(MeasuredFormats, OfUtiaSayWhatIsWrong) {
  const std::string broken =
      utia_bytes([](std::size_t i) { return i == 1000 ? std::numeric_limits<double>::quiet_NaN() : 1.0; });
  expect_error("a.bin", broken, ":", "the number at byte 8000 is nan");
  expect_error("a.bin", broken.substr(1), ":", "is no file of measured data");
}

TEST_F(MeasuredFormats, OfZemaxSayWhatIsWrong) {
  const auto expect = [&](const char* part, const char* by, const std::string& place, const char* message) {
    expect_error("a.bsdf", changed("zemax.bsdf", part, by), place, message);
  };
  expect("BRDF", "BTDF", ":5:14:", "'BTDF' is no reflection");
  expect("PlaneSymmetrical", "Round", ":3:11:", "unknown symmetry 'Round'");
  expect("0 60 120 180", "0 60 60 180", ":11:6:", "the angles of ScatterAzimuth are not ascending");
  expect("0 60 120 180", "0 60 120 190",
         ":13:11:", "azimuths of plane-symmetrical data are over 180 degrees");
  expect("ScatterAzimuth 4", "ScatterAzimuth 0", ":10:16:", "'ScatterAzimuth' has 0 angles");
  expect("ScatterAzimuth 4", "ScatterAzimuth 5", ":12:1:", "'ScatterRadial' is no finite number");
  expect("SampleRotation  1\n0", "SampleRotation  2\n0 30", ":13:11:", "the sample has 2 rotations");
  expect("TIS", "SIT", ":17:1:", "unexpected 'SIT'");
  expect("0.5\n0.25", "0.5\nx", ":18:1:", "'x' is no finite number, for a value");
  expect("Monochrome\nDataBegin", "DataBegin", ":16:1:", "data precede Monochrome");
  expect("0 20 45 70", "0 20 45 95", ":9:9:", "an angle of AngleOfIncidence is 95, expected 0 to 90");
  expect_error("a.bsdf", "AngleOfIncidence 1\n0\nSource", ":3:7:", "the file ends after 'Source'");
  const std::string text = changed("zemax.bsdf", "TIS", "TIS");
  expect_error("a.bsdf", text.substr(0, text.rfind("TIS")),
               ":32:1:", "values of an angle of incidence are missing");
  expect_error("a.bsdf", text + "TIS 0.5\n",
               ":38:1:", "there are more blocks of values than angles of incidence");
  expect_error("a.bsdf", text.substr(0, text.size() - 20), ":36:32:", "the file ends before a value");
}

TEST_F(MeasuredFormats, OfLightToolsSayWhatIsWrong) {
  const auto expect = [&](const char* part, const char* by, const std::string& place, const char* message) {
    expect_error("a.bsdf", changed("lighttools.bsdf", part, by), place, message);
  };
  expect("AOI 65", "AOI 40", ":29:5:", "the angle of incidence 40 is repeated");
  expect("AOI 65", "AOI 91", ":14:5:", "the angle of incidence is 91, expected 0 to 90");
  expect("POI 0", "POI 90", ":25:5:", "there are several planes of incidence");
  expect("ScatterRadial 6", "ScatterRadial 7",
         ":8:1:", "'DataBegin' is no finite number, for an angle of ScatterRadial");
  expect("ScatterType BRDF", "ScatterKind BRDF", ":13:1:", "unexpected 'ScatterKind'");
  Measured::load(test::measured_path("lighttools.bsdf"), diagnostics_, {});
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("1 block of transmission or of the back"));
}

TEST_F(MeasuredFormats, OfAstmSayWhatIsWrong) {
  const std::string names = "SAMPLE x\nVARS theta_i,phi_i,theta_s,phi_s,";
  expect_error("a.astm", "VARS theta_i,phi_i,theta_s,BRDF\n", ":1:1:", "VARS lacks one of the angles");
  expect_error("a.astm", "VARS theta_i,theta_i,theta_s,BRDF\n", ":1:14:", "the column 'theta_i' is repeated");
  expect_error("a.astm", names + "Q,U\n", ":2:1:", "the columns of values are 'Q,U', expected one");
  expect_error("a.astm", names + "550nm,450nm\n", ":2:1:", "ascending wavelengths");
  expect_error("a.astm", names + "BRDF\n0,0,0,0,1\n0,0,0,0\n",
               ":4:7:", "the line has 4 values, and VARS names 5");
  expect_error("a.astm", names + "BRDF\n0,0,0,zero,1\n", ":3:7:", "'zero' is no number");
  expect_error("a.astm", names + "BRDF\n", ":", "the file has no value that can be used");
}

TEST_F(MeasuredFormats, OfCsvHaveUnitsAndOtherNames) {
  const auto data = load("a.csv", "theta_i_deg,phi_i_deg,theta_o,phi_o,value\n60,90,0.5,1,0.25\n");
  ASSERT_NE(data, nullptr) << diagnostics_.to_text();
  EXPECT_EQ(data->state({std::sin(0.5) * std::cos(1), std::sin(0.5) * std::sin(1), std::cos(0.5)},
                        {0, std::sqrt(0.75), 0.5}),
            reflectance::DataState::Sound);
  expect_error("a.csv", "theta_i,phi_i,theta_o,phi_o,value\n0,0,0,0,?\n", ":2:9:", "'?' is no number");
}

// In a scene the data are named as those of MERL are.
TEST_F(MeasuredFormats, AreNamedInAScene) {
  grf::BrdfModel model;
  model.keyword = "measured";
  model.data_file = test::measured_path("zemax.bsdf");
  EXPECT_TRUE(reflectance::BrdfMaker(diagnostics_).make(model, {})) << diagnostics_.to_text();
}

}  // namespace
