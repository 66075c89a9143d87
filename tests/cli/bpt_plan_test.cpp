// Tests of `bpt plan` and the flags that choose effects.
#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/cli/bpt.h"

namespace {

using nlohmann::json;
using test::Bpt;
using test::Outcome;

const std::string WallAndWallOutOfView =
    "begin mesh brdf ward pdf cascadecdf begin vertexs (-1,-1,0)(1,-1,0)(1,1,0)(-1,1,0) end vertexs "
    "begin faces (0,1,2,3) end faces end mesh "
    "begin mesh brdf blinn pdf cascadecdf texture \"wood.png\" begin vertexs "
    "(-1,-8,9)(1,-8,9)(1,-8,1)(-1,-8,1) end vertexs begin faces (0,1,2,3) end faces end mesh "
    "light begin rgb (2,3,4) (-1,2,0.5) (2,0,0) (0,0,2) end";

json effect(const json& report, const std::string& name) {
  for (const json& one : report["effects"]) {
    if (one["name"] == name) return one;
  }
  return {};
}

class BptPlan : public Bpt {
 protected:
  BptPlan() {
    write("scene.grf", WallAndWallOutOfView);
    op_ = write("scene.op", "BPT_Scene scene.grf\nBPT_Viewer 0 0 4\nBPT_VLook 0 0 0\n");
  }

  json plan(std::vector<std::string> flags) const {
    flags.insert(flags.begin(), {"plan", op_, "--json"});
    const Outcome outcome = bpt(flags);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  std::string op_;
};

TEST_F(BptPlan, SaysWhatIsLeftOutAndWhatThatSaves) {
  const json report = plan({"--depth", "1"});
  EXPECT_EQ(report["depth"], 1);
  EXPECT_TRUE(effect(report, "area_lights")["needed"].get<bool>());
  EXPECT_FALSE(effect(report, "textures")["needed"].get<bool>());
  EXPECT_EQ(effect(report, "textures")["why"],
            "only on 1 face that no path hits: outside the view, and the depth of 1 allows no second bounce");
  ASSERT_EQ(report["tables"].size(), 2U);
  for (const json& table : report["tables"]) {
    EXPECT_EQ(table["pdf"], "cascadecdf");
    EXPECT_GT(table["bytes"].get<int>(), 1000);
    EXPECT_EQ(table["needed"].get<bool>(), table["brdf"] == "ward");
  }
  EXPECT_EQ(report["saved"]["table_bytes"], report["tables"][1]["bytes"]);
  EXPECT_EQ(report["textures"][0]["file_bytes"], nullptr) << "there is no such file";
}

// Names in files are bytes, and JSON is text in UTF-8.
TEST_F(BptPlan, ReplacesBytesOfNamesThatAreNotUtf8) {
  write("scene.grf",
        "begin mesh \"a\xff\" light rgb (1,1,1) begin vertexs (-1,-1,0)(1,-1,0)(1,1,0)(-1,1,0) end vertexs "
        "begin faces (0,1,2,3) end faces end mesh");
  const json report = plan({});
  EXPECT_THAT(report.dump(), testing::HasSubstr("a\xef\xbf\xbd"));
}

TEST_F(BptPlan, IsWhatARenderDoes) {
  const auto render = [&](const std::string& depth) {
    return bpt({"render", op_, "--size", "16x16", "--samples", "1", "--depth", depth, "--output",
                path("a.pfm"), "--json"});
  };
  const Outcome direct = render("1");
  ASSERT_EQ(direct.exit_code, 0) << direct.err;
  const json summary = json::parse(direct.out);
  EXPECT_EQ(summary["effects"], std::vector<std::string>{"area_lights"});
  const auto& left_out = summary["left_out"];
  const auto has = [&](const std::string& name) {
    return std::any_of(left_out.begin(), left_out.end(),
                       [&](const json& one) { return one["name"] == name; });
  };
  EXPECT_TRUE(has("texture wood.png"));
  EXPECT_TRUE(has("table of blinn for cascadecdf"));
  EXPECT_TRUE(has("mirror_reflection"));
  EXPECT_EQ(summary["saved"]["tables"], 1);
  EXPECT_EQ(summary["saved"]["scatterings"], 0);
  // With a second bounce the texture is needed, and its file is missing.
  EXPECT_EQ(render("2").exit_code, 1);
  EXPECT_TRUE(plan({"--depth", "2"})["textures"][0]["needed"].get<bool>());
}

TEST_F(BptPlan, IsPrintedAsText) {
  const Outcome outcome = bpt({"plan", op_, "--depth", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* text : {"+ area_lights", "- textures", "depth 1", "saved: ", "no such file"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text << "\n" << outcome.out;
  }
}

TEST_F(BptPlan, FollowsTheFlagsOfEffects) {
  EXPECT_EQ(plan({"--without", "textures,area_lights"})["effects"][0]["why"], "it is switched off");
  const json only = plan({"--only", "direct"});
  EXPECT_EQ(only["depth"], 1);
  EXPECT_EQ(effect(only, "glossy_interreflection")["why"], "it is switched off");
  EXPECT_EQ(plan({"--kernel", "full", "--without", "textures"})["depth"], 5);
}

TEST_F(BptPlan, SuggestsTheNameOfAnEffect) {
  for (const char* flag : {"--only", "--without"}) {
    const Outcome outcome = bpt({"plan", op_, flag, "texture"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("did you mean 'textures'"), std::string::npos) << outcome.err;
  }
}

TEST_F(BptPlan, FindsWhatIsWrongWithAScene) {
  write("scene.grf", "begin mesh brdf warp begin");
  EXPECT_EQ(bpt({"plan", op_}).exit_code, 1);
  EXPECT_EQ(bpt({"plan", path("missing.op")}).exit_code, 1);
}

TEST_F(BptPlan, NamesTheSurfacesThatCallForAnEffect) {
  const json report = plan({"--depth", "1"});
  EXPECT_EQ(effect(report, "area_lights")["places"], json::parse(R"([{"light": 0}])"));
  EXPECT_EQ(effect(report, "textures")["places"], json::array()) << "no path hits them";
  write(
      "scene.grf",
      "light begin rgb (0,0,0) (-1,3,0.5) (2,0,0) (0,0,2) end begin mesh \"wall\" brdf diffuse begin vertexs "
      "(-1,-1,0)(1,-1,0)(1,1,0)(-1,1,0) end vertexs begin faces (0,1,2) light rgb (4,4,4) (0,2,3) end faces "
      "end mesh light begin rgb (2,3,4) (-1,2,0.5) (2,0,0) (0,0,2) end");
  EXPECT_EQ(effect(plan({"--depth", "1"}), "area_lights")["places"],
            json::parse(R"([{"mesh": "wall", "surface": 1}, {"light": 1}])"));
}

// The only light is the background of 1: without it, nothing is left. A white diffuse plane with vertices of
// half that colour is twice as bright without them, see effect_measurement_test.
class BptPlanMeasured : public BptPlan {
 protected:
  BptPlanMeasured() {
    write(
        "scene.grf",
        "begin mesh brdf diffuse kd=0.8 begin vertexs rgb (0.5,0.5,0.5) (-9,-9,0) rgb (0.5,0.5,0.5) (9,-9,0) "
        "rgb (0.5,0.5,0.5) (9,9,0) rgb (0.5,0.5,0.5) (-9,9,0) end vertexs begin faces (0,1,2,3) end faces "
        "end "
        "mesh");
    write("scene.op", "BPT_Scene scene.grf\nBPT_Viewer 0 0 4\nBPT_VLook 0 0 0\nBPT_Background 1 1 1\n");
  }
};

TEST_F(BptPlanMeasured, TellsShareAndInterval) {
  const json report = plan({"--size", "64x48", "--measure", "--measure-seconds", "0.1"});
  const json& measurement = report["measurement"];
  EXPECT_EQ(measurement["width"], 64);
  EXPECT_EQ(measurement["height"], 48);
  EXPECT_EQ(measurement["probability"], 0.95);
  EXPECT_TRUE(measurement["complete"].get<bool>());
  ASSERT_EQ(measurement["effects"].size(), 2U);
  const json& background = measurement["effects"][0];
  EXPECT_EQ(background["name"], "background");
  EXPECT_EQ(background["light"]["share"], 1);
  EXPECT_EQ(background["light"]["interval"], (std::vector<double>{1, 1}));
  const json& colours = measurement["effects"][1];
  EXPECT_EQ(colours["name"], "vertex_colours");
  EXPECT_NEAR(colours["light"]["share"].get<double>(), -1, 0.02);
  EXPECT_NEAR(colours["difference"].get<double>(), 1, 0.02);
  EXPECT_LE(colours["time"]["interval"][0], colours["time"]["share"]);
  EXPECT_GE(colours["time"]["interval"][1], colours["time"]["share"]);
}

TEST_F(BptPlanMeasured, PrintsLinesAndWritesImages) {
  const Outcome lines = bpt({"plan", op_, "--size", "64x48", "--measure", "--measure-seconds", "0.1",
                             "--json", "--progress", "json", "--measure-images", path("new/images")});
  ASSERT_EQ(lines.exit_code, 0) << lines.err;
  EXPECT_EQ(std::count(lines.out.begin(), lines.out.end(), '\n'), 3) << lines.out;
  const json first = json::parse(lines.out.substr(0, lines.out.find('\n')));
  EXPECT_EQ(first["measured"]["name"], "background");
  for (const char* name : {"background_full.exr", "background_without.exr", "vertex_colours_full.exr"}) {
    EXPECT_TRUE(std::filesystem::exists(path(std::string("new/images/") + name))) << name;
  }
  const Outcome text = bpt({"plan", op_, "--size", "64x48", "--measure", "--measure-seconds", "0.1"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("background              100.0 % (100.0 to 100.0)"), std::string::npos) << text.out;
}

/// A closed room of white walls that glow: each bounce looks the same.
class BptPlanOfATarget : public Bpt {
 protected:
  BptPlanOfATarget() {
    write("room.grf",
          "begin mesh brdf diffuse kd=0.6 begin vertexs (-1,-1,-1) (1,-1,-1) (1,1,-1) (-1,1,-1) (-1,-1,1) "
          "(1,-1,1) (1,1,1) (-1,1,1) end vertexs begin faces light rgb (1,1,1) (0,1,2,3) (4,7,6,5) (0,4,5,1) "
          "(2,6,7,3) (0,3,7,4) (1,5,6,2) end faces end mesh");
    op_ = write(
        "room.op",
        "BPT_Scene room.grf\nBPT_Image_Resolution 64 48\nBPT_Viewer 0 0 0.9\nBPT_VLook 0 0 0\nBPT_Depth 4\n");
  }

  json run(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const Outcome outcome = bpt(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  json render(std::vector<std::string> flags) const {
    flags.insert(flags.begin(), {"render", op_, "--output", path("room.pfm")});
    return run(flags);
  }

  std::string op_;
};

TEST_F(BptPlanOfATarget, SaysWhichBouncesItLeavesOut) {
  EXPECT_EQ(run({"plan", op_})["target_error"], nullptr);
  const json report = run({"plan", op_, "--target-error", "0.1"});
  const json& target = report["target_error"];
  EXPECT_NEAR(target["target"].get<double>(), 0.1, 1e-6);
  EXPECT_EQ(target["bias_part"], 0.25);
  EXPECT_EQ(target["depth"], 1);
  ASSERT_EQ(target["bounces"].size(), 3U);
  const json& direct = target["bounces"][0];
  EXPECT_EQ(direct["depth"], 1);
  EXPECT_LT(direct["bias_interval"][1], 0.025);
  EXPECT_NEAR(direct["last_bounce_factor"][0].get<double>(), 1 + 0.6 + 0.36 + 0.216, 0.05);
  EXPECT_EQ(report["depth"], 1);
  EXPECT_EQ(report["saved"]["scatterings"], 3);
  EXPECT_THAT(report["why_depth"].get<std::string>(),
              testing::HasSubstr("less than 25 % of the target error"));
  const Outcome text = bpt({"plan", op_, "--target-error", "0.1"});
  EXPECT_THAT(text.out, testing::HasSubstr("target error 10 %, of which the bias may be 2.5 %"));
  EXPECT_THAT(text.out, testing::HasSubstr("\n+ depth 1: "));
}

TEST_F(BptPlanOfATarget, IsWhatARenderDoes) {
  const json summary = render({"--target-error", "0.1"});
  ASSERT_EQ(summary["left_out"].back()["name"], "bounces 2 to 4");
  EXPECT_GT(summary["bias_interval"][1], 0);
  EXPECT_LT(summary["bias_interval"][1], 0.025);
  EXPECT_LE(summary["estimated_error"], 0.1);
}

// A render may go on from a checkpoint to a smaller target, for which all bounces could be needed.
TEST_F(BptPlanOfATarget, LeavesOutNothingWhereAllIsNeeded) {
  for (const std::vector<std::string>& flags :
       {std::vector<std::string>{"--samples", "16"},
        {"--target-error", "0.1", "--kernel", "full"},
        {"--target-error", "0.1", "--checkpoint", path("room.checkpoint")}}) {
    const json summary = render(flags);
    EXPECT_EQ(summary["bias"], 0);
    for (const json& one : summary["left_out"]) {
      EXPECT_EQ(one["name"].get<std::string>().find("bounces"), std::string::npos) << one;
    }
  }
}

}  // namespace
