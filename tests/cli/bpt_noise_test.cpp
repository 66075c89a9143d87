// Tests of `bpt noise`.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/cli/bpt.h"

namespace {

using nlohmann::json;
using test::Bpt;
using test::Outcome;
using testing::HasSubstr;

// A floor under a lamp, with a wall behind it that hides another lamp.
const std::string Scene = R"(light begin rgb (5, 5, 5) (-1, 3, -1) (2, 0, 0) (0, 0, 2) end
light begin rgb (9, 9, 9) (-1, 3, -9) (2, 0, 0) (0, 0, 2) end
begin mesh "glow"
  brdf diffuse kd=0
  light rgb (1, 2, 3)
  begin vertexs (1, 0.1, 0) (1.5, 0.1, 0) (1.5, 0.6, 0) (1, 0.6, 0) end vertexs
  begin faces (0, 1, 2, 3) end faces
end mesh
begin mesh
  brdf ward sx=0.2 ks=0.3 kd=0.4
  begin vertexs (-20, 0, 2) (20, 0, 2) (20, 0, -2) (-20, 0, -2) (-20, 40, -2) (20, 40, -2) end vertexs
  begin faces (0, 1, 2, 3) (3, 2, 5, 4) end faces
end mesh
)";

class BptNoise : public Bpt {
 protected:
  BptNoise() {
    write("scene.grf", Scene);
    op_ = write("scene.op",
                "BPT_Scene scene.grf\nBPT_Viewer 0 2 6\nBPT_VLook 0 0.5 0\nBPT_Image_Resolution 40 "
                "30\nBPT_Samples 4\n");
  }

  std::string op_;
};

double sum_of(const json& list, const char* value) {
  double sum = 0;
  for (const json& one : list) sum += one[value].get<double>();
  return sum;
}

TEST_F(BptNoise, IsSharedOutToLampsBouncesAndBrdfs) {
  const Outcome outcome = bpt({"noise", op_, "--json", "--depth", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["width"], 40);
  EXPECT_EQ(report["samples"], 4);
  EXPECT_GT(report["error"].get<double>(), 0.001);
  for (const char* list : {"lamps", "bounces", "brdfs"}) {
    EXPECT_NEAR(sum_of(report[list], "noise"), 1, 1e-9) << list;
    EXPECT_NEAR(sum_of(report[list], "light"), 1, 1e-9) << list;
  }
  std::vector<std::string> lamps;
  for (const json& lamp : report["lamps"]) lamps.push_back(lamp["name"]);
  EXPECT_THAT(lamps, testing::UnorderedElementsAre("lamp, line 1", "lamp 'glow', line 3"))
      << "the lamp behind the wall adds no light";
  EXPECT_EQ(report["bounces"].size(), 3U);
  EXPECT_FALSE(report.contains("tried"));
}

TEST_F(BptNoise, SaysWhereItsPartsAre) {
  const Outcome outcome = bpt({"noise", op_, "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  for (const json& lamp : report["lamps"]) {
    const bool is_mesh = lamp["name"] == "lamp 'glow', line 3";
    EXPECT_EQ(lamp["kind"], is_mesh ? "mesh" : "area light");
    EXPECT_EQ(lamp["number"], 0) << "the first of its kind";
  }
  bool has_ward = false;
  for (const json& brdf : report["brdfs"]) {
    if (brdf.value("brdf", "") != "ward sx=0.2 ks=0.3 kd=0.4") continue;
    has_ward = true;
    EXPECT_EQ(brdf["scheme"], "auto");
  }
  EXPECT_TRUE(has_ward) << report["brdfs"].dump();
  ASSERT_FALSE(report["advice"].empty());
  const json& first = report["lamps"][0];
  const std::string advice = report["advice"][0];
  EXPECT_THAT(advice, testing::StartsWith(first["kind"] == "mesh" ? "The lamp 'glow' in line 3 makes "
                                                                  : "The lamp in line 1 makes "));
  EXPECT_THAT(advice,
              HasSubstr(std::to_string(std::lround(100 * first["noise"].get<double>())) + " % of the noise"));
}

const json* find(const json& list, const std::string& change) {
  for (const json& one : list) {
    if (one["change"] == change) return &one;
  }
  return nullptr;
}

TEST_F(BptNoise, TriesOtherSettings) {
  const Outcome outcome =
      bpt({"noise", op_, "--try", "--json", "--branches", "4", "--points", "independent"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  const json& tried = report["tried"];
  EXPECT_EQ(tried.size(), report["changes"].size());
  for (const json& one : tried) {
    EXPECT_NEAR(one["variance"].get<double>() * one["time"].get<double>(), one["cost"].get<double>(), 1e-9);
    EXPECT_LE(one["cost_interval"][0], one["cost"]);
    EXPECT_GE(one["cost_interval"][1], one["cost"]);
    EXPECT_THAT(one["advice"].get<std::string>(), HasSubstr(" instead of "));
  }
  EXPECT_EQ(find(tried, "BPT_Branches=4"), nullptr) << "four branches are what there is";
  const json* fewer = find(tried, "BPT_Branches=1");
  ASSERT_NE(fewer, nullptr);
  EXPECT_EQ((*fewer)["flag"], "--branches");
  EXPECT_EQ((*fewer)["before"], "4");
  EXPECT_GT((*fewer)["variance_interval"][0], 1) << "one branch has more noise than four";
  const json* sobol = find(tried, "BPT_Points=sobol");
  ASSERT_NE(sobol, nullptr);
  EXPECT_LT((*sobol)["variance_interval"][1], 1) << "low-discrepancy points have less noise";
  EXPECT_NE(find(tried, "BPT_Adaptive=true"), nullptr);
}

/// A plate with a narrow lobe under a constant sky: cosine-weighted directions seldom meet the lobe, and the
/// BRDF's own sampler meets it always.
class BptNoiseOfALobe : public Bpt {
 protected:
  BptNoiseOfALobe() {
    write("lobe.grf",
          "begin mesh brdf phong n=200 ks=0.9 kd=0 pdf diffuse begin vertexs (-9,0,9) (9,0,9) (9,0,-9) "
          "(-9,0,-9) "
          "end vertexs begin faces (0,1,2,3) end faces end mesh\n");
    op_ = write("lobe.op",
                "BPT_Scene lobe.grf\nBPT_Viewer 0 6 6\nBPT_VLook 0 0 0\nBPT_FieldOfView 30\n"
                "BPT_Background 1 1 1\nBPT_Depth 1\nBPT_Image_Resolution 24 24\nBPT_Samples 16\n");
  }
  std::string op_;
};

TEST_F(BptNoiseOfALobe, IsLessWithTheSchemeThatFitsIt) {
  const json changes = json::parse(bpt({"noise", op_, "--json"}).out)["changes"];
  std::string own;
  for (const json& change : changes) {
    EXPECT_FALSE(change.contains("variance")) << "it was not tried";
    if (change["value"] == "own") own = change["change"];
  }
  ASSERT_NE(own, "");
  const Outcome outcome = bpt({"noise", op_, "--json", "--change", own});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json tried = json::parse(outcome.out)["tried"];
  ASSERT_EQ(tried.size(), 1U);
  EXPECT_EQ(tried[0]["brdf"], "phong n=200 ks=0.9 kd=0");
  EXPECT_EQ(tried[0]["before"], "diffuse");
  // Of cosine-weighted directions one in about (n + 2) / 2 = 101 meets the lobe; of the BRDF's own, which
  // also has a cosine-weighted part, most do.
  EXPECT_LT(tried[0]["variance_interval"][1], 0.3);
  EXPECT_EQ(tried[0]["pays"], true);
  EXPECT_THAT(tried[0]["advice"].get<std::string>(),
              testing::AllOf(HasSubstr("sampled by 'own' instead of 'diffuse': 0."), HasSubstr("it pays")));
  // The same change the other way round costs more.
  const json reverse = json::parse(
      bpt({"noise", op_, "--json", "--pdf", "Own", "--change", "BPT_Pdf_Name=Auto"}).out)["tried"];
  ASSERT_EQ(reverse.size(), 1U);
  EXPECT_EQ(reverse[0]["flag"], "--pdf");
}

TEST_F(BptNoiseOfALobe, IsPrintedLineByLine) {
  const Outcome outcome = bpt({"noise", op_, "--progress", "json", "--try"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const json report = json::parse(line);
  EXPECT_EQ(report["lamps"].size(), 1U) << "the background";
  for (const json& change : report["changes"]) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(json::parse(line)["tried"]["change"], change["change"]);
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST_F(BptNoiseOfALobe, RefusesOtherChanges) {
  const Outcome outcome = bpt({"noise", op_, "--change", "BPT_Depth=3"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--change: found 'BPT_Depth=3', expected one of "));
  EXPECT_THAT(outcome.err, HasSubstr("=own"));
}

TEST_F(BptNoise, PrintsTextAndErrors) {
  const Outcome text = bpt({"noise", op_});
  EXPECT_THAT(text.out, HasSubstr(" noise, % light, %  light from\n"));
  EXPECT_THAT(text.out, HasSubstr("  lamp, line 1\n"));
  EXPECT_THAT(text.out, HasSubstr("  direct light\n"));
  const Outcome naive = bpt({"noise", op_, "--integrator", "naive"});
  EXPECT_EQ(naive.exit_code, 1);
  EXPECT_THAT(naive.err, HasSubstr("for the integrator `path` only"));
  const Outcome dark = bpt({"noise", op_, "--only", "environment"});
  EXPECT_EQ(dark.exit_code, 1);
  EXPECT_THAT(dark.err, HasSubstr("the image has no noise"));
  EXPECT_EQ(bpt({"noise", "no.op"}).exit_code, 1);
}

}  // namespace
