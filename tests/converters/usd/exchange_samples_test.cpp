// Every sample scene is written as USD and MaterialX, and what is written passes their parsers.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "converters/format.h"
#include "grf/relocate.h"
#include "renderer/options/op_file.h"
#include "tests/converters/usd/mtlx_document.h"
#include "tests/converters/usd/usda_stage.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

namespace fs = std::filesystem;

class ExchangedSamples : public testing::TestWithParam<std::string> {};

TEST_P(ExchangedSamples, AreWritten) {
  grf::Diagnostics diagnostics;
  const auto view = options::read_op_file(GetParam(), diagnostics);
  ASSERT_TRUE(view.has_value()) << diagnostics.to_text();
  if (view->scene.empty()) return;
  const auto import = read(*find_format("grf"), view->scene, {}, diagnostics);
  ASSERT_TRUE(import.has_value()) << diagnostics.to_text();
  const test::TemporaryFolder folder;
  const auto written = [&](const char* format, const std::string& path) {
    grf::Scene scene = import->scene;
    grf::relocate(scene, view->scene, path);
    EXPECT_TRUE(find_format(format)->write_view(scene, path, {GetParam()}, diagnostics))
        << diagnostics.to_text();
    return test::bytes_of(path);
  };
  const test::UsdaStage stage = test::parse_usda(written("usd", folder.path("out.usda")), folder.path());
  EXPECT_EQ(stage.root.child("Render").attribute("resolution").numbers.at(0), view->size.width);
  EXPECT_EQ(stage.root.child("Camera").type, "Camera");
  const test::MtlxDocument document = test::parse_mtlx(written("materialx", folder.path("out.mtlx")));
  // Faces are assigned by the paths that they have in the USD file, but inside of instances.
  for (const auto& [material, paths] : document.geometry) {
    for (const std::string& path : paths) {
      const test::UsdaPrim* subset = stage.find(path);
      const test::UsdaPrim* instance = stage.find(path.substr(0, path.rfind("/mesh/")));
      EXPECT_TRUE((subset != nullptr && subset->type == "GeomSubset") ||
                  (instance != nullptr && instance->is_instanceable))
          << path;
    }
  }
}

std::string name_of_sample(const testing::TestParamInfo<std::string>& info) {
  std::string name = fs::relative(info.param, test::samples_folder()).string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, ExchangedSamples, testing::ValuesIn(test::sample_op_files()), name_of_sample);

}  // namespace
}  // namespace convert
