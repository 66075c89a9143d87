// The study of the thesis: its scenes, the tables that were copied, and the program.
#include <algorithm>
#include <filesystem>
#include <numeric>
#include <string_view>

#include <gtest/gtest.h>

#include "renderer/plot/svg.h"
#include "renderer/transport/image/image.h"
#include "samples/studies/thesis/printed.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

const std::string Samples = GRANADA_SOURCE_DIR "/samples/";

std::ptrdiff_t lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

// The scenes of the study of the thesis as users have them once `run` has made what is too large to be kept,
// here with a coarse dragon.
TEST(ThesisScenes, AreRendered) {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  const std::string scenes = folder.path("studies/thesis/");
  for (const char* name : {"environments", "studies"}) fs::create_directories(folder.path(name));
  fs::copy(Samples + "environments/studio.exr", folder.path("environments/studio.exr"));
  fs::copy(Samples + "studies/thesis", scenes, fs::copy_options::recursive);
  const std::vector<std::string> mesh = {GRANADA_BIN_DIR "/make_shape", "dragon",   "3000",
                                         scenes + "parts/dragon.grf",   "material", "scheme"};
  ASSERT_EQ(test::run(mesh).exit_code, 0);
  const std::vector<std::string> table = {
      GRANADA_BIN_DIR "/bpt",  "brdf", "export", "torrance rough=0.1 nreal=1.9 nimag=3.6 ks=1 kd=0", "-o",
      scenes + "nickel.binary"};
  ASSERT_EQ(test::run(table).exit_code, 0);
  for (const std::string name : {"cornell_box", "glossy_sphere", "dragon", "pottery", "jug", "measured"}) {
    const std::string image = folder.path(name + ".pfm");
    const auto outcome = test::run({GRANADA_BIN_DIR "/bpt", scenes + name + ".op", "--size", "24x16",
                                    "--samples", "4", "--output", image});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    grf::Diagnostics diagnostics;
    const auto rendered = transport::read_image(image, diagnostics);
    ASSERT_TRUE(rendered) << diagnostics.to_text();
    const auto lit = std::count_if(rendered->pixels.begin(), rendered->pixels.end(),
                                   [](const auto& pixel) { return pixel.x > 0; });
    EXPECT_GT(lit, 24 * 16 / 10) << name;
  }
}

// What is printed in the thesis was copied whole: the means of tables 5.19 and 5.20 are those of their
// columns, and averages that its text gives are those of rows (section 5.5.1).
TEST(ThesisTables, AddUp) {
  grf::Diagnostics diagnostics;
  const auto printed = study::read_printed(Samples + "studies/thesis/tables.json", diagnostics);
  ASSERT_TRUE(printed) << diagnostics.to_text();
  EXPECT_EQ(printed->tables().size(), 14U);
  for (const char* number : {"5.19", "5.20"}) {
    const study::PrintedTable& table = printed->table(number);
    ASSERT_EQ(table.means.size(), table.columns.size());
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      double sum = 0;
      for (const study::PrintedRow& row : table.rows) sum += row.values[i];
      EXPECT_NEAR(sum / static_cast<double>(table.rows.size()), table.means[i], 0.006) << number << ", " << i;
    }
  }
  const auto mean_of = [&](const char* number, std::string_view technique) {
    for (const study::PrintedRow& row : printed->table(number).rows) {
      if (row.technique != technique) continue;
      return std::accumulate(row.values.begin(), row.values.end(), 0.0) /
             static_cast<double>(row.values.size());
    }
    return 0.0;
  };
  EXPECT_NEAR(mean_of("5.18", "uniform-ris"), 11.66, 0.005);
  EXPECT_NEAR(mean_of("5.18", "factored-ris"), 11.83, 0.005);
  EXPECT_NEAR(mean_of("5.18", "reject-ris"), 6.04, 0.005);
  EXPECT_NEAR(mean_of("5.16", "reject-ris"), 46.36, 0.01);
}

// One sphere and one BRDF: all tables and pictures of the scene, and nothing that is no number.
TEST(ThesisStudy, WritesWholeFiles) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("report"));
  const auto outcome =
      test::run({GRANADA_BIN_DIR "/thesis_study", "--quick", "--only", "glossy_sphere,torrance", "--output",
                 folder.path("report"), "--work", folder.path("work")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string readme = test::bytes_of(folder.path("report/README.md"));
  for (const char* heading :
       {"### Table 5.9", "### Table 5.10", "### Figure 5.10", "### Figure 5.11", "### Table 5.11",
        "### Table 5.12", "### Figure 5.12", "## Error at equal time"}) {
    EXPECT_NE(readme.find(heading), std::string::npos) << heading;
  }
  EXPECT_EQ(readme.find("nan"), std::string::npos);
  for (const char* scene : {"Test scene 1", "Test scene 4"}) EXPECT_EQ(readme.find(scene), std::string::npos);
  constexpr int Lines = 11;
  EXPECT_EQ(lines_of(test::bytes_of(folder.path("report/rows.csv"))), 1 + Lines * (4 + 3));
  // The same rows give the same report.
  const std::string report = test::bytes_of(folder.path("report/README.md"));
  std::filesystem::remove(folder.path("report/README.md"));
  const auto again =
      test::run({GRANADA_BIN_DIR "/thesis_study", "--quick", "--report", "--only", "glossy_sphere,torrance",
                 "--output", folder.path("report"), "--work", folder.path("work")});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(test::bytes_of(folder.path("report/README.md")), report);
  for (const char* picture : {"figure_5_10.svg", "figure_5_11.svg", "figure_5_12.svg"}) {
    EXPECT_TRUE(plot::to_png(test::bytes_of(folder.path("report/") + picture), 1)) << picture;
  }
}

TEST(ThesisStudy, SaysWhenItsCommandLineIsBad) {
  const auto outcome = test::run({GRANADA_BIN_DIR "/thesis_study", "--only", "phonk"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err.find("There is no scene or BRDF 'phonk' in the study: cornell_box"), 0U)
      << outcome.err;
}

}  // namespace
