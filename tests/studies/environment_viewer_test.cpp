#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/image/encoders.h"
#include "renderer/plot/fit_file.h"
#include "tests/studies/filled_image.h"
#include "tests/studies/study_of_text.h"
#include "tests/support/temporary_folder.h"

namespace {

using grf::Colour;
using image::Image;
using test::filled;
using testing::HasSubstr;

class EnvironmentViewer : public testing::Test {
 protected:
  test::StudyOutcome outcome(const std::string& settings = {}, const std::string& rest = {}) const {
    return test::outcome_of("tool emviewer " + settings + "\n" +
                                (rest.find("brdf") == std::string::npos ? "brdf diffuse\n" : "") +
                                (rest.find("pdf ") == std::string::npos ? "pdf auto\n" : "") + rest,
                            folder_.path("a.study"));
  }
  studies::Study study(const std::string& settings = {}, const std::string& rest = {}) const {
    test::StudyOutcome made = outcome(settings, rest);
    if (!made.study) throw std::runtime_error(made.messages);
    return std::move(*made.study);
  }
  std::string message(const std::string& settings, const std::string& rest) const {
    const test::StudyOutcome made = outcome(settings, rest);
    EXPECT_FALSE(made.study) << settings << rest;
    return made.messages;
  }
  /// Adds a map, and returns the line of a state that opens it.
  std::string map_line(const std::string& name, const Image& image) const {
    folder_.add(name, image::encode_pfm({image}));
    return "file " + name + "\n";
  }

  test::TemporaryFolder folder_;
};

/// The positions of the dots of a colour that are on the unrolled map, at (415, 106), 520 by 260.
std::vector<plot::Point> dots_on_map(const studies::Study& study, const std::string& colour) {
  std::vector<plot::Point> dots;
  for (const auto& path : test::elements(test::svg_of(study.figure.str()), "path")) {
    if (!path.get_optional<std::string>("<xmlattr>.stroke-linecap")) continue;
    if (path.get<std::string>("<xmlattr>.stroke") != colour) continue;
    std::string text = path.get<std::string>("<xmlattr>.d");
    for (char& letter : text) letter = letter == 'M' || letter == 'h' ? ' ' : letter;
    std::istringstream stream(text);
    double zero = 0;
    for (plot::Point at; stream >> at.x >> at.y >> zero;) {
      if (at.x >= 415 && at.x <= 935 && at.y >= 106 && at.y <= 366) dots.push_back(at);
    }
  }
  return dots;
}

TEST_F(EnvironmentViewer, ShowsSamplesInTheOnlyBrightTexel) {
  Image image = filled(8, 4, Colour(0));
  image.pixels[8 + 5] = Colour(10);  // the second row and the sixth column: 65 wide and high
  const studies::Study made = study("N=500 M=20", map_line("a.pfm", image));
  const auto samples = dots_on_map(made, "#d6006e");
  ASSERT_GT(samples.size(), 5U);
  for (const plot::Point& at : samples) {
    EXPECT_GE(at.x, 415 + 5 * 65 - 0.1);
    EXPECT_LE(at.x, 415 + 6 * 65 + 0.1);
    EXPECT_GE(at.y, 106 + 65 - 0.1);
    EXPECT_LE(at.y, 106 + 2 * 65 + 0.1);
  }
  EXPECT_EQ(dots_on_map(made, "#e69f00").size(), 500U);
  const studies::Study without = study("dots=samples", map_line("a.pfm", image));
  EXPECT_TRUE(dots_on_map(without, "#e69f00").empty());
  EXPECT_FALSE(dots_on_map(without, "#d6006e").empty());
}

TEST_F(EnvironmentViewer, SaysWhatItFound) {
  const studies::Study made = study("N=100 M=10", map_line("a.pfm", filled(16, 8, Colour(4))));
  EXPECT_THAT(made.summary, HasSubstr("100 of 100 candidates are effective"));
  EXPECT_THAT(made.summary, HasSubstr("is 2 by resampling and 2 by quadrature"));
  const auto words = test::words_of(made);
  EXPECT_THAT(words, testing::IsSupersetOf({"100 of 100, 100 %", "N = 100 candidates",
                                            "M = 10 samples, larger if chosen again"}));
  EXPECT_THAT(words, testing::Contains(HasSubstr("under a.pfm, 16 \u00D7 8 texels")));
  EXPECT_THAT(test::words_of(study()), testing::Contains(HasSubstr("under the built-in sky")));
}

TEST_F(EnvironmentViewer, DescribesADirectionOfTheMap) {
  const studies::Study made = study("", map_line("a.pfm", filled(16, 8, Colour(4, 2, 1))));
  // A quarter from above and in the middle: 45 degrees high, towards -z. cos 45 / pi is 0.2251.
  const std::string words = made.describe({415 + 260, 106 + 65});
  EXPECT_THAT(words, HasSubstr("elevation 45\u00B0, azimuth 90\u00B0: radiance (4, 2, 1)"));
  EXPECT_THAT(words, HasSubstr("f cos 0.1125"));
  EXPECT_THAT(words, HasSubstr("BRDF 0.2251, map 0.07958"));
  EXPECT_THAT(words, HasSubstr("product 0.2251, scheme 0.2251; product over scheme 1"));
  EXPECT_THAT(made.describe({415 + 390, 106 + 195}), HasSubstr("azimuth 0\u00B0"));
  EXPECT_THAT(made.describe({415 + 390, 106 + 195}), HasSubstr("below the surface"));
  EXPECT_NE(made.describe({186, 276}), "") << "the sphere";
  EXPECT_EQ(made.describe({400, 600}), "");
}

// Under constant light L, each candidate of a diffuse surface weighs kd L, and has the density cos / pi.
TEST_F(EnvironmentViewer, HasTheCandidatesAsText) {
  const studies::Study made = study("N=40 M=5", map_line("a.pfm", filled(16, 8, Colour(8, 4, 0))));
  std::istringstream lines(made.csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "candidate,x,y,z,map_x,map_y,map_z,red,green,blue,weight,pdf,specular,chosen");
  double count = 0;
  double chosen = 0;
  std::size_t different = 0;
  for (; std::getline(lines, line); ++count) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    const std::vector<double> cells{std::istream_iterator<double>(numbers), {}};
    ASSERT_EQ(cells.size(), 14U);
    EXPECT_EQ(cells[0], count);
    EXPECT_NEAR(cells[1], cells[4], 1e-6) << "x is x for a surface that faces y";
    EXPECT_NEAR(cells[2], -cells[6], 1e-6);
    EXPECT_NEAR(cells[3], cells[5], 1e-6);
    EXPECT_NEAR(cells[7], 4, 1e-5);
    EXPECT_NEAR(cells[8], 2, 1e-5);
    EXPECT_EQ(cells[9], 0);
    EXPECT_NEAR(cells[10], 2, 1e-5);
    EXPECT_NEAR(cells[11], cells[3] / std::numbers::pi, 1e-5);
    EXPECT_EQ(cells[12], 0);
    chosen += cells[13];
    different += cells[13] > 0 ? 1 : 0;
  }
  EXPECT_EQ(count, 40);
  EXPECT_EQ(chosen, 5);
  grf::Diagnostics diagnostics;
  const auto fit = plot::read_fit(made.fit, "a.fit", diagnostics);
  ASSERT_TRUE(fit) << diagnostics.to_text();
  EXPECT_EQ(fit->points.size(), different);
  EXPECT_NEAR(fit->points.front().value, 0.5 / std::numbers::pi, 1e-5);
}

TEST_F(EnvironmentViewer, FollowsEachSetting) {
  const std::string plain = study().figure.str();
  for (const std::string setting : {"theta=20",
                                    "phi=10",
                                    "tilt=30",
                                    "N=99",
                                    "M=9",
                                    "seed=2",
                                    "show=fcos",
                                    "show=light",
                                    "show=warps",
                                    "show=product",
                                    "show=scheme",
                                    "show=lost",
                                    "channel=luminance",
                                    "exposure=1",
                                    "azimuth=70",
                                    "elevation=10",
                                    "visibility=open",
                                    "visibility=half",
                                    "deviations=false",
                                    "dots=hidden",
                                    "dots=candidates",
                                    "dots=samples"}) {
    EXPECT_NE(study(setting).figure.str(), plain) << setting;
  }
  EXPECT_NE(study("tilt=30 heading=20").figure.str(), study("tilt=30").figure.str());
  EXPECT_NE(study("", "brdf ward\n").figure.str(), study().figure.str());
  EXPECT_NE(study("", "pdf hemisphere exp=0\n").figure.str(), study().figure.str());
  EXPECT_EQ(study("theta=50 N=256").figure.str(), study().figure.str()) << "the defaults";
}

TEST_F(EnvironmentViewer, IsTheSameFromTheTextOfItsState) {
  folder_.add("a.pfm", image::encode_pfm({filled(8, 4, Colour(1))}));
  const std::string text = "tool emviewer theta=40 M=8 show=lost\nbrdf ward sx=0.1\npdf auto\nfile a.pfm\n";
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(text, folder_.path("a.study"), diagnostics);
  ASSERT_TRUE(state);
  const std::string again = studies::to_text(*state, folder_.path("b.study"));
  EXPECT_EQ(test::study_of_text(again, folder_.path("b.study")).figure.str(),
            test::study_of_text(text, folder_.path("a.study")).figure.str());
}

TEST_F(EnvironmentViewer, SaysWhatIsWrong) {
  EXPECT_THAT(message("N=10 M=11", ""), HasSubstr("M = 11 samples cannot be chosen from N = 10 candidates"));
  EXPECT_THAT(message("", "file gone.hdr\n"), HasSubstr("gone.hdr"));
  EXPECT_THAT(message("", map_line("black.pfm", filled(256, 128, Colour(0)))),
              HasSubstr("black.pfm' is black: there is nothing to sample"));
  folder_.add("zeros.hdr", std::string(512 * 1024, '\0'));
  EXPECT_THAT(message("", "file zeros.hdr\n"), HasSubstr("zeros.hdr"));
  folder_.add("words.txt", "no picture");
  EXPECT_THAT(message("", "file words.txt\n"), HasSubstr("words.txt"));
  EXPECT_THAT(message("", "file a.pfm\nfile b.pfm\n"), HasSubstr("the state has 2 files"));
  EXPECT_THAT(message("", "brdf specular\n"), HasSubstr("reflects into the mirror direction only"));
  EXPECT_THAT(message("show=maps", ""), HasSubstr("show"));
  EXPECT_THAT(message("N=0", ""), HasSubstr("out of range"));
}

TEST_F(EnvironmentViewer, WarnsOfInvalidTexels) {
  Image image = filled(16, 8, Colour(1));
  image.pixels[3] = Colour(std::numeric_limits<float>::infinity());
  image.pixels[20].y = std::numeric_limits<float>::quiet_NaN();
  const std::string line = map_line("a.pfm", image);
  for (int repeated = 0; repeated < 2; ++repeated) {
    const auto made = outcome("", line);
    ASSERT_TRUE(made.study) << made.messages;
    EXPECT_THAT(made.messages,
                HasSubstr("warning: 2 of 128 texels of the environment map are negative or not"));
    EXPECT_THAT(test::words_of(*made.study), testing::Not(testing::Contains(HasSubstr("nan"))));
  }
}

// Light from below only, and a figure without numbers that are none.
TEST_F(EnvironmentViewer, ShowsASurfaceThatNoLightReaches) {
  Image image = filled(8, 4, Colour(0));
  image.pixels[8 * 3] = Colour(5);
  const std::string line = map_line("a.pfm", image);
  for (const std::string show : {"map", "product", "lost", "scheme"}) {
    const studies::Study made = study("show=" + show, line);
    EXPECT_THAT(made.summary, HasSubstr("0 of 256 candidates are effective"));
    for (const std::string& words : test::words_of(made)) {
      EXPECT_EQ(words.find("nan"), std::string::npos) << words;
      EXPECT_EQ(words.find("inf"), std::string::npos) << words;
    }
  }
}

// A changed file is read again.
TEST_F(EnvironmentViewer, SeesAFileChange) {
  const studies::Study first = study("", map_line("a.pfm", filled(16, 8, Colour(4))));
  const studies::Study second = study("", map_line("a.pfm", filled(32, 16, Colour(6))));
  EXPECT_THAT(first.summary, HasSubstr("is 2 by resampling"));
  EXPECT_THAT(second.summary, HasSubstr("is 3 by resampling"));
}

// The tables of a scheme are kept while a study uses them, and only for the same models.
TEST_F(EnvironmentViewer, SeesAChangeOfModels) {
  const studies::Study first = study("", "brdf diffuse kd=0.2\npdf adaptive\n");
  const studies::Study again = study("", "brdf diffuse kd=0.2\npdf adaptive\n");
  const studies::Study other = study("", "brdf diffuse kd=0.4\npdf adaptive\n");
  const studies::Study sampled = study("", "brdf diffuse kd=0.4\npdf auto\n");
  EXPECT_EQ(again.csv, first.csv);
  EXPECT_NE(other.csv, first.csv);
  EXPECT_NE(sampled.csv, other.csv);
}

TEST_F(EnvironmentViewer, StopsEarly) {
  grf::Diagnostics diagnostics;
  const auto tool = studies::study_tool("emviewer");
  ASSERT_TRUE(tool);
  std::atomic<int> polls = 0;
  studies::study_of(tool->initial, {plot::Paper::White, [&] { return ++polls > 0; }}, diagnostics);
  EXPECT_GT(polls, 0);
  EXPECT_LT(polls, 1000);
}

}  // namespace
