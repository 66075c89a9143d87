// Tests of `bpt render --forecast`.
#include <array>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "tests/cli/bpt.h"

namespace {

class BptForecast : public test::Bpt {
 protected:
  nlohmann::json forecast(std::vector<std::string> more) const {
    more.insert(more.begin(), {"render", scene_, "--forecast", "--forecast-seconds", "0.4", "--json"});
    const test::Outcome outcome = bpt(more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }

  std::string scene_ = write("scene.grf", test::Quad);
};

TEST_F(BptForecast, TellsTheTimeUntilEachTarget) {
  const nlohmann::json report = forecast({"--size", "200x160", "--target-error", "0.03", "--threads", "2"});
  EXPECT_EQ(report["width"], 200);
  EXPECT_EQ(report["height"], 160);
  EXPECT_EQ(report["threads"], 2);
  EXPECT_EQ(report["frames"], 1);
  EXPECT_EQ(report["probability"], 0.9);
  EXPECT_GT(report["probe"]["samples"], 15);
  ASSERT_EQ(report["forecasts"].size(), 4U);
  const std::array targets = {0.05, 0.03, 0.02, 0.01};
  double before = 0;
  for (const std::size_t i : {0, 1, 2, 3}) {
    const nlohmann::json& one = report["forecasts"][i];
    EXPECT_NEAR(one["target_error"].get<double>(), targets[i], 1e-9);
    const auto seconds = one["seconds"].get<double>();
    EXPECT_GE(seconds, before);
    EXPECT_LE(one["seconds_interval"][0], seconds);
    EXPECT_GE(one["seconds_interval"][1], seconds);
    EXPECT_LE(one["samples_interval"][0], one["samples"]);
    before = seconds;
  }
  EXPECT_FALSE(std::filesystem::exists(path("scene.exr"))) << "no image is rendered";
}

TEST_F(BptForecast, HoldsForTheRender) {
  const nlohmann::json report = forecast({"--size", "200x160", "--target-error", "0.004"});
  const nlohmann::json& last = report["forecasts"].back();
  ASSERT_EQ(last["target_error"], 0.004);
  const test::Outcome outcome = bpt({"render", scene_, "--size", "200x160", "--target-error", "0.004",
                                     "--json", "--output", path("image.exr")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const double samples = nlohmann::json::parse(outcome.out)["samples"];
  // One time in ten the interval may be missed: not by another half of it.
  EXPECT_GE(samples, last["samples_interval"][0].get<double>() / 1.5);
  EXPECT_LE(samples, last["samples_interval"][1].get<double>() * 1.5);
}

TEST_F(BptForecast, TakesLongerForMorePixels) {
  const auto seconds = [&](const char* size) {
    return forecast({"--size", size})["forecasts"].back()["seconds"].get<double>();
  };
  const double small = seconds("160x120");
  const double large = seconds("1600x1200");
  EXPECT_GT(large, 20 * small);
  EXPECT_LT(large, 300 * small);
}

TEST_F(BptForecast, PrintsALinePerTarget) {
  const test::Outcome outcome =
      bpt({"render", scene_, "--size", "64x48", "--forecast", "--forecast-seconds", "0.2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* text :
       {"64x48 pixels", "error    5 %: ", "error    2 %: ", "error    1 %: ", "90 % probability"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << outcome.out;
  }
}

TEST_F(BptForecast, IsRefusedWhereSamplesAreNotRandom) {
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_Image_Resolution 32 24\nBPT_Integrator naive\n"
                               "BPT_Pixel_Radial true\n");
  const test::Outcome outcome = bpt({"render", op, "--forecast"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("cannot forecast"), std::string::npos) << outcome.err;
  EXPECT_EQ(bpt({"render", scene_, "--forecast-seconds", "2"}).exit_code, 2) << "it needs --forecast";
}

TEST_F(BptForecast, IsUpdatedByTheRender) {
  const test::Outcome outcome = bpt({"render", scene_, "--size", "320x240", "--target-error", "0.001",
                                     "--time", "3", "--progress", "json", "--output", path("image.exr")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"forecasts\":[{\"target_error\":0.05,\"seconds\":"), std::string::npos)
      << outcome.out;
}

}  // namespace
