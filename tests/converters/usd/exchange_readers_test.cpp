// USD and MaterialX files are read by the programs of others: tinyusdz, and MaterialX itself as WebAssembly.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "converters/format.h"
#include "grf/relocate.h"
#include "renderer/options/op_file.h"
#include "tests/converters/npm.h"
#include "tests/converters/usd/exchanged_scene.h"
#include "tests/support/samples.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// The package is made for browsers, and asks whether it runs in one.
constexpr std::string_view UsdProgram = R"(
import fs from 'node:fs';
const node = process;
globalThis.window = globalThis;
Object.defineProperty(globalThis, 'process', { value: undefined, configurable: true, writable: true });
const initialise = (await import('tinyusdz')).default;
const program = fs.readFileSync(new URL('node_modules/tinyusdz/tinyusdz.wasm', import.meta.url));
const instantiateWasm = (imports, done) => {
  WebAssembly.instantiate(program, imports).then((result) => done(result.instance));
  return {};
};
const library = await initialise({ instantiateWasm });
globalThis.process = node;
const reports = {};
console.log = console.error;
for (const file of node.argv.slice(2)) {
  const bytes = new Uint8Array(fs.readFileSync(file));
  const layer = new library.TinyUSDZLoaderNative();
  const scene = new library.TinyUSDZLoaderNative();
  const report = { is_layer: layer.loadAsLayerFromBinary(bytes, file), is_scene: scene.loadFromBinary(bytes, file) };
  reports[file] = { ...report, errors: layer.error() + scene.error(), meshes: scene.numMeshes() };
}
node.stdout.write(JSON.stringify(reports));
)";

// Shaders are generated for each material, since a document may be valid and have nodes that fit no
// definition.
constexpr std::string_view MaterialXProgram = R"(
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
const folder = fileURLToPath(new URL('node_modules/@needle-tools/materialx/bin/', import.meta.url));
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = folder;
globalThis.__filename = folder + 'JsMaterialXGenShader.js';
const initialise = (await import(globalThis.__filename)).default;
const locateFile = (name) => folder + name + (name.endsWith('.data') ? '.txt' : '');
const library = await initialise({ locateFile });
const generator = library.EsslShaderGenerator.create();
const context = new library.GenContext(generator);
const definitions = library.loadStandardLibraries(context);
const reports = {};
for (const file of process.argv.slice(2)) {
  const report = { errors: '', materials: 0 };
  try {
    const document = library.createDocument();
    await library.readFromXmlString(document, fs.readFileSync(file, 'utf8'), '');
    document.importLibrary(definitions);
    report.is_valid = document.validate();
    for (const material of document.getMaterialNodes()) {
      ++report.materials;
      const source = generator.generate('shader' + report.materials, material, context).getSourceCode('pixel');
      if (!source.includes('void main')) report.errors += material.getName() + ' has no shader\n';
    }
  } catch (problem) {
    report.errors += typeof problem == 'number' ? library.getExceptionMessage(problem) : String(problem);
  }
  reports[file] = report;
}
process.stdout.write(JSON.stringify(reports));
)";

class ExchangeReaders : public NpmTest {
 protected:
  ExchangeReaders() : NpmTest({"tinyusdz@0.9.0-rc10", "@needle-tools/materialx@1.4.6"}) {}

  /// Writes all samples in a format, and returns the names of the files.
  std::vector<std::string> written(const char* format, const std::string& extension) const {
    std::vector<std::string> files;
    for (const std::string& view : test::sample_op_files()) {
      grf::Diagnostics diagnostics;
      const auto options = options::read_op_file(view, diagnostics);
      if (!options || options->scene.empty()) continue;
      auto import = read(*find_format("grf"), options->scene, {}, diagnostics);
      EXPECT_TRUE(import.has_value()) << diagnostics.to_text();
      if (!import) continue;
      files.push_back(folder_.path(std::to_string(files.size()) + extension));
      grf::relocate(import->scene, options->scene, files.back());
      EXPECT_TRUE(find_format(format)->write_view(import->scene, files.back(), {view}, diagnostics))
          << diagnostics.to_text();
    }
    EXPECT_GT(files.size(), 12U);
    return files;
  }

  json reports_of(std::string_view program, const std::vector<std::string>& files) const {
    const test::Outcome outcome = run_program(program, files);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err.substr(0, 2000);
    return outcome.exit_code == 0 ? json::parse(outcome.out) : json::object();
  }
};

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST_F(ExchangeReaders, OfUsdHaveAllMeshes) {
  const std::vector<std::string> files = written("usd", ".usda");
  const json reports = reports_of(UsdProgram, files);
  ASSERT_EQ(reports.size(), files.size());
  int scenes = 0;
  for (const std::string& file : files) {
    const json& report = reports.at(file);
    EXPECT_TRUE(report.at("is_layer").get<bool>()) << report.dump();
    if (!report.at("is_scene").get<bool>()) {
      // It knows no alpha of a texture, which is an output of UsdUVTexture in the specification of
      // UsdPreviewSurface.
      EXPECT_THAT(report.at("errors").get<std::string>(), HasSubstr("`outputs:a`"));
      continue;
    }
    ++scenes;
    EXPECT_EQ(report.at("meshes"), occurrences(test::bytes_of(file), "def Mesh \"")) << file;
  }
  EXPECT_GT(scenes, 12);
}

TEST_F(ExchangeReaders, OfMaterialXHaveShadersOfAllMaterials) {
  const std::vector<std::string> files = written("materialx", ".mtlx");
  const json reports = reports_of(MaterialXProgram, files);
  ASSERT_EQ(reports.size(), files.size());
  for (const std::string& file : files) {
    const json& report = reports.at(file);
    EXPECT_TRUE(report.value("is_valid", false)) << report.dump();
    EXPECT_EQ(report.at("errors"), "") << file;
    EXPECT_EQ(report.at("materials"), occurrences(test::bytes_of(file), "<surfacematerial ")) << file;
  }
}

TEST_F(ExchangeReaders, RefuseWhatIsWrong) {
  const ExchangedScene scene(exchange_cube("brdf diffuse kd=0.4", {}));
  const auto with = [&](const std::string& text, const std::string& word, const std::string& wrong,
                        const std::string& name) {
    std::string changed = text;
    EXPECT_NE(changed.find(word), std::string::npos) << word;
    changed.replace(changed.find(word), word.size(), wrong);
    return folder_.add(name, changed);
  };
  const std::string usd = with(scene.usd_text(), "int[] faceVertexCounts", "int[ faceVertexCounts", "a.usda");
  EXPECT_FALSE(reports_of(UsdProgram, {usd}).at(usd).at("is_layer").get<bool>());
  const std::string type = with(scene.mtlx_text(), "type=\"BSDF\"", "type=\"color3\"", "a.mtlx");
  const std::string node = with(scene.mtlx_text(), "<surface ", "<surfaces ", "b.mtlx");
  const json reports = reports_of(MaterialXProgram, {type, node});
  EXPECT_FALSE(reports.at(type).value("is_valid", false));
  EXPECT_NE(reports.at(node).at("errors"), "");
}

}  // namespace
}  // namespace convert
