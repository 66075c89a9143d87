// Tests of `bpt cost`, and unit tests of its fit.
#include <cmath>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "renderer/command/cost_efficiency.h"
#include "renderer/command/cost_fit.h"
#include "renderer/image/image.h"
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

// Two rounds whose efficiencies are e and e^3 have the mean e^2, and the logarithm's standard error is 1:
// Student's quantile for one degree of freedom is 12.706.
TEST(CostEfficiency, HasStudentsInterval) {
  const command::CostRounds line = {{4, {{0.5, 2 * std::exp(-1)}, {2, 0.5 * std::exp(-3)}}}};
  const auto efficiency = command::efficiencies_of(std::vector{line}, 0).front();
  ASSERT_TRUE(efficiency);
  EXPECT_NEAR(efficiency->value, std::exp(2), 1e-9);
  EXPECT_NEAR(std::log(efficiency->low), 2 - 12.706, 1e-9);
  EXPECT_NEAR(std::log(efficiency->high), 2 + 12.706, 1e-9);
}

TEST(CostEfficiency, ComparesWhereAllLinesAreWellAboveTheReference) {
  const command::CostRounds good = {{1, {{1, 1}, {1, 1}}}, {4, {{1, 0.001}, {1, 0.001}}}};
  const command::CostRounds bad = {{1, {{1, 4}, {1, 4}}}, {4, {{1, 4}, {1, 4}}}, {8, {{1, 1}, {1, 1}}}};
  const auto efficiencies = command::efficiencies_of(std::vector{good, bad}, 0.01);
  EXPECT_NEAR(efficiencies[0].value().value, 1, 1e-12) << "its second row is the reference's error";
  EXPECT_NEAR(efficiencies[1].value().value, 0.25, 1e-12) << "the first line has no row of 8 samples";
  EXPECT_EQ(command::winner_of(efficiencies), 0U);
  EXPECT_FALSE(command::efficiencies_of(std::vector{command::CostRounds{{1, {{1, 1}}}}}, 0)[0])
      << "one round has no interval";
}

TEST(CostEfficiency, HasNoWinnerIfIntervalsOverlap) {
  using Efficiencies = std::vector<std::optional<command::CostEfficiency>>;
  const auto winner = [](const Efficiencies& efficiencies) { return command::winner_of(efficiencies); };
  EXPECT_EQ(winner({{{2, 1.9, 2.1}}, {{3, 2.2, 4}}, {{1, 0.1, 2}}}), 1U);
  EXPECT_FALSE(winner({{{2, 1.9, 2.3}}, {{3, 2.2, 4}}}));
  EXPECT_FALSE(winner({{{2, 1.9, 2.1}}, {{3, 2.2, 4}}, {{2.5, 0.1, 9}}})) << "the third may be better";
  EXPECT_FALSE(winner({{{2, 1.9, 2.1}}, {}}));
  EXPECT_FALSE(winner({{{2, 1.9, 2.1}}}));
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

/// A shiny plate, seen by naive path tracing: directions by the cosine seldom meet the lamp's reflection, the
/// lobe's own sampler finds it with each one.
const std::string Shiny =
    "begin mesh brdf ward sx=0.05 ks=0.5 kd=0\n"
    "begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs\n"
    "begin faces (0,1,2,3) end faces end mesh\n"
    "light begin (0,0,0.6) (0,1,0) (1,0,0) end\n";
const std::vector<std::string> OwnOrDiffuse = {"--size",      "32x24",     "--integrator", "naive",  "--pdf",
                                               "Own,Diffuse", "--samples", "4,16,64",      "--seed", "1"};

TEST_F(BptCost, NamesTheWinner) {
  std::vector<std::string> arguments = OwnOrDiffuse;
  arguments.insert(arguments.end(), {"--rounds", "5"});
  const std::string scene = write("scene.grf", Shiny);
  const json study = report(scene, arguments);
  EXPECT_EQ(study["winner"], "Own");
  const json& own = study["fits"][0]["efficiency"];
  const json& cosine = study["fits"][1]["efficiency"];
  EXPECT_GT(own["low"].get<double>(), cosine["high"].get<double>());
  const json op = study["fits"][0]["op"];
  EXPECT_NE(std::find(op.begin(), op.end(), "BPT_Pdf_Name Own"), op.end());
  EXPECT_NE(std::find(op.begin(), op.end(), "BPT_Integrator naive"), op.end());
  EXPECT_NE(test::bytes_of(path("study.md")).find("Own is the most efficient"), std::string::npos);
  EXPECT_EQ(json::parse(test::bytes_of(path("study.json"))), study);
}

TEST_F(BptCost, ContinuesAStudy) {
  const std::string scene = write("scene.grf", Shiny);
  std::vector<std::string> arguments = OwnOrDiffuse;
  arguments.insert(arguments.end(), {"--rounds", "2"});
  const json first = report(scene, arguments);
  arguments = OwnOrDiffuse;
  arguments[5] = "Diffuse,Own,Hemisphere";
  arguments.insert(arguments.end(),
                   {"--rounds", "3", "--continue", path("study.json"), "--progress", "json"});
  const Outcome outcome = cost(scene, arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json second = json::parse(test::bytes_of(path("study.json")));
  ASSERT_EQ(second["rows"].size(), 9U);
  EXPECT_EQ(second["reference"]["error"], first["reference"]["error"]);
  for (const json& row : second["rows"]) {
    ASSERT_EQ(row["rounds"].size(), 3U);
    const std::vector<std::uint32_t> seeds = row["seeds"];
    EXPECT_EQ(std::set<std::uint32_t>(seeds.begin(), seeds.end()).size(), 3U);
    for (const json& before : first["rows"]) {
      if (before["settings"] != row["settings"] || before["samples"] != row["samples"]) continue;
      for (std::size_t round = 0; round < 2; ++round) {
        EXPECT_EQ(row["rounds"][round], before["rounds"][round]);
        EXPECT_EQ(row["seeds"][round], before["seeds"][round]);
      }
    }
  }
  std::istringstream lines(outcome.out);
  std::string line;
  std::size_t studies = 0;
  while (std::getline(lines, line)) studies += json::parse(line).contains("rows") ? 1 : 0;
  EXPECT_GE(studies, 1U);
  EXPECT_LE(studies, 3U + 3 * 3 + 3) << "2 x 3 rows lack a round, and 3 rows lack all three";
  arguments[1] = "24x24";
  const Outcome refused = cost(scene, arguments);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("the study is of another scene"), std::string::npos) << refused.err;
}

// Two parts of a study, merged, have all of its lines; nothing is measured again.
TEST_F(BptCost, MergesTheParts) {
  const std::string scene = write("scene.grf", Shiny);
  const std::string reference = path("reference.pfm");
  ASSERT_EQ(bpt({"render", scene, "--size", "32x24", "--samples", "64", "-o", reference}).exit_code, 0);
  std::vector<std::string> arguments = OwnOrDiffuse;
  arguments[5] = "Own,Diffuse,Hemisphere";
  arguments.insert(arguments.end(), {"--reference", reference});
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), arguments.begin(), arguments.end());
    more.insert(more.begin(), {"cost", scene});
    return bpt(more);
  };
  ASSERT_EQ(with({"--part", "1/2", "--output", path("a")}).exit_code, 0);
  ASSERT_EQ(with({"--part", "2/2", "--output", path("b")}).exit_code, 0);
  const json a = json::parse(test::bytes_of(path("a.json")));
  const json b = json::parse(test::bytes_of(path("b.json")));
  EXPECT_EQ(line_names(a), (std::vector<std::string>{"Own", "Hemisphere"}));
  EXPECT_EQ(line_names(b), std::vector<std::string>{"Diffuse"});
  EXPECT_NE(a["rows"][0]["seeds"], b["rows"][0]["seeds"]) << "their noise is independent";
  const std::vector<std::string> both = {"--continue",   path("a.json"), "--continue",
                                         path("b.json"), "--output",     path("both")};
  ASSERT_EQ(with(both).exit_code, 0);
  const json study = json::parse(test::bytes_of(path("both.json")));
  ASSERT_EQ(study["rows"].size(), 9U);
  const auto expect_same = [](const json& row, const json& of_part) {
    for (const char* name : {"line", "samples", "seeds", "rounds"}) EXPECT_EQ(row[name], of_part[name]);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    expect_same(study["rows"][i], a["rows"][i]);
    expect_same(study["rows"][3 + i], b["rows"][i]);
    expect_same(study["rows"][6 + i], a["rows"][3 + i]);
  }
  EXPECT_EQ(line_names(study), (std::vector<std::string>{"Own", "Diffuse", "Hemisphere"}));

  const Outcome alone = with({"--part", "4/4", "--output", path("c")});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.err, testing::HasSubstr("expected at most 3 parts"));
  ASSERT_EQ(bpt({"render", scene, "--size", "32x24", "--samples", "8", "-o", reference}).exit_code, 0);
  const Outcome other = with(both);
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err,
              testing::HasSubstr("a.json: error: the study was measured against another reference"));
  arguments.resize(arguments.size() - 2);
  EXPECT_THAT(with({"--part", "1/2"}).err, testing::HasSubstr("share a reference"));
  EXPECT_THAT(with(both).err, testing::HasSubstr("give it by --reference"));
}

// The pixels of a crop window have the values that they have in the whole image.
TEST_F(BptCost, MeasuresARegion) {
  const std::string scene = write("scene.grf", Glossy);
  const std::vector<std::string> small = {"--size", "16x12", "--samples", "2,4", "--reference-samples", "32"};
  report(scene, small);
  grf::Diagnostics diagnostics;
  const auto whole = image::read_image(path("study-reference.pfm"), diagnostics);
  std::vector<std::string> cropped = small;
  cropped.insert(cropped.end(), {"--crop", "5", "3", "6", "4"});
  const json study = report(scene, cropped);
  EXPECT_EQ(study["crop"], (json{5, 3, 6, 4}));
  const auto part = image::read_image(path("study-reference.pfm"), diagnostics);
  ASSERT_TRUE(whole && part) << diagnostics.to_text();
  ASSERT_EQ(part->width, 6);
  ASSERT_EQ(part->height, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 6; ++x) {
      EXPECT_EQ(part->pixels[static_cast<std::size_t>(6 * y + x)],
                whole->pixels[static_cast<std::size_t>(16 * (y + 3) + x + 5)]);
    }
  }
  const Outcome outside = cost(scene, {"--size", "16x12", "--crop", "12", "0", "6", "4"});
  EXPECT_EQ(outside.exit_code, 2);
  EXPECT_NE(outside.err.find("--crop: expected pixels of the image, which has 16 x 12"), std::string::npos);
}

TEST_F(BptCost, SaysWhatIsWrong) {
  expect_error({"--samples", "4,2"}, 2, "--samples: found '2', expected ascending");
  expect_error({"--samples", "1,x"}, 2, "--samples: found 'x', expected ascending");
  expect_error({"--pdf", "Own,nonsense"}, 2, "nonsense");
  expect_error({"--pdf", "Own,own"}, 2, "measured twice");
  expect_error({"--pdf", "Own", "--trees", "3"}, 2, "--trees: no scheme in --pdf uses it");
  expect_error({"--depth", "1,many"}, 2, "--depth: ");
  expect_error({"--rounds", "0"}, 2, "--rounds");
  expect_error({"--continue", write("none.json", "{}")}, 1, "expected the JSON of a study");
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
