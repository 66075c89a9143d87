// Tests of `bpt cost`, and unit tests of its fit.
#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "renderer/command/cost_fit.h"
#include "tests/cli/bpt.h"
#include "tests/support/paths.h"
#include "tests/support/svg_reading.h"

namespace {

using command::CostPoint;
using nlohmann::json;
using test::Outcome;

TEST(CostFit, FindsAKnownPowerLaw) {
  std::vector<CostPoint> points;
  for (const double samples : {1.0, 4.0, 16.0, 64.0}) {
    const double error = 0.3 * std::pow(samples, -0.7);
    points.push_back({samples, 0.01 * samples, error * error});
  }
  const command::CostFit fit = command::fit_cost(points, 0);
  ASSERT_TRUE(fit.over_samples && fit.over_seconds);
  EXPECT_NEAR(fit.over_samples->exponent, 0.7, 1e-12);
  EXPECT_NEAR(fit.over_samples->factor, 0.3, 1e-12);
  EXPECT_NEAR(fit.over_seconds->exponent, 0.7, 1e-12);
  EXPECT_NEAR(fit.over_seconds->at(0.04), 0.3 * std::pow(4, -0.7), 1e-12);
  EXPECT_NEAR(fit.over_seconds->inverse(0.01).value(), 0.01 * std::pow(30, 1 / 0.7), 1e-9);
}

TEST(CostFit, TakesTheErrorOfTheReferenceOff) {
  constexpr double Reference = 1e-5;
  std::vector<CostPoint> points;
  for (const double samples : {1.0, 4.0, 16.0, 64.0, 1e6}) {
    points.push_back({samples, samples, 0.01 / samples + Reference});
  }
  const command::CostFit fit = command::fit_cost(points, Reference);
  EXPECT_EQ(fit.used.size(), 4U) << "the last one is the reference's own error alone";
  EXPECT_NEAR(fit.over_samples.value().exponent, 0.5, 1e-12);
  EXPECT_GT(std::abs(command::fit_cost(points, 0).over_samples.value().exponent - 0.5), 0.05);
}

TEST(CostFit, IsNotThereWithoutTwoPlaces) {
  EXPECT_FALSE(command::fit_cost({}, 0).over_samples);
  const std::vector<CostPoint> same = {{4, 1, 0.1}, {4, 2, 0.2}};
  EXPECT_FALSE(command::fit_cost(same, 0).over_samples);
  EXPECT_TRUE(command::fit_cost(same, 0).over_seconds);
  EXPECT_FALSE(command::fit_cost(same, 0).over_seconds->inverse(0.01)) << "the error grows";
}

/// Two walls with interreflection, under a light.
const std::string Corner =
    "begin mesh brdf diffuse kd=0.7\n"
    "begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) (0,0,1) (0,1,1) end vertexs\n"
    "begin faces (0,1,2,3) (0,3,5,4) end faces end mesh\n"
    "light begin (0.3,1,0.3) (0.3,0,0) (0,0,0.3) end\n";

const std::string Glossy =
    "begin mesh brdf ward sx=0.2 ks=0.5 kd=0.3\n"
    "begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs\n"
    "begin faces (0,1,2,3) end faces end mesh\n"
    "light begin (0,0,0.6) (0,1,0) (1,0,0) end\n";

class BptCost : public test::Bpt {
 protected:
  Outcome cost(const std::string& scene, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"cost", scene, "--output", path("study")});
    return bpt(arguments);
  }

  json report(const std::string& scene, std::vector<std::string> arguments) const {
    arguments.emplace_back("--json");
    const Outcome outcome = cost(scene, arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  void expect_error(std::vector<std::string> arguments, int exit_code, const std::string& message) const {
    const Outcome outcome = cost(write("scene.grf", Corner), std::move(arguments));
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(path("study.csv")));
  }
};

std::vector<std::string> line_names(const json& report) {
  std::vector<std::string> names;
  for (const json& fit : report["fits"]) names.push_back(fit["line"]);
  return names;
}

// With a given reference image, a row has the numbers of `bpt render` and `bpt compare`.
TEST_F(BptCost, RowsAreThoseOfRenderAndCompare) {
  const std::string scene = write("scene.grf", Glossy);
  const std::string reference = path("reference.pfm");
  ASSERT_EQ(bpt({"render", scene, "--size", "16x12", "--samples", "300", "--output", reference}).exit_code,
            0);
  const json study = report(scene, {"--size", "16x12", "--samples", "2,6", "--pdf", "Own,Disk", "--rounds",
                                    "1", "--reference", reference});
  EXPECT_TRUE(study["reference"]["error"].is_null());
  ASSERT_EQ(study["rows"].size(), 4U);
  for (const json& row : study["rows"]) {
    const std::string image = path("image.pfm");
    const Outcome render = bpt({"render", scene, "--size", "16x12", "--samples",
                                std::to_string(row["samples"].get<int>()), "--pdf", row["pdf"], "--seed",
                                std::to_string(row["seeds"][0].get<std::uint32_t>()), "--output", image});
    ASSERT_EQ(render.exit_code, 0) << render.err;
    const json error = json::parse(bpt({"compare", image, reference, "--json"}).out);
    EXPECT_NEAR(row["relmse"].get<double>(), error["relmse"].get<double>(), 1e-12);
    EXPECT_NEAR(row["average_relative_error"].get<double>(), error["average_relative_error"].get<double>(),
                1e-12);
    EXPECT_NEAR(
        row["efficiency"].get<double>() * row["relmse"].get<double>() * row["render_seconds"].get<double>(),
        1, 1e-9);
    EXPECT_EQ(row["bytes"].get<std::size_t>() > 0, row["pdf"] == "Disk");
    EXPECT_GT(row["build_seconds"].get<double>(), 0);
    EXPECT_GT(row["sampling_seconds"].get<double>(), 0);
  }
}

TEST_F(BptCost, WritesATableAReportAndAPicture) {
  const json study = report(write("scene.grf", Glossy),
                            {"--size", "16x12", "--samples", "2,6,18", "--pdf", "Own,Disk,Diffuse"});
  EXPECT_GT(study["reference"]["error"].get<double>(), 0);
  EXPECT_EQ(study["reference"]["samples"], 16 * 18);
  std::istringstream table(test::bytes_of(path("study.csv")));
  std::string line;
  int lines = 0;
  for (; std::getline(table, line); ++lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 13) << line;
  EXPECT_EQ(lines, 1 + 9);
  const std::string text = test::bytes_of(path("study.md"));
  for (const char* part : {"](study.svg)", "half the error costs", "| Disk | 18 |", "**Own**"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  const auto svg = test::svg_of(test::bytes_of(path("study.svg")));
  EXPECT_EQ(test::lines(svg).size(), 2U * (3 + 3)) << "a line and its way to the name, over time and samples";
  for (const char* part : {"render time, s", "samples per pixel", "error, sqrt(relMSE), %"}) {
    const std::vector<std::string> words = test::texts(svg);
    EXPECT_NE(std::find(words.begin(), words.end(), part), words.end()) << part;
  }
}

TEST_F(BptCost, GivesALineToEachCombination) {
  const std::string scene = write("scene.grf", Glossy);
  const std::vector<std::string> small = {"--size",   "4x4", "--samples",           "1,2",
                                          "--rounds", "1",   "--reference-samples", "2"};
  const auto lines = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), small.begin(), small.end());
    return line_names(report(scene, arguments));
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(lines({}), (Names{"scene"}));
  EXPECT_EQ(lines({"--integrator", "naive,path", "--depth", "1,2"}),
            (Names{"naive, depth 1", "naive, depth 2", "path, depth 1", "path, depth 2"}));
  EXPECT_EQ(lines({"--trees", "3,5"}), (Names{"3 trees", "5 trees"}));
  EXPECT_EQ(lines({"--trees", "1,10"}), (Names{"1 tree", "10 trees"}));
  EXPECT_EQ(lines({"--resolution", "8,16"}), (Names{"8 cells", "16 cells"}));
  EXPECT_EQ(lines({"--factors", "1x1,2x2"}), (Names{"1x1 factors", "2x2 factors"}));
  EXPECT_EQ(lines({"--pdf", "own, adaptive mode=reject nQT=3, Disk", "--trees", "3,5"}),
            (Names{"own", "adaptive mode=reject nQT=3, 3 trees", "adaptive mode=reject nQT=3, 5 trees",
                   "Disk, 3 trees", "Disk, 5 trees"}));
  EXPECT_EQ(lines({"--points", "sobol,independent", "--precision", "float,double"}),
            (Names{"sobol, float", "sobol, double", "independent, float", "independent, double"}));
}

// The formulas agree to a few ulps, and so do estimates from the same random numbers.
TEST_F(BptCost, DoubleGivesWhatFloatGives) {
  const std::string scene = write("scene.grf", Glossy);
  for (const char* precision : {"float", "double"}) {
    ASSERT_EQ(bpt({"render", scene, "--size", "16x12", "--samples", "16", "--precision", precision,
                   "--output", path(std::string(precision) + ".pfm")})
                  .exit_code,
              0);
  }
  const json error = json::parse(bpt({"compare", path("double.pfm"), path("float.pfm"), "--json"}).out);
  EXPECT_LT(error["relmse"].get<double>(), 1e-9);
  EXPECT_GT(error["relmse"].get<double>(), 0) << "or it would not be another precision";
}

// Convergence is tested over samples and not over time, which depends on the load of the machine.
TEST_F(BptCost, ErrorsOfIndependentPointsFallWithTheRootOfTheirNumber) {
  const json study =
      report(write("scene.grf", Corner), {"--size", "40x40", "--samples", "4,16,64,256", "--points",
                                          "independent,sobol", "--depth", "3", "--seed", "1"});
  const auto exponent = [&](std::size_t line) {
    return study["fits"][line]["exponent_over_samples"].get<double>();
  };
  EXPECT_NEAR(exponent(0), 0.5, 0.03);
  EXPECT_GT(exponent(1), exponent(0) + 0.05);
  EXPECT_LT(study["rows"][7]["relmse"].get<double>(), study["rows"][3]["relmse"].get<double>());
}

TEST_F(BptCost, KeepsTheRowsSoFar) {
  const std::string scene = write("scene.grf", Corner);
  ASSERT_EQ(bpt({"render", scene, "--size", "64x48", "--output", path("reference.pfm")}).exit_code, 0);
  const Outcome outcome = test::run(
      {GRANADA_BIN_DIR "/bpt", "cost", scene, "--size", "64x48", "--output", path("study"), "--samples",
       "1,2,10000000", "--reference", path("reference.pfm"), "--pdf", "Own", "--json", "--rounds", "1000"},
      {}, {{SIGINT, std::chrono::milliseconds(700)}});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_LT(json::parse(outcome.out)["rows"].size(), 3U);
  for (const char* ending : {".csv", ".md", ".svg"})
    EXPECT_TRUE(std::filesystem::exists(path("study") + ending));
}

TEST_F(BptCost, SaysWhatIsWrong) {
  expect_error({"--samples", "4,2"}, 2, "--samples: found '2', expected ascending");
  expect_error({"--samples", "1,x"}, 2, "--samples: found 'x', expected ascending");
  expect_error({"--pdf", "Own,nonsense"}, 2, "nonsense");
  expect_error({"--pdf", "Own,own"}, 2, "measured twice");
  expect_error({"--pdf", "Own", "--trees", "3"}, 2, "--trees: no scheme in --pdf uses it");
  expect_error({"--depth", "1,many"}, 2, "--depth: ");
  expect_error({"--rounds", "0"}, 2, "--rounds");
  expect_error({"--reference", path("none.exr")}, 1, "cannot read the file");
  expect_error({"--pdf", "Disk,hemisphere nonsense=1"}, 2, "nonsense");
  const std::string reference = write("grey.pfm", "Pf\n1 1\n-1.0\n" + std::string(4, '\0'));
  expect_error({"--reference", reference, "--size", "4x4"}, 1,
               "the reference has 1 x 1 pixels, expected 4 x 4");
  const Outcome no_folder = bpt({"cost", path("scene.grf"), "--output", path("none/study")});
  EXPECT_EQ(no_folder.exit_code, 1);
  EXPECT_NE(no_folder.err.find("cannot write into the folder"), std::string::npos) << no_folder.err;
  const std::string op = write("grid.op", "BPT_Scene scene.grf\nBPT_Pixel_SampleRes 2 2\n");
  const Outcome outcome = cost(op, {"--integrator", "naive", "--samples", "6"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("multiples of 4"), std::string::npos) << outcome.err;
}

}  // namespace
