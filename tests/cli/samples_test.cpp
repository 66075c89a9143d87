// Tests that the samples are valid, and that generated samples are up to date.
#include "tests/support/samples.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include <gtest/gtest.h>

#include "grf/check.h"
#include "grf/read.h"
#include "grf/summary.h"
#include "renderer/image/image.h"
#include "renderer/options/op_file.h"
#include "renderer/plot/svg.h"
#include "renderer/reflectance/scheme.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

const std::string Samples = GRANADA_SOURCE_DIR "/samples/";

TEST(Teapot, IsWhatItsProgramMakes) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("teapot.obj");
  ASSERT_EQ(test::run({GRANADA_BIN_DIR "/make_teapot", "8", path}).exit_code, 0);
  EXPECT_TRUE(test::bytes_of(path) == test::bytes_of(Samples + "teapot/teapot.obj"));
}

TEST(Teapot, SaysWhenItsCommandLineIsBad) {
  EXPECT_EQ(test::run({GRANADA_BIN_DIR "/make_teapot"}).exit_code, 2);
  EXPECT_EQ(test::run({GRANADA_BIN_DIR "/make_teapot", "0", "x.obj"}).exit_code, 2);
  EXPECT_EQ(test::run({GRANADA_BIN_DIR "/make_teapot", "4", "/no/such/folder/x.obj"}).exit_code, 1);
}

// The teapot is oriented consistently: face normals agree with vertex normals, the handle is on the left and
// the spout on the right, and it has the published height.
TEST(Teapot, TurnsItsFrontsOutwards) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(Samples + "teapot/teapot.grf", diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  const grf::Block* block = &scene->contents.blocks.front();
  const grf::Mesh& mesh = *std::get<grf::Shared<grf::Mesh>>(block->content);
  ASSERT_EQ(mesh.face_count(), 2048U);
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const grf::Vec3d area = grf::doubled_area_vector(*mesh.geometry, i, {});
    for (const std::uint32_t corner : mesh.face(i)) {
      EXPECT_GT(area.normalized().dot(grf::Vec3d(mesh.geometry->normals[corner])), 0) << "face " << i;
    }
  }
  const grf::Box3f bounds = grf::summarize(*scene).bounds;
  EXPECT_NEAR(bounds.min.x, -3, 1e-5);
  EXPECT_NEAR(bounds.max.y, 3.15, 1e-5);
  EXPECT_NEAR(bounds.min.y, 0, 1e-5);
  EXPECT_GT(bounds.max.x, 3.4);
}

struct ShapeCase {
  std::string shape;
  std::size_t asked, made;
  double volume = 0.5;     ///< at least
  double rough_share = 0;  ///< fraction of triangles that face away from the normals of their corners
};

class Shapes : public testing::TestWithParam<ShapeCase> {};

// A shape is closed, has about the requested number of triangles, stands on the ground, and is smooth: the
// normal of each triangle agrees with those of its corners.
//
// A grid cannot follow each sharp edge of a dragon: some triangles at the rims of its wings and on steep
// scales face away.
TEST_P(Shapes, AreClosedAndSmooth) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("shape.grf");
  const auto made =
      test::run({GRANADA_BIN_DIR "/make_shape", GetParam().shape, std::to_string(GetParam().asked), path});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(path, diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  const grf::Summary summary = grf::summarize(*scene);
  EXPECT_EQ(summary.triangles, GetParam().made);
  EXPECT_EQ(summary.boundary_edges, 0U);
  EXPECT_EQ(summary.nonmanifold_edges, 0U);
  EXPECT_NEAR(summary.bounds.min.y, 0, 1e-5);
  EXPECT_NEAR(summary.bounds.size().x, 2, 0.01);
  const grf::Mesh& mesh = *std::get<grf::Shared<grf::Mesh>>(scene->contents.blocks.front().content);
  double volume = 0;
  std::size_t rough = 0;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const grf::Vec3d area = grf::doubled_area_vector(*mesh.geometry, i, {});
    volume += area.dot(grf::Vec3d(mesh.geometry->positions[mesh.face(i)[0]])) / 6;
    float least = 1;
    for (const std::uint32_t corner : mesh.face(i)) {
      least = std::min(least, grf::Vec3f(area.normalized()).dot(mesh.geometry->normals[corner]));
      EXPECT_NEAR(mesh.geometry->normals[corner].length(), 1, 1e-3);
    }
    if (!(least > 0.2F)) ++rough;
  }
  EXPECT_LE(static_cast<double>(rough), GetParam().rough_share * static_cast<double>(mesh.face_count()));
  EXPECT_GT(volume, GetParam().volume);
}

INSTANTIATE_TEST_SUITE_P(Counts, Shapes,
                         testing::Values(ShapeCase{"knot", 20'000, 20'000}, ShapeCase{"knot", 70'000, 70'000},
                                         ShapeCase{"sphere", 1'000, 960}, ShapeCase{"sphere", 16'000, 16'128},
                                         ShapeCase{"dragon", 200'000, 199'868, 0.1, 0.006},
                                         ShapeCase{"jug", 6'000, 6'006, 0.1, 0.002},
                                         ShapeCase{"jug", 20'000, 20'012, 0.1, 0.002}),
                         [](const auto& tested) {
                           return tested.param.shape + std::to_string(tested.param.asked);
                         });

TEST(MakeShape, SaysWhenItsCommandLineIsBad) {
  const std::vector<std::string> program = {GRANADA_BIN_DIR "/make_shape"};
  for (const std::vector<std::string>& words : {std::vector<std::string>{},
                                                {"cube", "1000", "x.grf"},
                                                {"knot", "99", "x.grf"},
                                                {"knot", "1e3", "x.grf"}}) {
    std::vector<std::string> command = program;
    command.insert(command.end(), words.begin(), words.end());
    EXPECT_EQ(test::run(command).exit_code, 2);
  }
  EXPECT_EQ(test::run({program[0], "knot", "1000", "/no/such/folder/x.grf"}).exit_code, 1);
}

TEST(Shapes, OfTheScenesAreWhatTheirProgramMakes) {
  const test::TemporaryFolder folder;
  for (const auto& [shape, count] : {std::pair("knot", "12000"), std::pair("sphere", "4000")}) {
    const std::string path = folder.path("shape.grf");
    ASSERT_EQ(test::run({GRANADA_BIN_DIR "/make_shape", shape, count, path, "material"}).exit_code, 0);
    EXPECT_TRUE(test::bytes_of(path) == test::bytes_of(Samples + "shapes/" + shape + ".grf")) << shape;
  }
  for (const auto& [shape, count] : {std::pair("jug", "6000"), std::pair("sphere", "4000")}) {
    const std::string path = folder.path("shape.grf");
    ASSERT_EQ(test::run({GRANADA_BIN_DIR "/make_shape", shape, count, path, "material", "scheme"}).exit_code,
              0);
    EXPECT_TRUE(test::bytes_of(path) == test::bytes_of(Samples + "studies/thesis/parts/" + shape + ".grf"))
        << shape;
  }
}

/// Returns the maximum relative difference of two images.
float largest_difference(const std::string& path, const std::string& other_path) {
  grf::Diagnostics diagnostics;
  const auto image = image::read_image(path, diagnostics);
  const auto other = image::read_image(other_path, diagnostics);
  if (!image || !other || image->pixels.size() != other->pixels.size()) return HUGE_VALF;
  float largest = 0;
  for (std::size_t i = 0; i < image->pixels.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const float a = image->pixels[i][k];
      const float b = other->pixels[i][k];
      if (a != b) largest = std::max(largest, std::abs(a - b) / std::max(a, b));
    }
  }
  return largest;
}

TEST(Environments, AreWhatTheirProgramMakes) {
  const test::TemporaryFolder folder;
  for (const std::string name : {"overcast", "sky", "studio"}) {
    const std::string path = folder.path(name + ".exr");
    ASSERT_EQ(test::run({GRANADA_BIN_DIR "/make_environment", name, path}).exit_code, 0);
    // One ulp of half floats.
    EXPECT_LE(largest_difference(path, Samples + "environments/" + name + ".exr"), 0.001F) << name;
  }
}

// The irradiance of a horizontal surface is 7/9 of that under a sky as bright as the zenith everywhere (Moon
// and Spencer 1942).
TEST(Environments, AreOvercastAsMoonAndSpencerSay) {
  grf::Diagnostics diagnostics;
  const auto map = image::read_image(Samples + "environments/overcast.exr", diagnostics);
  ASSERT_TRUE(map);
  const double zenith = double(map->at(0, 0).y);
  double sum = 0;
  for (int y = 0; y < map->height / 2; ++y) {
    const double theta = (y + 0.5) / map->height * std::numbers::pi;
    sum +=
        double(map->at(7, y).y) / zenith * std::cos(theta) * std::sin(theta) * std::numbers::pi / map->height;
  }
  EXPECT_NEAR(2 * sum, 7.0 / 9, 1e-3);
}

TEST(Environments, SayWhenTheirCommandLineIsBad) {
  const std::string program = GRANADA_BIN_DIR "/make_environment";
  EXPECT_EQ(test::run({program}).exit_code, 2);
  EXPECT_EQ(test::run({program, "sea", "x.exr"}).exit_code, 2);
  EXPECT_EQ(test::run({program, "sky", "/no/such/folder/x.exr"}).exit_code, 1);
}

TEST(Garden, IsWhatItsProgramMakes) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(test::run({GRANADA_BIN_DIR "/make_garden", folder.path()}).exit_code, 0);
  EXPECT_TRUE(test::bytes_of(folder.path("garden.grf")) == test::bytes_of(Samples + "garden/garden.grf"));
  EXPECT_EQ(largest_difference(folder.path("paving.png"), Samples + "garden/paving.png"), 0);
}

TEST(Garden, SaysWhenItsCommandLineIsBad) {
  EXPECT_EQ(test::run({GRANADA_BIN_DIR "/make_garden"}).exit_code, 2);
  EXPECT_EQ(test::run({GRANADA_BIN_DIR "/make_garden", "/no/such/folder"}).exit_code, 1);
}

TEST(Leaves, AreWhatTheirScriptMakes) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(test::run({Samples + "leaves/make_leaves", folder.path()}).exit_code, 0);
  EXPECT_TRUE(test::bytes_of(folder.path("leaves.grf")) == test::bytes_of(Samples + "leaves/leaves.grf"));
  EXPECT_EQ(largest_difference(folder.path("leaf.png"), Samples + "leaves/leaf.png"), 0);
}

TEST(Gallery, HasTheShapesThatItsProgramMakes) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(test::run({GRANADA_BIN_DIR "/make_gallery", folder.path()}).exit_code, 0);
  const std::filesystem::directory_iterator kept(Samples + "gallery/shapes");
  EXPECT_EQ(std::distance(begin(kept), end(kept)), std::ssize(folder.names()));
  for (const std::string& name : folder.names()) {
    EXPECT_TRUE(test::bytes_of(folder.path(name)) == test::bytes_of(Samples + "gallery/shapes/" + name))
        << name;
  }
}

TEST(Gallery, SaysWhenTheCommandLineOfItsProgramIsBad) {
  EXPECT_EQ(test::run({GRANADA_BIN_DIR "/make_gallery"}).exit_code, 2);
  EXPECT_EQ(test::run({GRANADA_BIN_DIR "/make_gallery", "/no/such/folder"}).exit_code, 1);
}

std::ptrdiff_t lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

// Runs the study for two BRDFs, one of them diffuse: all tables, all errors, pictures that can be drawn.
TEST(SamplingStudy, WritesWholeFiles) {
  const test::TemporaryFolder folder;
  const auto outcome = test::run(
      {GRANADA_BIN_DIR "/sampling_study", "--quick", "--only", "phong,oren", "--output", folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> names = {"README.md", "convergence.svg", "sampling.csv", "schemes.svg",
                                          "tables.csv"};
  EXPECT_EQ(folder.names(), names);

  constexpr int Schemes = 10;
  constexpr int Views = 3;
  EXPECT_EQ(lines_of(test::bytes_of(folder.path("sampling.csv"))), 1 + 2 * Schemes * Views * 2);
  const std::string tables = test::bytes_of(folder.path("tables.csv"));
  EXPECT_NE(tables.find("phong,60 reject,build_seconds,"), std::string::npos);
  for (const char* wrong : {"nan", "inf"}) EXPECT_EQ(tables.find(wrong), std::string::npos) << wrong;

  const std::string readme = test::bytes_of(folder.path("README.md"));
  for (const char* heading : {"(table 5.1)", "(table 5.2)", "(table 5.3)", "(table 5.6)",
                              "## Cost of a scheme", "### anywhere", "### environment", "## Targets"}) {
    EXPECT_NE(readme.find(heading), std::string::npos) << heading;
  }
  for (const char* picture : {"convergence.svg", "schemes.svg"}) {
    EXPECT_TRUE(plot::to_png(test::bytes_of(folder.path(picture)), 1)) << picture;
  }
}

TEST(SamplingStudy, SaysWhenItsCommandLineIsBad) {
  const auto outcome = test::run({GRANADA_BIN_DIR "/sampling_study", "--only", "phonk"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err.find("There is no BRDF 'phonk' among those of the study: ashikhmin"), 0U);
  EXPECT_EQ(test::run({GRANADA_BIN_DIR "/sampling_study", "--fast"}).exit_code, 2);
}

// An included part names a BRDF that its scenes define, so it cannot be read on its own.
bool is_part(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path().filename();
  return folder == "shapes" || folder == "parts";
}

std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

TEST(Samples, AreReadWithoutAComplaint) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(Samples)) {
    const std::string path = entry.path().string();
    grf::Diagnostics diagnostics;
    const bool is_op_file = entry.path().extension() == ".op";
    EXPECT_TRUE(!is_op_file || options::read_op_file(path, diagnostics));
    const bool is_whole = !test::needs_made_files(entry.path()) && !is_part(entry.path());
    if (entry.path().extension() == ".grf" && is_whole) {
      const auto scene = grf::read(path, diagnostics);
      EXPECT_TRUE(scene && grf::check(*scene, reflectance::catalogue(), diagnostics));
      ++scenes;
    }
    // The BRDFs of the thesis are as published, and some reflect more than they receive.
    const std::string text = diagnostics.to_text();
    EXPECT_EQ(count_of(text, "error:") + count_of(text, "warning:"), count_of(text, "reflects up to"))
        << text;
    EXPECT_TRUE(text.empty() || entry.path().parent_path().filename() == "thesis") << text;
  }
  EXPECT_GE(scenes, 15);
}

}  // namespace
