#include "tests/benchmarks/render/scenes.h"

#include <stdexcept>

#include "grf/text_file.h"
#include "renderer/transport/image/image_file.h"
#include "tests/benchmarks/render/generated_scenes.h"
#include "tests/benchmarks/render/outdoor_map.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"

namespace benchmark {
namespace {

namespace fs = std::filesystem;

constexpr const char* ForestMap = "/usr/share/blender/datafiles/studiolights/world/forest.exr";

struct Shape {
  const char* shape;
  int triangles;
  const char* brdf;  ///< its name in the scene
};

void make_shape(const fs::path& folder, const Shape& shape, bool small) {
  const std::string triangles = std::to_string(small ? 2000 : shape.triangles);
  const std::string file = (folder / shape.shape).string() + ".grf";
  const auto made = test::run({GRANADA_BIN_DIR "/make_shape", shape.shape, triangles, file, shape.brdf});
  if (made.exit_code != 0) throw std::runtime_error("make_shape: " + made.err);
}

void make_environment_map(const fs::path& file) {
  if (fs::exists(ForestMap)) {
    fs::copy_file(ForestMap, file, fs::copy_options::overwrite_existing);
    return;
  }
  grf::Diagnostics diagnostics;
  if (!transport::write_image({outdoor_map()}, file.string(), diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
}

void write(const fs::path& file, const std::string& text) {
  grf::Diagnostics diagnostics;
  if (!grf::replace_file(file.string(), text, diagnostics)) throw std::runtime_error(diagnostics.to_text());
}

/// Copies SOURCE.op, and SOURCE.grf unless the scene is generated, into the scene's own folder, and makes its
/// meshes there.
SceneFiles make_scene(const fs::path& own, const fs::path& source, const std::vector<Shape>& shapes,
                      bool small) {
  const std::string name = source.filename().string();
  fs::create_directories(own);
  for (const char* extension : {".grf", ".op"}) {
    const fs::path file = source.string() + extension;
    if (fs::exists(file)) fs::copy_file(file, own / (name + extension), fs::copy_options::overwrite_existing);
  }
  for (const Shape& shape : shapes) make_shape(own, shape, small);
  return {own.filename().string(), own / (name + ".op")};
}

}  // namespace

std::vector<SceneFiles> make_scenes(const fs::path& folder, bool small) {
  const fs::path sources = GRANADA_SOURCE_DIR "/tests/benchmarks/render/scenes";
  const Shape sphere = {"sphere", 16'000, "metal"};
  std::vector<SceneFiles> scenes;
  const auto make = [&](const fs::path& source, const std::vector<Shape>& shapes) {
    scenes.push_back(make_scene(folder / source.filename(), source, shapes, small));
  };
  make(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box", {});
  make(sources / "glossy_sphere", {sphere});
  make(sources / "coated_knot", {{"knot", 100'000, "coated"}});
  make(sources / "environment", {sphere, {"knot", 70'000, "glossy"}});
  make_environment_map(folder / "environment" / "outdoor.exr");
  for (const int lamps : {100, 400}) {
    const fs::path own = folder / ("many_lamps_" + std::to_string(lamps));
    scenes.push_back(make_scene(own, sources / "many_lamps",
                                {{"sphere", 4'000, "metal"}, {"knot", 20'000, "coated"}}, small));
    write(own / "many_lamps.grf", hall_of_lamps(lamps));
  }
  return scenes;
}

std::vector<SceneFiles> make_artefact_scenes(const fs::path& folder) {
  const fs::path sources = GRANADA_SOURCE_DIR "/tests/benchmarks/render/artefacts";
  const Shape coarse = {"sphere", 200, "matte"};
  const Shape fine = {"sphere", 200'000, "matte"};
  return {make_scene(folder / "terminator", sources / "terminator", {coarse}, false),
          make_scene(folder / "fine_terminator", sources / "terminator", {fine}, false),
          make_scene(folder / "closed_room", sources / "closed_room", {coarse}, false),
          make_scene(folder / "contact", sources / "contact", {}, false)};
}

}  // namespace benchmark
