#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/cli/bpt.h"

namespace {

using test::Outcome;

/// Makes a grey image with one row.
std::string grey_pfm(const std::vector<float>& values) {
  std::string file = "Pf\n" + std::to_string(values.size()) + " 1\n-1.0\n";
  for (const float value : values) file.append(reinterpret_cast<const char*>(&value), sizeof(value));
  return file;
}

class BptCompare : public test::Bpt {
 protected:
  std::string image_ = write("a.pfm", grey_pfm({1.5F, 2, 0.5F}));
  std::string reference_ = write("b.pfm", grey_pfm({1, 2, 0}));

  void expect_error(const std::string& a, const std::string& b, const std::string& message) const {
    for (const bool json : {false, true}) {
      std::vector<std::string> arguments = {"compare", a, b};
      if (json) arguments.emplace_back("--json");
      const Outcome outcome = bpt(arguments);
      EXPECT_EQ(outcome.exit_code, 1);
      EXPECT_EQ(outcome.out, "");
      EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    }
  }
};

TEST_F(BptCompare, GivesTheNumbersThatScriptsRelyOn) {
  const Outcome outcome = bpt({"compare", image_, reference_, "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::ordered_json::parse(outcome.out);
  std::vector<std::string> names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"rmse", "relmse", "average_relative_error", "psnr", "max",
                                             "nan_pixels", "fireflies", "visible_difference"}));
  EXPECT_NEAR(json["rmse"].get<double>(), std::sqrt(0.5 / 3), 1e-9);
  EXPECT_NEAR(json["relmse"].get<double>(), (0.25 / 1.01 + 0.25 / 0.01) / 3, 1e-9);
  EXPECT_NEAR(json["average_relative_error"].get<double>(), 0.25, 1e-9);
  EXPECT_NEAR(json["psnr"].get<double>(), 10 * std::log10(4 / (0.5 / 3)), 1e-9);
  EXPECT_EQ(json["max"], 0.5);
  EXPECT_EQ(json["nan_pixels"], 0);
}

TEST_F(BptCompare, PrintsATableForPeople) {
  const Outcome outcome = bpt({"compare", image_, reference_});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, testing::StartsWith("  rmse                    0.408248\n"
                                               "  relmse                  8.41584\n"
                                               "  average relative error  25 %\n"
                                               "  psnr                    13.8 dB\n"
                                               "  max                     0.5\n"
                                               "  pixels that are NaN     0\n"
                                               "  fireflies               0\n"
                                               "  visible difference      mean "));
}

// Greys of one colour differ only in lightness: by dL / S_L of CIEDE2000, with L = 116 Y^(1/3) - 16.
TEST_F(BptCompare, TellsWhatTheEyeSees) {
  const std::string one = write("one.pfm", grey_pfm(std::vector<float>(50, 0.2F)));
  const std::string other = write("other.pfm", grey_pfm(std::vector<float>(50, 0.22F)));
  const auto lightness = [](double y) { return 116 * std::cbrt(y) - 16; };
  const auto difference = [&](double y, double z) {
    const double middle = std::pow((lightness(y) + lightness(z)) / 2 - 50, 2);
    return std::abs(lightness(y) - lightness(z)) / (1 + 0.015 * middle / std::sqrt(20 + middle));
  };
  const auto plain = nlohmann::json::parse(bpt({"compare", one, other, "--json"}).out)["visible_difference"];
  EXPECT_NEAR(plain["mean"].get<double>(), difference(0.2, 0.22), 1e-3);
  EXPECT_NEAR(plain["percentile_95"].get<double>(), difference(0.2, 0.22), 1e-3);
  EXPECT_EQ(plain["pixels_per_degree"], 40);
  EXPECT_EQ(plain["exposure"], 0);
  const auto brighter = nlohmann::json::parse(
      bpt({"compare", one, other, "--json", "--exposure", "2", "--pixels-per-degree", "20"})
          .out)["visible_difference"];
  EXPECT_NEAR(brighter["mean"].get<double>(), difference(0.8, 0.88), 1e-3);
  EXPECT_EQ(brighter["pixels_per_degree"], 20);
  EXPECT_EQ(bpt({"compare", one, other, "--pixels-per-degree", "0"}).exit_code, 2);
}

TEST_F(BptCompare, SaysNothingWhereThereIsNoNumber) {
  const auto json = nlohmann::json::parse(bpt({"compare", image_, image_, "--json"}).out);
  EXPECT_EQ(json["rmse"], 0);
  EXPECT_TRUE(json["psnr"].is_null());
  const std::string black = write("black.pfm", grey_pfm({0, 0, NAN}));
  const auto of_black = nlohmann::json::parse(bpt({"compare", image_, black, "--json"}).out);
  EXPECT_TRUE(of_black["average_relative_error"].is_null());
  EXPECT_EQ(of_black["nan_pixels"], 1);
}

TEST_F(BptCompare, ReadsImagesOfAnyType) {
  const std::string scene = write("scene.grf", test::Quad);
  ASSERT_EQ(bpt({"render", scene, "--size", "8x8", "--samples", "1", "--output", path("c.exr"), "--output",
                 path("c.hdr"), "--output", path("c.png")})
                .exit_code,
            0);
  for (const char* other : {"c.hdr", "c.png"}) {
    const Outcome outcome = bpt({"compare", path(other), path("c.exr"), "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_LT(nlohmann::json::parse(outcome.out)["rmse"].get<double>(), 0.01);
  }
}

TEST_F(BptCompare, SaysWhatCannotBeCompared) {
  expect_error(
      image_, write("c.pfm", grey_pfm({1, 2})),
      image_ + ": error: the image has 3 x 1 pixels, expected 2 x 1 as '" + path("c.pfm") + "' has\n");
  expect_error(path("none.exr"), reference_, path("none.exr") + ": error: cannot read the file");
  expect_error(image_, write("broken.png", "\x89PNG and no more"),
               path("broken.png") + ": error: cannot read");
  expect_error(image_, write("nan.pfm", grey_pfm({NAN, NAN, INFINITY})), "no pixel is finite both here and");
  EXPECT_EQ(bpt({"compare", image_}).exit_code, 2);
  EXPECT_EQ(bpt({"compare", image_, reference_, "--jsno"}).exit_code, 2);
}

}  // namespace
