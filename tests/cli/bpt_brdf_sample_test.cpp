// Tests of `bpt brdf sample` and `bpt brdf plot --pdf`.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include <fmt/format.h>

#include "renderer/plot/fit_file.h"
#include "tests/cli/bpt_brdf.h"
#include "tests/support/svg_reading.h"

namespace {

class BptBrdfSample : public test::BptBrdf {};

TEST_F(BptBrdfSample, GivesDirectionsWithDensitiesAndValues) {
  const auto result =
      json({"sample", "diffuse kd=(0.9, 0.5, 0.1)", "--pdf", "diffuse", "--u", "0.5,1", "--count", "300"});
  ASSERT_EQ(result["directions"].size(), 300U);
  for (const char* field : {"pdfs", "values", "weights"}) EXPECT_EQ(result[field].size(), 300U) << field;
  EXPECT_EQ(result["rejected"], 0);
  EXPECT_EQ(result["bytes"], 0);
  EXPECT_GE(result["build_seconds"].get<double>(), 0);
  EXPECT_GT(result["sample_seconds"].get<double>(), 0);
  double mean_cosine = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    const auto v = result["directions"][i].get<std::vector<double>>();
    EXPECT_NEAR(v[0] * v[0] + v[1] * v[1] + v[2] * v[2], 1, 1e-5);
    EXPECT_NEAR(result["pdfs"][i].get<double>(), v[2] / std::numbers::pi, 1e-6);
    EXPECT_NEAR(result["values"][i][0].get<double>(), 0.9 / std::numbers::pi, 1e-6);
    EXPECT_NEAR(result["weights"][i][2].get<double>(), 0.1, 1e-6);
    mean_cosine += v[2] / 300;
  }
  EXPECT_NEAR(mean_cosine, 2.0 / 3, 0.01);
}

TEST_F(BptBrdfSample, IsDecidedByTheSeed) {
  const auto directions = [&](const std::string& seed) {
    return json(
        {"sample", "ward", "--pdf", "auto", "--u", "1", "--count", "20", "--seed", seed})["directions"];
  };
  EXPECT_EQ(directions("0"), directions("0"));
  EXPECT_NE(directions("0"), directions("1"));
  EXPECT_EQ(json({"sample", "ward", "--pdf", "auto", "--u", "1"})["directions"].size() +
                json({"sample", "ward", "--pdf", "auto", "--u", "1"})["rejected"].get<std::size_t>(),
            1000U);
}

TEST_F(BptBrdfSample, CountsWhatCarriesNothing) {
  const auto result = json({"sample", "lewis n=3 kd=0", "--pdf", "own", "--u", "1.5", "--count", "2000"});
  EXPECT_GT(result["rejected"].get<int>(), 100) << "half of the lobe is under the horizon";
  EXPECT_EQ(result["rejected"].get<std::size_t>() + result["directions"].size(), 2000U);
  const auto black = json({"sample", "diffuse", "--pdf", "diffuse", "--u", "2"});
  EXPECT_EQ(black["rejected"], 1000) << "from under the surface";
  EXPECT_TRUE(black["directions"].empty());
}

// A specular (delta) direction has no finite pdf.
TEST_F(BptBrdfSample, MarksTheMirrorDirectionByDensityZero) {
  const auto result =
      json({"sample", "specular ks=0.7", "--pdf", "specular", "--u", "0.6,0", "--count", "3"});
  ASSERT_EQ(result["directions"].size(), 3U);
  EXPECT_NEAR(result["directions"][2][0].get<double>(), -std::sin(0.6), 1e-6);
  EXPECT_EQ(result["pdfs"][2], 0.0);
  EXPECT_NEAR(result["weights"][2][1].get<double>(), 0.7, 1e-6);
}

TEST_F(BptBrdfSample, PrintsColumns) {
  std::istringstream text(out({"sample", "diffuse kd=1", "--pdf", "diffuse", "--u", "0", "--count", "5"}));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "# 5 directions and 0 rejected samples");
  int rows = 0;
  while (std::getline(text, line)) {
    if (line.starts_with('#')) continue;
    std::istringstream numbers(line);
    std::vector<double> row;
    for (double number = 0; numbers >> number;) row.push_back(number);
    ASSERT_EQ(row.size(), 7U) << line;
    EXPECT_NEAR(row[3], row[2] / std::numbers::pi, 1e-6);
    EXPECT_NEAR(row[6], std::numbers::inv_pi, 1e-6);
    ++rows;
  }
  EXPECT_EQ(rows, 5);
}

TEST_F(BptBrdfSample, WritesFitFiles) {
  const std::string path = folder_.path("a.fit");
  const auto result = json({"sample", "phong n=20 ks=(0.2, 0.4, 0.6)", "--pdf", "auto", "--u", "0.7,7",
                            "--count", "50", "--fit", path});
  grf::Diagnostics diagnostics;
  const auto fit = plot::read_fit(test::bytes_of(path), path, diagnostics);
  ASSERT_TRUE(fit) << diagnostics.to_text();
  EXPECT_EQ(diagnostics.to_text(), "") << "an azimuth within a turn";
  EXPECT_EQ(fit->brdf.keyword, "phong");
  EXPECT_EQ(fit->brdf.arguments.size(), 2U);
  EXPECT_EQ(fit->theta, 0.7F);
  EXPECT_NEAR(fit->phi, 7 - 2 * std::numbers::pi, 1e-6);
  ASSERT_EQ(fit->points.size(), result["directions"].size());
  for (std::size_t i = 0; i < fit->points.size(); ++i) {
    const auto& rgb = result["values"][i];
    EXPECT_NEAR(fit->points[i].direction.y, result["directions"][i][1].get<double>(), 1e-6);
    EXPECT_NEAR(fit->points[i].value,
                (rgb[0].get<double>() + rgb[1].get<double>() + rgb[2].get<double>()) / 3, 1e-5);
  }
}

TEST_F(BptBrdfSample, NamesFilesOfDataFromTheFitFile) {
  const std::string table = folder_.path("blinn.binary");
  json({"export", "blinn n=20", "-o", table});
  const std::string instance = folder_.add("blinn.brdf", "measured \"blinn.binary\"");
  std::filesystem::create_directory(folder_.path("fits"));
  const std::string path = folder_.path("fits/a.fit");
  out({"sample", instance, "--pdf", "diffuse", "--u", "0.3", "--count", "2", "--fit", path});
  EXPECT_TRUE(test::bytes_of(path).starts_with("measured \"../blinn.binary\"\nviewer (0.3, 0)\n"))
      << test::bytes_of(path);
}

TEST_F(BptBrdfSample, ReportsMistakes) {
  expect_failure({"sample", "ward", "--pdf", "diffus", "--u", "0"}, 1,
                 "PDF:1:1: error: unknown PDF 'diffus': did you mean 'diffuse'?");
  expect_failure({"sample", "ward", "--pdf", "diffuse n=3", "--u", "0"}, 1,
                 "PDF:1:9: error: 'diffuse' has no parameter 'n', it has none");
  expect_failure({"sample", "wrad", "--pdf", "diffuse", "--u", "0"}, 1,
                 "BRDF:1:1: error: unknown BRDF 'wrad'");
  expect_failure(
      {"sample", "ward", "--pdf", "specular", "--u", "0"}, 1,
      "PDF:1:1: error: the scheme 'specular' cannot sample the BRDF 'ward': the BRDF has no mirror "
      "(delta part): use 'diffuse' or 'auto'");
  const std::string nowhere = folder_.path("none/a.fit");
  expect_failure({"sample", "ward", "--pdf", "auto", "--u", "0", "--fit", nowhere}, 1, nowhere + ": error: ");
  expect_failure({"sample", "ward", "--u", "0"}, 2, "--pdf");
  expect_failure({"sample", "ward", "--pdf", "auto"}, 2, "--u");
  expect_failure({"sample", "ward", "--pdf", "auto", "--u", "up"}, 2, "'up' is not a direction");
  for (const char* count : {"0", "-1", "many", "1e3"}) {
    expect_failure({"sample", "ward", "--pdf", "auto", "--u", "0", "--count", count}, 2, "--count");
  }
}

class BptBrdfPlotOfSampling : public test::BptBrdf {
 protected:
  test::Element picture(const std::vector<std::string>& words) const {
    const std::string file = folder_.path("a.svg");
    std::vector<std::string> arguments = {"plot"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    arguments.insert(arguments.end(), {"-o", file});
    EXPECT_EQ(out(arguments), file + "\n");
    return test::svg_of(test::bytes_of(file));
  }
  static bool says(const test::Element& svg, const std::string& words) {
    for (const std::string& text : test::texts(svg)) {
      if (text.find(words) != std::string::npos) return true;
    }
    return false;
  }
};

TEST_F(BptBrdfPlotOfSampling, HasARowForEachView) {
  const auto svg = picture({"ward sx=0.2 ks=0.5", "--pdf", "diffuse"});
  EXPECT_EQ(test::elements(svg, "image").size(), 6U);
  for (const char* words : {"ward sx=0.2 ks=0.5", "sampled by diffuse", "View 0\u00B0", "View 45\u00B0",
                            "View 80\u00B0", "cosine-weighted: 0 %", "variance", "no tables"}) {
    EXPECT_TRUE(says(svg, words)) << words;
  }
  EXPECT_LT(std::filesystem::file_size(folder_.path("a.svg")), 1'000'000U);
  const auto one = picture({"ward", "--pdf", "auto", "--u", "0.5,1"});
  EXPECT_EQ(test::elements(one, "image").size(), 2U);
  EXPECT_TRUE(says(one, "View 28.65\u00B0, azimuth 57.3\u00B0"));
  EXPECT_EQ(test::elements(picture({"ward", "--pdf", "auto", "--u", "0.5,1", "--u", "1"}), "image").size(),
            4U);
}

TEST_F(BptBrdfPlotOfSampling, NamesItsColumns) {
  const auto svg = picture({"ward", "--pdf", "diffuse", "--u", "1"});
  for (const char* words :
       {"Pdf and 1000 samples", "on the unit disc, per projected solid angle", "f cos / albedo",
        "the ideal pdf, in the same colours", "In the plane of incidence", "Weights f cos / pdf",
        "1 for perfect importance sampling"}) {
    EXPECT_TRUE(says(svg, words)) << words;
  }
}

// The view is marked by a dark ring on a wider white one, which is visible on all colours.
TEST_F(BptBrdfPlotOfSampling, MarksTheView) {
  const auto svg = picture({"ward", "--pdf", "diffuse", "--u", "0.5,1"});
  std::vector<std::string> rings;
  std::vector<std::string> expected;
  for (const test::Element& circle : test::elements(svg, "circle")) {
    const auto value = [&circle](const std::string& name) {
      return circle.get<std::string>("<xmlattr>." + name);
    };
    if (value("r") == "4.00") {
      rings.push_back(value("cx") + " " + value("cy") + " " + value("stroke") + " " + value("stroke-width"));
    }
  }
  for (const test::Element& disc : test::elements(svg, "image")) {
    const auto value = [&disc](const std::string& name) { return disc.get<double>("<xmlattr>." + name); };
    const double radius = value("width") / 2;
    const double x = value("x") + radius * (1 + std::sin(0.5) * std::cos(1.0));
    const double y = value("y") + radius * (1 - std::sin(0.5) * std::sin(1.0));
    expected.push_back(fmt::format("{:.2f} {:.2f} #fff 3", x, y));
    expected.push_back(fmt::format("{:.2f} {:.2f} #111 1.2", x, y));
  }
  ASSERT_EQ(expected.size(), 4U);
  EXPECT_EQ(rings, expected);
}

TEST_F(BptBrdfPlotOfSampling, TellsAPerfectScheme) {
  const auto svg = picture({"diffuse kd=0.8", "--pdf", "diffuse", "--u", "1"});
  EXPECT_TRUE(says(svg, "albedo 0.8   \u00B7   weights: variance 0, largest 1, mean 1.000") ||
              says(svg, "largest 1, mean 1.000"));
}

// All weights are 1, so the histogram has one non-empty bin, around the line at 1.
TEST_F(BptBrdfPlotOfSampling, HasAHistogramOfWeights) {
  const auto svg = picture({"diffuse kd=0.8", "--pdf", "diffuse", "--u", "1"});
  int histograms = 0;
  const auto lines = test::lines(svg);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (lines[i].size() != 2 || lines[i][0].x != lines[i][1].x || lines[i + 1].size() < 4) continue;
    ++histograms;
    const auto& steps = lines[i + 1];
    const auto is_higher = [](const plot::Point& a, const plot::Point& b) { return a.y < b.y; };
    const double top = std::min_element(steps.begin(), steps.end(), is_higher)->y;
    const double bottom = std::max_element(steps.begin(), steps.end(), is_higher)->y;
    std::vector<double> at_top;
    for (const plot::Point& point : steps) {
      if (point.y == top) {
        at_top.push_back(point.x);
      } else {
        EXPECT_EQ(point.y, bottom);
      }
    }
    ASSERT_EQ(at_top.size(), 2U);
    EXPECT_LT(top, bottom);
    EXPECT_NEAR((at_top[0] + at_top[1]) / 2, lines[i][0].x, 0.02);
  }
  EXPECT_EQ(histograms, 1);
}

TEST_F(BptBrdfPlotOfSampling, HasPlaceForBrdfsOfOneDirectionAndOfNone) {
  EXPECT_TRUE(says(picture({"specular", "--pdf", "specular"}), "100 % of samples specular"));
  EXPECT_TRUE(says(picture({"diffuse kd=0", "--pdf", "diffuse"}), "reflects nothing"));
  EXPECT_TRUE(says(picture({"diffuse", "--pdf", "diffuse", "--u", "2"}), "reflects nothing"));
  EXPECT_TRUE(says(picture({"coupled Rm=0.9", "--pdf", "specular"}), "% of samples specular"));
  EXPECT_TRUE(says(picture({"phong n=100000 kd=0", "--pdf", "diffuse"}), "cut: f cos / albedo reaches"));
}

TEST_F(BptBrdfPlotOfSampling, ReportsMistakes) {
  const std::string file = folder_.path("a.svg");
  expect_failure({"plot", "ward", "--pdf", "specular", "-o", file}, 1, "the scheme 'specular' cannot sample");
  expect_failure({"plot", "ward", "--pdf", "diffuse", "--u", "up", "-o", file}, 2, "'up' is not a direction");
  expect_failure({"plot", "ward", "--u", "1", "-o", file}, 2, "--pdf");
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace
