// Tests of `bpt noise`.
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

TEST_F(BptNoise, TriesOtherSettings) {
  const Outcome outcome = bpt({"noise", op_, "--try", "--json", "--branches", "4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json tried = json::parse(outcome.out)["tried"];
  ASSERT_EQ(tried.size(), 2U) << "four branches are what there is";
  for (const json& one : tried) {
    EXPECT_NEAR(one["variance"].get<double>() * one["time"].get<double>(), one["cost"].get<double>(), 1e-9);
  }
  EXPECT_EQ(tried[0]["value"], "adaptive");
  EXPECT_EQ(tried[1]["flag"], "--branches");
  EXPECT_GT(tried[1]["variance"].get<double>(), 1) << "one branch has more noise than four";
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
