// Tests of the study of the thesis: its scenes, its copies of printed tables, and its program.
#include <algorithm>
#include <filesystem>
#include <numeric>
#include <string_view>

#include <gtest/gtest.h>

#include "renderer/image/image.h"
#include "renderer/options/op_file.h"
#include "renderer/plot/svg.h"
#include "samples/studies/thesis/printed.h"
#include "tests/support/camera_image.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

const std::string Samples = GRANADA_SOURCE_DIR "/samples/";

std::ptrdiff_t lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

/// The scenes of the study as they are after `run` has generated the large files, here with a coarse dragon.
class ThesisScenes : public testing::Test {
 protected:
  ThesisScenes() : scenes_(folder_.path("studies/thesis/")) {
    namespace fs = std::filesystem;
    for (const char* name : {"environments", "studies"}) fs::create_directories(folder_.path(name));
    fs::copy(Samples + "environments/studio.exr", folder_.path("environments/studio.exr"));
    fs::copy(Samples + "studies/thesis", scenes_, fs::copy_options::recursive);
  }

  test::CameraImage rendered(const std::string& name, const std::string& size) const {
    const std::string file = folder_.path(name + ".pfm");
    const auto outcome = test::run(
        {GRANADA_BIN_DIR "/bpt", scenes_ + name + ".op", "--size", size, "--samples", "4", "--output", file});
    grf::Diagnostics diagnostics;
    auto image = image::read_image(file, diagnostics);
    const auto options = options::read_op_file(scenes_ + name + ".op", diagnostics);
    if (outcome.exit_code != 0 || !image || !options) {
      throw std::runtime_error(outcome.err + diagnostics.to_text());
    }
    return {std::move(*image), Imath::V3d(*options->eye), Imath::V3d(*options->target),
            options->field_of_view};
  }
  void make(const std::vector<std::string>& command) const {
    const auto outcome = test::run(command);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  const test::TemporaryFolder folder_;
  const std::string scenes_;
};

TEST_F(ThesisScenes, ShowTheCornellBox) {
  const test::CameraImage box = rendered("cornell_box", "80x64");
  test::expect_cornell_box(box.image());
  EXPECT_GT(box.at({278, 1, 100}).x, 0.0051F) << "the floor in front has more than its own glow";
}

// Under a neutral area light and a neutral sky of 0.02, the highlight is at the look-at point and brighter
// than its surroundings.
TEST_F(ThesisScenes, ShowTheHighlightOfTheGlossySphere) {
  const test::CameraImage sphere = rendered("glossy_sphere", "24x16");
  const auto highlight = sphere.at({0.065, 1.64, 0.767});
  EXPECT_GT(highlight.x, 0.1F);
  for (const int x : {0, 23}) {
    for (const int y : {0, 15}) {
      EXPECT_TRUE(test::is_grey(sphere.image().at(x, y)));
      EXPECT_GT(sphere.image().at(x, y).x, 0);
      EXPECT_LT(sphere.image().at(x, y).x, 0.7F * highlight.x);
    }
  }
}

// The light is yellowish, (9, 8.6, 8): the floor of (0.75, 0.7, 0.62) looks more so, the wall of
// (0.55, 0.68, 0.8) blue.
TEST_F(ThesisScenes, ShowTheDragonBeforeItsWall) {
  make({GRANADA_BIN_DIR "/make_shape", "dragon", "3000", scenes_ + "parts/dragon.grf", "material", "scheme"});
  const test::CameraImage dragon = rendered("dragon", "24x16");
  const auto floor = dragon.at({-0.9, 0, 1.2});
  EXPECT_GT(floor.z, 0.03F);
  EXPECT_GT(floor.x, 1.05F * floor.y);
  EXPECT_GT(floor.y, 1.05F * floor.z);
  const auto wall = dragon.at({1.2, 1.3, -1.7});
  EXPECT_GT(wall.x, 0);
  EXPECT_GT(wall.y, 1.05F * wall.x);
  EXPECT_GT(wall.z, 1.02F * wall.y);
  const auto middle = dragon.at({0.05, 0.5, 0});
  EXPECT_TRUE(middle != floor && middle != wall && middle.x > 0);
}

// Above the jugs there is only the background of 0.1; each jug is lit from above and from the front, so its
// belly differs from its surroundings.
TEST_F(ThesisScenes, ShowThreeJugs) {
  make({GRANADA_BIN_DIR "/bpt", "brdf", "export", "torrance rough=0.1 nreal=1.9 nimag=3.6 ks=1 kd=0", "-o",
        scenes_ + "nickel.binary"});
  for (const char* name : {"pottery", "measured"}) {
    const test::CameraImage jugs = rendered(name, "45x22");
    for (const int x : {0, 22, 44}) {
      EXPECT_NEAR(jugs.image().at(x, 0).x, 0.1, 1e-6) << name;
      EXPECT_TRUE(test::is_grey(jugs.image().at(x, 0)));
    }
    for (const double x : {-2.3, 0.0, 2.35}) {
      const auto belly = jugs.at({x, 0.7, 0.6});
      EXPECT_GT(belly.y, 0.005F) << name << " " << x;
      EXPECT_GT(std::abs(belly.y - 0.1F), 1e-4F) << name << " " << x;
    }
  }
}

// A metal's reflection of the environment map is darker than the brightest texel; beside the jug the map
// itself is visible.
TEST_F(ThesisScenes, ShowAJugInItsEnvironment) {
  const test::CameraImage jug = rendered("jug", "24x16");
  grf::Diagnostics diagnostics;
  const auto map = image::read_image(Samples + "environments/studio.exr", diagnostics);
  ASSERT_TRUE(map) << diagnostics.to_text();
  float brightest = 0;
  for (const auto& texel : map->pixels) brightest = std::max(brightest, texel.y);
  const auto belly = jug.at({0.02, 0.8, 0.5});
  EXPECT_GT(belly.y, 0.001F);
  EXPECT_LT(belly.y, brightest);
  // The camera looks down -z, the centre of the map; the corner of the image is a few degrees from it.
  const auto corner = jug.image().at(0, 0);
  float least = brightest;
  float most = 0;
  for (int y = 3 * map->height / 8; y < 5 * map->height / 8; ++y) {
    for (int x = 3 * map->width / 8; x < 5 * map->width / 8; ++x) {
      least = std::min(least, map->at(x, y).y);
      most = std::max(most, map->at(x, y).y);
    }
  }
  EXPECT_GE(corner.y, 0.99F * least);
  EXPECT_LE(corner.y, 1.01F * most);
}

// The thesis' tables were copied completely: the means of tables 5.19 and 5.20 are those of their columns,
// and averages in its text are those of rows (section 5.5.1).
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

// Runs the study for one scene and one BRDF: all its tables and pictures are written, without NaN.
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
  EXPECT_EQ(outcome.err.find("error: --only: found 'phonk', expected scenes or BRDFs: cornell_box"), 0U)
      << outcome.err;
}

}  // namespace
