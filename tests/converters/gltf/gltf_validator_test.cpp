// Tests that written files have no error in the Khronos Group's validator, an npm package.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck.h>

#include "converters/text_encoding.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/write.h"
#include "tests/converters/npm.h"
#include "tests/converters/reading.h"
#include "tests/grf/scene_generator.h"
#include "tests/support/paths.h"

namespace convert {
namespace {

using nlohmann::json;

// The first image takes the place of images that are missing: generated scenes have names alone.
constexpr std::string_view Script = R"(
import validator from 'gltf-validator';
import fs from 'node:fs';
import path from 'node:path';
const [image, list] = process.argv.slice(2);
const read = (file) => new Uint8Array(fs.readFileSync(file));
const beside = async (file, uri) => {
  const wanted = path.resolve(path.dirname(file), decodeURIComponent(uri));
  return read(fs.existsSync(wanted) && fs.statSync(wanted).isFile() ? wanted : image);
};
const all = async () => {
  const reports = {};
  for (const file of fs.readFileSync(list, 'utf8').trim().split('\n')) {
    const report = await validator.validateBytes(read(file), {
      uri: path.basename(file), maxIssues: 50, externalResourceFunction: (uri) => beside(file, uri) });
    reports[file] = report.issues.messages.filter((issue) => issue.severity == 0);
  }
  console.log(JSON.stringify(reports));
};
all().catch((problem) => { console.error(problem); process.exit(1); });
)";

const std::string Image = "/usr/share/assimp/models/glTF2/BoxTextured-glTF/CesiumLogoFlat.png";

class GltfValidator : public NpmTest {
 protected:
  GltfValidator() : NpmTest({"gltf-validator@2.0.0-dev.3.10"}) {}

  void expect_no_errors(const std::vector<std::string>& files) {
    std::string list;
    for (const std::string& file : files) list += file + '\n';
    const test::Outcome outcome = run_program(Script, {Image, folder_.add("list", list)});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json reports = json::parse(outcome.out);
    ASSERT_EQ(reports.size(), files.size());
    for (const auto& [file, errors] : reports.items()) EXPECT_TRUE(errors.empty()) << file << errors.dump(1);
  }

  /// Writes a scene both ways, and gives the files.
  void write(const grf::Scene& scene, const std::string& name, std::vector<std::string>& files) {
    for (const char* extension : {"gltf", "glb"}) {
      grf::Diagnostics diagnostics;
      files.push_back(folder_.path(name + "." + extension));
      ASSERT_TRUE(find_format(extension)->write(scene, files.back(), diagnostics)) << diagnostics.to_text();
    }
  }
};

TEST_F(GltfValidator, FindsNoErrorInWhatIsWrittenOfGrf) {
  std::filesystem::copy_file(Image, folder_.path("wood.png"));
  const std::vector<std::pair<std::string, std::string>> scenes = {
      {"empty", "params begin dependent view (1,2,3) end"}, {"polygons", R"(
def steel = brdf torrance rough=0.3 ks=(1,0.5,2e-1)
  lacquer = brdf gltf ior=1.8 specular=0.9 specularColor=(1,2,3) anisotropy=0.4 rotation=-1 clearcoat=0.2
    coatRoughness=0.1 sheenColor=0.3 sheenRoughness=0.6
def wood = texture "wood.png"
def stool = begin mesh "stool" brdf steel pdf adaptive
  begin vertexs normal (0,0,3) (0,0,0) normal (0,0,1) (1,0,0) normal (0,0,1) (1,1,0) normal (1,2,3) (0,1,0) (0,0,2) end vertexs
  begin faces (0,1,2,3) light rgb (5,4,3) (0,1,4) brdf lacquer (2,3,4) brdf none (1,2,4) end faces end mesh
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

TEST_F(GltfValidator, FindsNoErrorInWhatIsWrittenOfGeneratedScenes) {
  std::vector<std::string> files;
  const auto write_any = [&] {
    // JSON has no text but UTF-8.
    grf::Diagnostics diagnostics;
    const std::string text = to_utf8(grf::to_text(grf::SceneGenerator(false).scene()));
    const auto scene = grf::read_text(text, folder_.path("a.grf"), diagnostics);
    if (scene) write(*scene, "generated" + std::to_string(files.size()), files);
  };
  rc::detail::TestParams parameters = rc::detail::configuration().testParams;
  parameters.maxSuccess = 200;
  rc::detail::checkTestable(write_any, rc::detail::TestMetadata(), parameters);
  EXPECT_GT(files.size(), 200U);
  expect_no_errors(files);
}

TEST_F(GltfValidator, FindsNoErrorInWhatIsWrittenOfModelsAndSamples) {
  std::vector<std::string> files;
  int count = 0;
  for (const std::string root :
       {"/usr/share/assimp/models", "/usr/share/glmark2/models", GRANADA_SOURCE_DIR "/samples"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (!entry.is_regular_file() || format_of_name(entry.path().string()) == nullptr) continue;
      Reading reading = read_path(entry.path().string());
      if (!reading.scene) continue;
      for (const EmbeddedFile& file : reading.files) folder_.add(file.name, file.bytes);
      grf::relocate(*reading.scene, entry.path().string(), folder_.path("a.gltf"));
      write(*reading.scene, "model" + std::to_string(count++), files);
    }
  }
  EXPECT_GT(count, 300);
  expect_no_errors(files);
}

}  // namespace
}  // namespace convert
