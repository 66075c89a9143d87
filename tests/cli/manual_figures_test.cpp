// The figures of the manual's worked examples are what `bpt` says of the sample scenes.
#include <cmath>
#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

#include "renderer/image/image.h"
#include "tests/cli/bpt.h"

namespace {

using nlohmann::json;
using test::Outcome;
using ManualFigures = test::Bpt;

const std::string Manual = GRANADA_SOURCE_DIR "/editor/MANUAL.md";

/// The rows of the manual's tables that begin with a text, without it: `71 % | 40 %`.
std::string manual_row(const std::string& name) {
  std::ifstream file(Manual);
  for (std::string line; std::getline(file, line);) {
    const std::size_t at = line.find("| " + name + " | ");
    if (at == std::string::npos) continue;
    const std::string rest = line.substr(at + name.size() + 5);
    return rest.substr(0, rest.rfind(" |"));
  }
  return "no row";
}

std::string percentages(const json& part) {
  return std::to_string(std::lround(100 * part["noise"].get<double>())) + " % | " +
         std::to_string(std::lround(100 * part["light"].get<double>())) + " %";
}

// The figures depend on the seed, and not on the machine or its threads.
TEST_F(ManualFigures, NoiseOfTheStillLifeIsThatOfTheManual) {
  const std::string scene = GRANADA_SOURCE_DIR "/samples/authored/still_life.op";
  const Outcome outcome = bpt({"noise", scene, "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(std::lround(1000 * report["error"].get<double>()), 53);
  int rows = 0;
  const auto expect_row = [&rows](const json& part, const std::string& row) {
    const std::string expected = manual_row(row);
    if (expected == "no row") return;
    EXPECT_EQ(percentages(part), expected) << row;
    ++rows;
  };
  for (const json& lamp : report["lamps"]) {
    expect_row(lamp, "Area light " + std::to_string(lamp["number"].get<int>() + 1));
  }
  expect_row(report["bounces"][0], "Direct light");
  expect_row(report["bounces"][1], "Light of 2 bounces");
  for (const json& brdf : report["brdfs"]) expect_row(brdf, "`" + brdf.value("brdf", "") + "`");
  EXPECT_EQ(rows, 6) << "all rows of the table";
  for (const std::string count : {"1", "4"}) {
    const json tried =
        json::parse(bpt({"noise", scene, "--json", "--change", "BPT_Branches=" + count}).out)["tried"];
    char variance[16] = {};
    std::snprintf(variance, sizeof(variance), "%.2f", tried[0]["variance"].get<double>());
    EXPECT_EQ(variance, manual_row("Split count: " + count + " instead of 2"));
  }
  const auto visible = [&](const char* samples) {
    const Outcome render =
        bpt({"render", scene, "--samples", samples, "--json", "--output", path("image.exr")});
    return json::parse(render.out)["visible_difference"]["percentile_95"].get<double>();
  };
  EXPECT_NEAR(visible("16"), 2.3, 0.05);
  EXPECT_NEAR(visible("64"), 0.9, 0.05);
}

/// The mean over pixels and channels of a small render of the garden.
double light_of_garden(const std::string& left_out) {
  const test::TemporaryFolder folder;
  const std::string image = folder.path("image.exr");
  const auto outcome =
      test::run({GRANADA_BIN_DIR "/bpt", "render", GRANADA_SOURCE_DIR "/samples/garden/garden.op", "--size",
                 "160x107", "--samples", "128", "--seed", "7000", "--without", left_out, "--output", image});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  grf::Diagnostics diagnostics;
  const auto read = image::read_image(image, diagnostics);
  if (!read) return 0;
  double sum = 0;
  for (const auto& pixel : read->pixels) sum += static_cast<double>(pixel.x) + pixel.y + pixel.z;
  return sum / (3.0 * static_cast<double>(read->pixels.size()));
}

// The example of what may be left out: separate renders lose as much as the measurement says.
TEST_F(ManualFigures, GardenLosesAsMuchLightAsTheManualSays) {
  const std::string manual = test::bytes_of(Manual);
  const double full = light_of_garden("none");
  for (const std::string name :
       {"environment", "diffuse_interreflection", "glossy_interreflection", "textures", "vertex_colours"}) {
    const std::string start = "| `" + name + "` | ";
    const std::size_t at = manual.find(start);
    ASSERT_NE(at, std::string::npos) << name;
    const double told = std::stod(manual.substr(at + start.size()));
    EXPECT_NEAR(100 * (1 - light_of_garden(name) / full), told, told < 0 ? 0.5 : 0.15) << name;
  }
}

}  // namespace
