#include "tests/converters/model_files.h"

#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/format.h"
#include "grf/keywords.h"

namespace convert {
namespace {

std::map<std::string, int> uses_of_files() {
  std::map<std::string, int> uses;
  for (const auto& formats : {formats_of_obj_models(), formats_of_ply_models(), formats_of_gltf_models(),
                              formats_of_vrml_models(), formats_of_assimp_models()}) {
    for (const std::string& path : model_files(formats)) ++uses[path];
  }
  return uses;
}

TEST(ModelFiles, OfEachFormatBelongToOneSuiteOfTests) {
  std::map<std::string_view, int> uses;
  for (const auto& formats : {formats_of_obj_models(), formats_of_ply_models(), formats_of_gltf_models(),
                              formats_of_vrml_models(), formats_of_assimp_models()}) {
    for (const std::string_view format : formats) ++uses[format];
  }
  for (const Format& format : formats()) {
    if (format.read == nullptr || format.name == "grf") continue;
    EXPECT_EQ(uses[format.name], 1) << format.name;
  }
}

// Found by their names here, whatever they hold.
TEST(ModelFiles, AreEachTestedOnce) {
  const std::set<std::string> extensions = {".obj", ".ply", ".gltf", ".glb", ".3ds", ".stl",
                                            ".off", ".dxf", ".dae",  ".zae", ".wrl"};
  const auto uses = uses_of_files();
  std::size_t count = 0;
  for (const std::string& folder : {AssimpModels, Glmark2Models}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (!extensions.contains(grf::lower_case(entry.path().extension().string()))) continue;
      ++count;
      EXPECT_TRUE(uses.contains(entry.path().string())) << entry.path();
    }
  }
  EXPECT_GE(count, 140U);
  for (const auto& [path, times] : uses) EXPECT_EQ(times, 1) << path;
}

TEST(ModelFiles, AreOfTheFormatThatTheirNameSaysIfItSaysOne) {
  for (const auto& [path, times] : uses_of_files()) {
    grf::Diagnostics diagnostics;
    const Format* of_name = read_format_of_name(path);
    // XML of COLLADA, made to be detected from its content.
    if (of_name == nullptr || path.ends_with("Collada/AsXML.xml")) continue;
    EXPECT_EQ(recognise(path, diagnostics)->name, of_name->name) << path;
  }
}

}  // namespace
}  // namespace convert
