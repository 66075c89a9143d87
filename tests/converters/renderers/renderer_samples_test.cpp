// Every sample scene is exported for both renderers, and what is written passes their parsers: a few in each
// run, and all in a long one.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/relocate.h"
#include "renderer/options/op_file.h"
#include "renderer/reflectance/rgl_data.h"
#include "tests/converters/reading.h"
#include "tests/converters/renderers/mitsuba_scene.h"
#include "tests/converters/renderers/pbrt_scene.h"
#include "tests/support/samples.h"
#include "tests/support/thoroughness.h"

namespace convert {
namespace {

namespace fs = std::filesystem;

/// Scenes of which only few BRDFs are tabulated, or of simple models: those of a run that is not long.
bool is_quick(const fs::path& path) {
  const std::string folder = path.parent_path().filename().string();
  return folder == "cornell_box" || folder == "baked_room" || folder == "teapot" || folder == "plaza" ||
         path.stem() == "cube_measured" || path.stem() == "dragon";
}

std::vector<std::string> sample_files() {
  std::vector<std::string> files = test::sample_op_files();
  if (!test::tries_all()) std::erase_if(files, [](const std::string& file) { return !is_quick(file); });
  return files;
}

void expect_tables(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".bsdf") continue;
    grf::Diagnostics diagnostics;
    EXPECT_NE(reflectance::RglData::load(entry.path().string(), diagnostics, {}), nullptr)
        << diagnostics.to_text();
  }
}

class SampleScenes : public testing::TestWithParam<std::string> {};

TEST_P(SampleScenes, AreExportedForRenderers) {
  grf::Diagnostics diagnostics;
  const auto view = options::read_op_file(GetParam(), diagnostics);
  ASSERT_TRUE(view.has_value()) << diagnostics.to_text();
  if (view->scene.empty()) return;
  const auto import = read(*find_format("grf"), view->scene, {}, diagnostics);
  ASSERT_TRUE(import.has_value()) << diagnostics.to_text();
  const test::TemporaryFolder folder;
  for (const char* name : {"pbrt", "mitsuba"}) {
    const Format& format = *find_format(name);
    const std::string path = folder.path("out." + std::string(format.extensions[0]));
    grf::Scene scene = import->scene;
    grf::relocate(scene, view->scene, path);
    ASSERT_TRUE(format.write_view(scene, path, {GetParam()}, diagnostics)) << diagnostics.to_text();
    expect_tables(folder.path(std::string("out_") + name));
    const std::string text = test::bytes_of(path);
    if (format.name == "pbrt") {
      const test::PbrtScene written = test::parse_pbrt(text, folder.path());
      EXPECT_EQ(written.options.at("Film").number("xresolution"), view->size.width);
      EXPECT_FALSE(written.shapes.empty());
    } else {
      const test::MitsubaElement written = test::parse_mitsuba(text, folder.path());
      EXPECT_EQ(written.child("sensor").child("film").number("width"), view->size.width);
      EXPECT_FALSE(written.all("shape").empty());
    }
  }
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  std::string name = fs::relative(info.param, test::samples_folder()).string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, SampleScenes, testing::ValuesIn(sample_files()), name_of);

}  // namespace
}  // namespace convert
