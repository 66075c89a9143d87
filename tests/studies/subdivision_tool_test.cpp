// The tool `subdivision`: its samples, its figure and its messages.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/studies/angles.h"
#include "tests/studies/study_of_text.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace subdivision_tool_test {
namespace {

using studies::Degree;
using testing::Contains;
using testing::HasSubstr;

constexpr double Pi = std::numbers::pi;

constexpr const char* Lobe = "brdf ward sx=0.2 sy=0.2\n";
constexpr const char* Scheme = "pdf adaptive mode=reject nQT=10 res=60\n";

std::string text_of(const std::string& settings, const std::string& brdf = Lobe,
                    const std::string& pdf = Scheme) {
  return "tool subdivision res=60 count=300 " + settings + "\n" + brdf + pdf;
}

std::vector<std::vector<double>> numbers_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

TEST(SubdivisionTool, HasTheSamplesOfTheProgram) {
  for (const std::string pdf : {"adaptive mode=reject nQT=10 res=60", "factored half=true pTh=4 pPh=4"}) {
    const auto made = test::study_of_text("tool subdivision res=60 theta=40 phi=25 count=200 seed=7\n" +
                                          std::string(Lobe) + "pdf " + pdf + "\n");
    const auto printed = test::run(
        {std::string(GRANADA_BIN_DIR) + "/bpt", "brdf", "sample", "ward sx=0.2 sy=0.2", "--pdf", pdf, "--u",
         fmt::format("{},{}", 40 * Degree, 25 * Degree), "--count", "200", "--seed", "7", "--json"});
    ASSERT_EQ(printed.exit_code, 0) << printed.err;
    const auto json = nlohmann::json::parse(printed.out);
    const auto rows = numbers_of(made.csv);
    ASSERT_EQ(rows.size(), json["directions"].size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(rows[i][k], json["directions"][i][k].get<double>(), 1e-6);
      EXPECT_NEAR(rows[i][3] / json["pdfs"][i].get<double>(), 1, 1e-4);
      EXPECT_NEAR(rows[i][4] / json["values"][i][0].get<double>(), 1, 1e-4) << "grey";
    }
    const auto rejected = json["rejected"].get<int>();
    EXPECT_EQ(rejected > 0, pdf.starts_with("factored"));
    EXPECT_THAT(made.summary, HasSubstr(fmt::format(", {} rejected;", rejected)));
    if (rejected > 0) {
      EXPECT_THAT(test::words_of(made), Contains(HasSubstr(fmt::format("samples, {} rejected (", rejected))));
    }
  }
}

TEST(SubdivisionTool, DescribesTheCellUnderThePointer) {
  const auto made = test::study_of_text(text_of("nmax=2", "brdf diffuse kd=0.5\n", "pdf diffuse\n"));
  // The disc is at (86, 110), 420 wide.
  EXPECT_EQ(made.describe({296, 320}),
            "Cell at depth 0, x -1 to 1, y -1 to 1: mass 100 %, bound 0.1592 1/sr, acceptance 78.5 %; 300 "
            "samples, 300 expected");
  EXPECT_EQ(made.describe({90, 114}), "") << "the corner of its square is no direction";
  const auto split = test::study_of_text(text_of("nmax=1.2 depth=1", "brdf diffuse\n", "pdf diffuse\n"));
  EXPECT_THAT(split.describe({296 + 50, 320 - 50}), HasSubstr("depth 1, x 0 to 1, y 0 to 1: mass 25 %"))
      << "y is up";
}

TEST(SubdivisionTool, ShowsTheWayOfASample) {
  const std::string brdf = "brdf diffuse\n";
  const auto words = [&](const std::string& settings) {
    return test::words_of(
        test::study_of_text(text_of("nmax=1.2 depth=2 " + settings, brdf, "pdf diffuse\n")));
  };
  // A quarter first. The quarter at the rim's corner and those beside and inside it: the second choices.
  const double inner = 0.25;
  EXPECT_THAT(words("sample=1"), Contains("1: 25 %"));
  EXPECT_THAT(words("sample=1 step=1"), testing::AllOf(Contains("mass at"), Contains("25 %")));
  EXPECT_THAT(words("sample=1 step=1"), testing::Not(Contains(testing::StartsWith("2: "))));
  EXPECT_THAT(words("sample=0"), testing::Not(Contains(testing::StartsWith("1: "))));
  const double inside = inner / (Pi / 4);  // of the quarter's mass, if the square is inside the disc
  int with_inside = 0;
  for (int i = 1; i <= 12; ++i) {
    const auto found = words(fmt::format("sample={}", i));
    const bool is_inside = testing::Matches(Contains(fmt::format("2: {:.3g} %", 100 * inside)))(found);
    if (is_inside) {
      EXPECT_THAT(found, Contains(fmt::format("{:.3g} %", 25 * inside)));
    }
    with_inside += is_inside ? 1 : 0;
  }
  EXPECT_GT(with_inside, 0);
  EXPECT_LT(with_inside, 12);
  const auto beyond = test::outcome_of(text_of("sample=301"));
  EXPECT_TRUE(beyond.study);
  EXPECT_THAT(beyond.messages, HasSubstr("warning: there is no sample 301: 300 have"));
}

TEST(SubdivisionTool, EachSettingChangesTheFigure) {
  const std::string base = test::study_of_text(text_of("")).figure.str();
  EXPECT_EQ(test::study_of_text(text_of("theta=45 phi=0 nmax=2 depth=8 seed=0 colour=value panels=one "
                                        "sample=0 azimuth=60 elevation=25"))
                .figure.str(),
            base)
      << "the defaults";
  std::set<std::string> figures = {base};
  for (const std::string setting :
       {"theta=50", "phi=10", "nmax=1.5", "depth=3", "seed=1", "pattern=independent", "colour=mass",
        "colour=acceptance", "colour=chisquare", "panels=compare", "sample=2", "sample=2 step=0", "azimuth=0",
        "elevation=60"}) {
    EXPECT_TRUE(figures.insert(test::study_of_text(text_of(setting)).figure.str()).second) << setting;
  }
  EXPECT_TRUE(
      figures.insert(test::study_of_text(text_of("", "brdf ward sx=0.21 sy=0.2\n")).figure.str()).second);
  EXPECT_TRUE(figures.insert(test::study_of_text(text_of("", Lobe, "pdf own\n")).figure.str()).second);
  for (const std::string setting : {"res=61 count=300", "res=60 count=301"}) {
    EXPECT_TRUE(
        figures.insert(test::study_of_text("tool subdivision " + setting + "\n" + Lobe + Scheme).figure.str())
            .second)
        << setting;
  }
}

TEST(SubdivisionTool, IsMadeAgainFromItsText) {
  grf::Diagnostics diagnostics;
  const auto state =
      studies::read_state(text_of("theta=33 nmax=1.7 depth=5 seed=3 colour=chisquare sample=4 azimuth=-20"),
                          "a.study", diagnostics);
  ASSERT_TRUE(state);
  const auto again = studies::read_state(to_text(*state), "b.study", diagnostics);
  ASSERT_TRUE(again);
  const auto first = studies::study_of(*state, {}, diagnostics);
  const auto second = studies::study_of(*again, {}, diagnostics);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->figure.str(), second->figure.str());
  EXPECT_EQ(first->csv, second->csv);
  EXPECT_EQ(diagnostics.to_text(), "");
  EXPECT_TRUE(studies::study_of(studies::study_tool("subdivision")->initial, {}, diagnostics));
}

TEST(SubdivisionTool, ComparesSixSchemes) {
  const auto made = test::study_of_text(text_of("panels=compare"));
  const auto words = test::words_of(made);
  for (const std::string name : {"adaptive mode=reject nQT=10 res=60", "adaptive", "factored half=true",
                                 "cascadeCDF", "hemisphere", "own"}) {
    EXPECT_THAT(words, Contains(name));
  }
  EXPECT_EQ(std::ranges::count(words, "p-value"), 6);
  // The first disc is at (20, 104), 206 wide.
  EXPECT_THAT(made.describe({123, 207}), HasSubstr("adaptive mode=reject nQT=10 res=60: \u03B8 = 0\u00B0"));
  EXPECT_EQ(made.describe({22, 106}), "");
  // Cosine sampling of a diffuse BRDF: the pdf is f cos / albedo, whatever the albedo.
  const auto diffuse =
      test::study_of_text(text_of("panels=compare", "brdf diffuse kd=0.3\n", "pdf diffuse\n"));
  EXPECT_THAT(diffuse.describe({123, 207}), HasSubstr("pdf 0.3183 1/sr, f cos / albedo 0.3183 1/sr"));
  EXPECT_THAT(test::words_of(diffuse), Contains("factored half=false"));
}

/// Returns the dots of each element that draws some.
std::vector<std::vector<plot::Point>> dots_of(const std::string& figure) {
  std::vector<std::vector<plot::Point>> all;
  for (const auto& path : test::elements(test::svg_of(figure), "path")) {
    if (!path.get_optional<std::string>("<xmlattr>.stroke-linecap")) continue;
    std::istringstream stream(path.get<std::string>("<xmlattr>.d"));
    all.emplace_back();
    for (char letter = 0; stream >> letter;) {
      plot::Point& point = all.back().emplace_back(0, 0);
      stream >> point.x >> point.y >> letter >> letter;
    }
  }
  return all;
}

// Strata are at (610, 456), (752, 456) and (894, 456), 126 wide, with 16 x 16 of 9 points each.
TEST(SubdivisionTool, ShowsStrataBeforeAndAfterTheWarp) {
  const auto squares_of = [](const std::string& pdf) {
    const auto made = test::study_of_text(text_of("", "brdf phong n=20 ks=0.5 kd=0.5\n", pdf));
    std::array<std::vector<std::vector<plot::Point>>, 3> squares;
    for (const auto& dots : dots_of(made.figure.str())) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double left = 610 + 142 * static_cast<double>(i);
        const auto is_in = [&](const plot::Point& point) {
          return point.x >= left && point.x <= left + 126 && point.y >= 456 && point.y <= 582;
        };
        if (dots.size() == 9 && std::ranges::all_of(dots, is_in)) squares[i].push_back(dots);
      }
    }
    return squares;
  };
  // The largest distance between neighbouring points of a stratum, on average.
  const auto spread = [](const std::vector<std::vector<plot::Point>>& strata) {
    double sum = 0;
    for (const auto& points : strata) {
      double largest = 0;
      for (std::size_t i = 0; i + 1 < 9; ++i)
        largest = std::max(largest, (points[i + 1] - points[i]).length());
      sum += largest / static_cast<double>(strata.size());
    }
    return sum;
  };
  const auto rejection = squares_of(Scheme);
  for (const auto& square : rejection) EXPECT_EQ(square.size(), 256U);
  EXPECT_NEAR(spread(rejection[0]), 126 / 48.0 * std::sqrt(5), 0.2) << "back to the next row: (-2, 1) points";
  EXPECT_LT(spread(rejection[1]), 15) << "the warp keeps a stratum together";
  EXPECT_GT(spread(rejection[2]), 30) << "rejection does not";
  const auto warp = squares_of("pdf adaptive\n");
  EXPECT_EQ(warp[1].size(), 256U);
  EXPECT_NEAR(spread(warp[1]), spread(warp[2]), 1e-3) << "the same scheme twice";
}

// The tables of schemes are kept, and must be those of the terms as they are now.
TEST(SubdivisionTool, ShowsSums) {
  const auto study = [](const std::string& term) {
    return test::study_of_text("tool subdivision res=60 count=300 theta=40\ndef part = brdf " + term +
                               "\nbrdf combine 0.5 part\npdf adaptive mode=reject nQT=5 res=30\n");
  };
  const auto matte = study("diffuse kd=0.8");
  EXPECT_THAT(matte.describe({296, 320}), HasSubstr("bound 0.1273 1/sr")) << "0.5 * 0.8 / pi";
  EXPECT_EQ(matte.fit, "") << "it would need the definition";
  const auto glossy = study("phong n=100 ks=0.9 kd=0.05");
  EXPECT_GT(test::words_of(glossy).size(), 0U);
  const auto counts_of = [](const studies::Study& made) {
    // About the mirror direction, (-0.64, 0).
    int near = 0;
    for (const auto& row : numbers_of(made.csv)) near += std::hypot(row[0] + 0.643, row[1]) < 0.25 ? 1 : 0;
    return near;
  };
  EXPECT_LT(counts_of(matte), 40) << "a sixteenth of the disc";
  // The lobe reflects about 2 pi 0.9 / 101 times the cosine of 40 degrees, and the rest 0.05.
  EXPECT_NEAR(counts_of(glossy), 300 * 0.0429 / 0.0929, 30);
}

TEST(SubdivisionTool, CanBeStopped) {
  for (const std::string settings : {"", "panels=compare", "colour=chisquare sample=1"}) {
    grf::Diagnostics diagnostics;
    const auto state = studies::read_state(text_of(settings), "a.study", diagnostics).value();
    studies::StudyContext context;
    context.is_stopped = [] { return true; };
    EXPECT_NO_THROW(studies::study_of(state, context, diagnostics));
    EXPECT_EQ(diagnostics.to_text(), "");
  }
}

class SubdivisionFile : public testing::Test {
 protected:
  test::StudyOutcome outcome(const std::string& fit, const std::string& settings = {}) {
    folder_.add("a.fit", fit);
    return test::outcome_of(text_of(settings) + "file a.fit\n", folder_.path("a.study"));
  }
  test::TemporaryFolder folder_;
};

TEST_F(SubdivisionFile, ShowsItsPointsWithItsBrdfAndView) {
  const auto made = outcome(
      "diffuse kd=0.25\nviewer (0.5, 0.2)\nbegin\n(0, 0, 1) 1\n(0.6, 0, 0.8) 1\n(0, 3, 4) 7\n(0, 0, -1) "
      "1\nend\n",
      "nmax=1.2 depth=1");
  ASSERT_TRUE(made.study) << made.messages;
  const auto words = test::words_of(*made.study);
  EXPECT_THAT(words, Contains("diffuse kd=0.25"));
  EXPECT_THAT(words, Contains(HasSubstr("\u03B8 = 28.65\u00B0, \u03C6 = 11.46\u00B0")));
  EXPECT_THAT(words, Contains("3 directions of a.fit, 1 not above the surface (25 %)"));
  const auto rows = numbers_of(made.study->csv);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_NEAR(rows[1][0], 0.6, 1e-6);
  EXPECT_NEAR(rows[1][3], 0.8 / Pi, 1e-6) << "f cos / albedo";
  EXPECT_NEAR(rows[1][4], 0.25 / Pi, 1e-6) << "f, whatever the file says";
  EXPECT_THAT(made.study->fit, HasSubstr("viewer (0.5, 0.2)"));
  EXPECT_THAT(made.study->fit, HasSubstr("(0, 0.6, 0.8)"));
  // (0.6, 0) is in the fourth quarter of the tree, which is turned by 11 degrees; so is nothing else.
  EXPECT_THAT(made.study->describe({296 + 0.6 * 210, 320}), HasSubstr("1 samples, 0.75 expected"));
}

TEST_F(SubdivisionFile, IsTestedAgainstTheBrdf) {
  // Points of cosine sampling, on a spiral, follow a diffuse BRDF; points in a half of the disc do not.
  const auto p_value = [&](double turn) {
    std::string fit = "diffuse\nviewer (0.5, 0)\nbegin\n";
    for (int i = 0; i < 400; ++i) {
      const double radius = std::sqrt((i + 0.5) / 400);
      const double angle = std::fmod(2.399963 * i, 2 * Pi) * turn;
      fit += fmt::format("({}, {}, {}) 1\n", radius * std::cos(angle), radius * std::sin(angle),
                         std::sqrt(1 - radius * radius));
    }
    const auto made = outcome(fit + "end\n", "nmax=1.1 depth=4");
    const std::string& summary = made.study.value().summary;
    return std::stod(summary.substr(summary.find("p = ") + 4));
  };
  EXPECT_GT(p_value(1), 0.01);
  EXPECT_LT(p_value(0.5), 1e-4);
}

TEST_F(SubdivisionFile, MayBeOnlyOne) {
  folder_.add("b.fit", "diffuse\nviewer (0.5, 0)\nbegin\nend\n");
  const auto made = test::outcome_of(text_of("") + "file b.fit\nfile b.fit\n", folder_.path("a.study"));
  EXPECT_FALSE(made.study);
  EXPECT_THAT(made.messages, HasSubstr("'subdivision' shows one FIT file"));
  EXPECT_TRUE(outcome("diffuse\nviewer (0.5, 0)\nbegin\nend\n").study) << "without points";
  EXPECT_TRUE(outcome("diffuse\nviewer (0.5, 0)\nbegin\nend\n", "panels=compare").study);
  EXPECT_THAT(outcome("diffuse\nviewer (45, 0)\nbegin\nend\n").messages,
              HasSubstr("the view's theta, 45, is not above the surface"));
  EXPECT_THAT(outcome("diffus\nviewer (0, 0)\nbegin\nend\n").messages, HasSubstr("unknown BRDF 'diffus'"));
  EXPECT_THAT(test::outcome_of(text_of("") + "file gone.fit\n").messages, HasSubstr("gone.fit"));
}

TEST(SubdivisionTool, SaysWhatIsWrong) {
  const auto message = [](const std::string& text) {
    const auto made = test::outcome_of(text);
    EXPECT_FALSE(made.study) << text;
    return made.messages;
  };
  EXPECT_THAT(message(text_of("", "brdf specular\n", "pdf specular\n")),
              HasSubstr("'specular' reflects nothing that a tree could show: it is only a mirror"));
  EXPECT_THAT(message(text_of("", "brdf diffuse kd=0\n")), HasSubstr("it is black"));
  EXPECT_THAT(message(text_of("", Lobe, "pdf specular\n")), HasSubstr("cannot sample the BRDF 'ward'"));
  EXPECT_THAT(message(text_of("", Lobe, "pdf adaptiv\n")), HasSubstr("adaptive"));
  EXPECT_THAT(message(text_of("", Lobe, "")), HasSubstr("takes 1 sampling scheme, and the state has 0"));
  EXPECT_THAT(message(text_of("nmax=1")), HasSubstr("'nmax' of 'subdivision': 1 is out of range"));
  EXPECT_THAT(message(text_of("theta=90")), HasSubstr("'theta' of 'subdivision': 90 is out of range"));
  EXPECT_THAT(message(text_of("colour=blue")), HasSubstr("chisquare"));
  EXPECT_THAT(message(text_of("dept=3")), HasSubstr("depth"));
}

TEST(SubdivisionTool, ShowsNoSamples) {
  const auto made = test::study_of_text("tool subdivision res=2 count=0\n" + std::string(Lobe) + Scheme);
  EXPECT_EQ(numbers_of(made.csv).size(), 0U);
  EXPECT_THAT(test::words_of(made), Contains("0 of 0 samples"));
  for (const std::string settings :
       {"res=2 depth=0 theta=89", "theta=0 count=1", "res=2 panels=compare count=0"})
    EXPECT_NO_THROW(test::study_of_text("tool subdivision " + settings + "\n" + Lobe + Scheme)) << settings;
}

}  // namespace
}  // namespace subdivision_tool_test
