// The numbers of study tools agree with those of the command line; subdivision_tool_test.cpp compares
// samples.
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/studies/study_of_text.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

nlohmann::json bpt_brdf(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {std::string(GRANADA_BIN_DIR) + "/bpt", "brdf"});
  arguments.emplace_back("--json");
  const test::Outcome outcome = test::run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

/// The rows of a CSV text without its header, as fields.
std::vector<std::vector<std::string>> fields_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

// `fitplot` lists the BRDF's own value of each direction, which `eval` prints, too.
TEST(StudiesAndCommandLine, EvaluateTheSameValues) {
  const std::string brdf = "ashikhmin nu=20 nv=80 ks=(0.2, 0.3, 0.4) kd=0.3";
  const test::TemporaryFolder folder;
  bpt_brdf(
      {"sample", brdf, "--pdf", "auto", "--u", "0.7,0.4", "--count", "20", "--fit", folder.path("a.fit")});
  const auto study = test::study_of_text("tool fitplot\nfile a.fit\n", folder.path("a.study"));
  const auto rows = fields_of(study.csv);
  ASSERT_GT(rows.size(), 10U);
  for (std::size_t i = 0; i < rows.size(); i += 5) {
    const double x = std::stod(rows[i][1]);
    const double y = std::stod(rows[i][2]);
    const double z = std::stod(rows[i][3]);
    const auto values = bpt_brdf({"eval", brdf, "--u", "0.7,0.4", "--v",
                                  fmt::format("{:.9g},{:.9g}", std::acos(z), std::atan2(y, x))})["values"][0];
    const double mean = (values[0].get<double>() + values[1].get<double>() + values[2].get<double>()) / 3;
    EXPECT_NEAR(std::stod(rows[i][5]), mean, 2e-4 * mean);
  }
}

// Under a constant sky of radiance 1, the quadrature of `emviewer` is the albedo.
TEST(StudiesAndCommandLine, ComputeTheSameAlbedo) {
  const test::TemporaryFolder folder;
  std::string map = "PF\n8 4\n-1.0\n";
  const float one = 1;
  for (int i = 0; i < 8 * 4 * 3; ++i) map.append(reinterpret_cast<const char*>(&one), sizeof one);
  folder.add("white.pfm", map);
  for (const char* brdf : {"ward sx=0.2 sy=0.2 ks=0.4 kd=0.3", "oren s=0.4 r=0.8"}) {
    const auto albedo =
        bpt_brdf({"albedo", brdf, "--u", fmt::format("{}", 40 * std::acos(-1.0) / 180)})["albedo"];
    const auto study = test::study_of_text(
        fmt::format("tool emviewer theta=40 deviations=false\nbrdf {}\npdf auto\nfile white.pfm\n", brdf),
        folder.path("a.study"));
    const std::size_t at = study.summary.find("by resampling and ") + 18;
    EXPECT_NEAR(std::stod(study.summary.substr(at)), albedo[0].get<double>(), 2e-3) << study.summary;
  }
}

// `bpt brdf plot` says of a FIT file what `fitplot` says, also where its values are not the BRDF's own.
TEST(StudiesAndCommandLine, SayTheSameOfAPlot) {
  const test::TemporaryFolder folder;
  const std::string fit = folder.path("a.fit");
  bpt_brdf({"sample", "ward sx=0.1", "--pdf", "auto", "--u", "0.6,0.2", "--count", "50", "--fit", fit});
  std::string other = test::bytes_of(fit);
  other.replace(other.find("sx=0.1"), 6, "sx=0.3");
  folder.add("b.fit", other);
  std::vector<std::string> said;
  for (const std::string name : {"a.fit", "b.fit"}) {
    const auto plotted = bpt_brdf({"plot", folder.path(name), "-o", folder.path("plot.svg")});
    const auto study =
        test::study_of_text(fmt::format("tool fitplot\nfile {}\n", name), folder.path("a.study"));
    EXPECT_EQ(plotted["summary"], study.summary);
    said.push_back(study.summary);
  }
  EXPECT_THAT(said[0], testing::HasSubstr("all values agree with the BRDF"));
  EXPECT_THAT(said[1], testing::Not(testing::HasSubstr("all values agree with the BRDF")));
}

}  // namespace
