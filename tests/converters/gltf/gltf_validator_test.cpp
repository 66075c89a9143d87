// What is written has no error for the validator of the Khronos Group, an npm package.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "grf/read.h"
#include "grf/relocate.h"
#include "tests/converters/reading.h"
#include "tests/support/run.h"

namespace convert {
namespace {

using nlohmann::json;

constexpr std::string_view Script = R"(
const validator = require('gltf-validator');
const fs = require('fs');
const path = require('path');
const check = async (file) => validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
  uri: path.basename(file), maxIssues: 50,
  externalResourceFunction: (uri) => fs.promises.readFile(
    path.resolve(path.dirname(file), decodeURIComponent(uri))).then((bytes) => new Uint8Array(bytes)),
});
const all = async () => {
  const reports = {};
  for (const file of process.argv.slice(2)) reports[file] = (await check(file)).issues;
  console.log(JSON.stringify(reports));
};
all().catch((problem) => { console.error(problem); process.exit(1); });
)";

/// The validator, installed in a folder of its own.
class GltfValidator : public testing::Test {
 protected:
  void SetUp() override {
    const test::Outcome installed = test::run({"/bin/sh", "-c",
                                               "cd '" + folder_.path() +
                                                   "' && npm install --no-audit --no-fund --silent "
                                                   "gltf-validator@2.0.0-dev.3.10"});
    if (installed.exit_code != 0) GTEST_SKIP() << "npm cannot install gltf-validator: " << installed.err;
    folder_.add("check.js", Script);
  }

  void expect_no_errors(const std::vector<std::string>& files) {
    std::vector<std::string> command = {"/usr/bin/env", "node", folder_.path("check.js")};
    command.insert(command.end(), files.begin(), files.end());
    const test::Outcome outcome = test::run(command);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json reports = json::parse(outcome.out);
    ASSERT_EQ(reports.size(), files.size());
    for (const auto& [file, issues] : reports.items()) {
      EXPECT_EQ(issues["numErrors"], 0) << file << ' ' << issues.dump(1);
    }
  }

  /// Writes a scene both ways, and gives the files.
  void write(const grf::Scene& scene, const std::string& name, std::vector<std::string>& files) {
    for (const char* extension : {"gltf", "glb"}) {
      grf::Diagnostics diagnostics;
      files.push_back(folder_.path(name + "." + extension));
      ASSERT_TRUE(find_format(extension)->write(scene, files.back(), diagnostics)) << diagnostics.to_text();
    }
  }

  const test::TemporaryFolder folder_;
};

TEST_F(GltfValidator, FindsNoErrorInWhatIsWrittenOfGrf) {
  std::filesystem::copy_file("/usr/share/assimp/models/glTF2/BoxTextured-glTF/CesiumLogoFlat.png",
                             folder_.path("wood.png"));
  const std::vector<std::pair<std::string, std::string>> scenes = {
      {"empty", "params begin dependent view (1,2,3) end"}, {"polygons", R"(
def steel = brdf torrance rough=0.3 ks=(1,0.5,2e-1) def wood = texture "wood.png"
def stool = begin mesh "stool" brdf steel pdf adaptive
  begin vertexs normal (0,0,3) (0,0,0) normal (0,0,1) (1,0,0) normal (0,0,1) (1,1,0) normal (1,2,3) (0,1,0) (0,0,2) end vertexs
  begin faces (0,1,2,3) light rgb (5,4,3) (0,1,4) brdf none (1,2,4) end faces end mesh
begin
  transform rotation (0.1,0.2,0.3) scale (1,-2,3) rotation (1,1,1) translation (4,5,6) begin use stool end
  use stool
  begin mesh "wall" rgb (0.5,2,0.25) texture wood
  begin vertexs uv (0,0.1) (0,0,0) uv (1,0.3) rgb (2,0,0) (1,0,0) uv (0.7,1) irad (1,2,3) (0.2,0.2,0) uv (0,1)
    begin list ray (0,0,1) irad (1,1,1) end list (0,1,0) end vertexs begin faces (0,1,2,3) end faces end mesh
  light begin (0,0,3) (1,0,0) (0,-1,0) rgb (10,10,10) end
  mesh light begin rgb (0.2,0,0) begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs begin faces (0,1,2) end faces end
end)"}};
  std::vector<std::string> files;
  for (const auto& [name, text] : scenes) {
    grf::Diagnostics diagnostics;
    const auto scene = grf::read_text(text, folder_.path(name + ".grf"), diagnostics);
    ASSERT_TRUE(scene.has_value()) << diagnostics.to_text();
    write(*scene, name, files);
  }
  expect_no_errors(files);
}

TEST_F(GltfValidator, FindsNoErrorInWhatIsWrittenOfModels) {
  std::vector<std::string> files;
  int count = 0;
  for (const std::string root : {"/usr/share/assimp/models/OBJ", "/usr/share/assimp/models/glTF2"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (!entry.is_regular_file() || format_of_name(entry.path().string()) == nullptr) continue;
      Reading reading = read_path(entry.path().string());
      if (!reading.scene) continue;
      for (const EmbeddedFile& file : reading.files) folder_.add(file.name, file.bytes);
      grf::relocate(*reading.scene, entry.path().string(), folder_.path("a.gltf"));
      write(*reading.scene, "model" + std::to_string(count++), files);
    }
  }
  EXPECT_GT(count, 30);
  expect_no_errors(files);
}

}  // namespace
}  // namespace convert
