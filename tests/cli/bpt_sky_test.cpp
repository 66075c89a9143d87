// The command `bpt sky`.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "renderer/image/image.h"
#include "tests/cli/bpt.h"

namespace {

using test::Outcome;

class BptSky : public test::Bpt {
 protected:
  std::string map_ = path("sky.exr");
  /// The example of Reda and Andreas 2004, appendix A.5, to the minute.
  std::vector<std::string> golden_ = {"sky",    "--latitude", "39.742476", "--longitude", "-105.1786",
                                      "--date", "2003-10-17", "--time",    "12:30",       "--utc-offset",
                                      "-7",     "-o",         map_};

  Outcome sky(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = golden_;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return bpt(arguments);
  }
};

TEST_F(BptSky, WritesAMapAndTellsWhatItShows) {
  const Outcome outcome = sky({"--width", "128", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::ordered_json::parse(outcome.out);
  std::vector<std::string> names;
  for (const auto& [name, value] : report.items()) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"image", "sun_azimuth", "sun_elevation", "sun_illuminance",
                                             "sky_illuminance", "brightness"}));
  EXPECT_EQ(report["image"], map_);
  EXPECT_NEAR(report["sun_azimuth"].get<double>(), 194.34, 0.2) << "half a minute earlier";
  EXPECT_NEAR(report["sun_elevation"].get<double>(), 39.87, 0.05);
  grf::Diagnostics diagnostics;
  const auto image = image::read_image(map_, diagnostics);
  ASSERT_TRUE(image) << diagnostics.to_text();
  EXPECT_EQ(image->width, 128);
  EXPECT_EQ(image->height, 64);
  // North is -z, so the sun is behind the viewer: the brightest texel is at the border of the image.
  std::size_t brightest = 0;
  for (std::size_t i = 0; i < image->pixels.size(); ++i) {
    if (image->pixels[i].y > image->pixels[brightest].y) brightest = i;
  }
  const double azimuth = (static_cast<double>(brightest % 128) + 0.5) / 128 * 360 - 180;
  EXPECT_NEAR(std::remainder(azimuth - 194.3, 360), 0, 360.0 / 128);
  EXPECT_NEAR(90 - (static_cast<double>(brightest / 128) + 0.5) / 64 * 180, 39.9, 180.0 / 64);
}

TEST_F(BptSky, PrintsATextForPeople) {
  const Outcome outcome = sky({"--width", "64"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("sun: azimuth 194."), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("klux by the sun"), std::string::npos);
  EXPECT_NE(outcome.out.find("BPT_EM_Scale 0.0"), std::string::npos);
}

TEST_F(BptSky, RefusesWhatHasNoSky) {
  const auto refused = [this](const std::vector<std::string>& more, const std::string& why) {
    // An option that is there already is replaced.
    std::vector<std::string> arguments = golden_;
    for (std::size_t i = 0; i + 1 < more.size(); i += 2) {
      const auto at = std::find(arguments.begin(), arguments.end(), more[i]);
      if (at == arguments.end()) {
        arguments.insert(arguments.end(), {more[i], more[i + 1]});
      } else {
        *(at + 1) = more[i + 1];
      }
    }
    const Outcome outcome = bpt(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << why;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(map_));
  };
  refused({"--time", "23:30"}, "below the horizon");
  refused({"--time", "24:00"}, "'24:00' is no time such as 10:30");
  refused({"--time", "12"}, "is no time");
  refused({"--date", "2003-02-29"}, "there is no day 2003-02-29");
  refused({"--date", "17.10.2003"}, "is no date such as 2026-06-21");
  refused({"--turbidity", "1"}, "the turbidity is from 2 to 6");
  refused({"--width", "100000"}, "the width of the map");
  const Outcome outcome = bpt({"sky", "--latitude", "0", "--longitude", "0", "--date", "2026-06-21", "--time",
                               "12:00", "-o", path("missing/sky.exr")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("missing/sky.exr"), std::string::npos) << outcome.err;
}

}  // namespace
