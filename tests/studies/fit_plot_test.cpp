#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/studies/study_of_text.h"
#include "tests/support/temporary_folder.h"

namespace {

using testing::Contains;
using testing::HasSubstr;

// f of a diffuse BRDF is kd / pi.
constexpr double Half = 0.15915494309189535;

class FitPlot : public testing::Test {
 protected:
  /// The study of FIT files with these texts, and settings.
  test::StudyOutcome outcome(const std::vector<std::string>& fits, const std::string& settings = {}) {
    std::string text = "tool fitplot " + settings + "\n";
    for (std::size_t i = 0; i < fits.size(); ++i) {
      const std::string name = fmt::format("{}.fit", i);
      folder_.add(name, fits[i]);
      text += "file " + name + "\n";
    }
    return test::outcome_of(text, folder_.path("a.study"));
  }
  studies::Study study(const std::vector<std::string>& fits, const std::string& settings = {}) {
    test::StudyOutcome made = outcome(fits, settings);
    if (!made.study) throw std::runtime_error(made.messages);
    return std::move(*made.study);
  }

  test::TemporaryFolder folder_;
};

std::string diffuse_fit(const std::string& points) {
  return "diffuse kd=0.5\nviewer (0.5, 0)\nbegin\n" + points + "end\n";
}

TEST_F(FitPlot, ComparesValuesWithTheBrdf) {
  const std::string good = fmt::format("(0, 0, 1) {0}\n(0.6, 0, 0.8) {0}\n(0, 3, 4) {0}\n", Half);
  EXPECT_THAT(study({diffuse_fit(good)}).summary, HasSubstr("0.fit: 3 directions; all values agree"));
  const std::string bad = fmt::format("(0, 0, 1) {}\n(0.6, 0, 0.8) {}\n", Half, Half / 2);
  EXPECT_THAT(
      study({diffuse_fit(bad)}).summary,
      HasSubstr("0.fit: 2 directions; 1 value differs from the BRDF by more than 0.001, at most by 0.5."));
}

TEST_F(FitPlot, TakesTheCosineIntoAccount) {
  const std::string points = fmt::format("(0, 0, 1) {}\n(0.6, 0, 0.8) {}\n", Half, 0.8 * Half);
  EXPECT_THAT(study({diffuse_fit(points)}, "cosine=true").summary, HasSubstr("all values agree"));
  EXPECT_THAT(study({diffuse_fit(points)}).summary, HasSubstr("1 value differs"));
}

TEST_F(FitPlot, HasTheValuesAsText) {
  const auto made = study({diffuse_fit("(0.6, 0, 0.8) 0.25\n")});
  EXPECT_THAT(made.csv, testing::MatchesRegex("file,x,y,z,value,f\n0.fit,0.6,0,0.8,0.25,0.15915[0-9]*\n"));
  EXPECT_THAT(made.fit, HasSubstr("(0.6, 0, 0.8) 0.25\n"));
  const auto words = test::words_of(made);
  EXPECT_THAT(words, Contains("diffuse kd=0.5"));
  EXPECT_THAT(words, Contains("0.fit: 1 direction"));
  EXPECT_THAT(words, Contains(HasSubstr("\u03B8 = 28.65\u00B0"))) << "0.5 radians";
}

TEST_F(FitPlot, DrawsADotForEachDirectionInItsColour) {
  const auto made =
      study({diffuse_fit("(0, 0, 1) 0.1\n(0.6, 0, 0.8) 0.1\n"), diffuse_fit("(0, 0.6, 0.8) 0.1\n")});
  // The path of dots on the disc, by the colour of each file: "M x y h0" for each.
  std::map<std::string, std::size_t> most;
  for (const auto& path : test::elements(test::svg_of(made.figure.str()), "path")) {
    const auto stroke = path.get_optional<std::string>("<xmlattr>.stroke-linecap");
    if (!stroke) continue;
    const std::string dots = path.get<std::string>("<xmlattr>.d");
    std::size_t& known = most[path.get<std::string>("<xmlattr>.stroke")];
    known = std::max(known, static_cast<std::size_t>(std::count(dots.begin(), dots.end(), 'M')));
  }
  EXPECT_EQ(most["#d55e00"], 2U);
  EXPECT_EQ(most["#009e73"], 1U);
}

TEST_F(FitPlot, DescribesTheDirectionUnderThePointer) {
  const auto made = study({diffuse_fit("(0, 0, 1) 0.25\n(0.6, 0, 0.8) 0.5\n")});
  // The disc is at (640, 96), 220 wide: its centre is the normal, and x is right of it.
  EXPECT_THAT(made.describe({750, 206}),
              HasSubstr("\u03B8 = 0\u00B0, \u03C6 = 0\u00B0: value 0.25, the BRDF's own 0.15915"));
  EXPECT_THAT(made.describe({750 + 0.6 * 110, 206}),
              HasSubstr("\u03B8 = 36.87\u00B0, \u03C6 = 0\u00B0: value 0.5"));
  EXPECT_EQ(made.describe({640, 96}), "");
}

TEST_F(FitPlot, LeavesOutWhatIsBelowTheSurface) {
  EXPECT_THAT(study({diffuse_fit("(0, 0, -1) 1\n(1, 0, 0) 1\n(0, 0, 1) 0.159155\n(0, 0, 0) 1\n")}).summary,
              HasSubstr("1 direction, 3 more not above the surface; all values agree"));
}

TEST_F(FitPlot, TurnsWithTheEye) {
  const std::vector<std::string> fit = {diffuse_fit("(0.6, 0, 0.8) 0.1\n")};
  const std::string front = study(fit).figure.str();
  EXPECT_EQ(study(fit, "azimuth=60 elevation=25").figure.str(), front) << "the defaults";
  EXPECT_NE(study(fit, "azimuth=61").figure.str(), front);
  EXPECT_NE(study(fit, "elevation=26").figure.str(), front);
  EXPECT_NE(study(fit, "logarithmic=true").figure.str(), front);
}

TEST_F(FitPlot, SaysWhatIsWrongWithAFile) {
  const auto message = [&](const std::string& fit) {
    const auto made = outcome({fit});
    EXPECT_FALSE(made.study) << fit;
    return made.messages;
  };
  EXPECT_THAT(message("diffuse\nviewer (0.5, 0)\nbegin\n(0, 0, 1) 0.1\n(0, 0"),
              HasSubstr("0.fit:5:6: error: found the end of the file"));
  EXPECT_THAT(message("diffuse\n"), HasSubstr("expected 'viewer'"));
  EXPECT_THAT(message("diffus\nviewer (0, 0)\nbegin end\n"),
              HasSubstr("unknown BRDF 'diffus': did you mean"));
  EXPECT_THAT(message("diffuse kd=7\nviewer (0, 0)\nbegin end\n"),
              HasSubstr("'kd' of 'diffuse': 7 is out of range"));
  EXPECT_THAT(message("measured \"gone.binary\"\nviewer (0, 0)\nbegin end\n"), HasSubstr("gone.binary"));
  EXPECT_THAT(message("diffuse\nviewer (45, 0)\nbegin end\n"),
              HasSubstr("the view's theta, 45, is not above the surface: angles are in radians"));
  EXPECT_THAT(test::outcome_of("tool fitplot\n").messages, HasSubstr("no FIT file is open"));
  EXPECT_THAT(test::outcome_of("tool fitplot\nfile gone.fit\n").messages, HasSubstr("gone.fit"));
  const auto warned = outcome({"diffuse\nviewer (0.5, 45)\nbegin\n(0, 0, 1) 0.1\nend\n"});
  EXPECT_TRUE(warned.study);
  EXPECT_THAT(warned.messages,
              HasSubstr("0.fit:2:14: warning: the view's phi, 45, is more than a full turn"));
}

TEST_F(FitPlot, ShowsAFileWithoutDirections) {
  EXPECT_THAT(study({diffuse_fit("")}).summary, HasSubstr("0.fit: 0 directions"));
}

}  // namespace
