#include "tests/benchmarks/render/scenes.h"

#include <stdexcept>

#include "grf/text_file.h"
#include "renderer/image/image_file.h"
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

void write_picture(const fs::path& file, const image::Image& image) {
  grf::Diagnostics diagnostics;
  if (!image::write_image({image}, file.string(), diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
}

void make_environment_map(const fs::path& file) {
  if (fs::exists(ForestMap)) {
    fs::copy_file(ForestMap, file, fs::copy_options::overwrite_existing);
    return;
  }
  write_picture(file, outdoor_map());
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
  return {own.filename().string(), own / (name + ".op"), true};
}

fs::path source_of(const char* name) {
  return fs::path(GRANADA_SOURCE_DIR "/tests/benchmarks/render/scenes") / name;
}

SceneFiles make_many_lamps(const fs::path& folder, int lamps, bool small) {
  const fs::path own = folder / ("many_lamps_" + std::to_string(lamps));
  auto scene = make_scene(own, source_of("many_lamps"),
                          {{"sphere", 4'000, "metal"}, {"knot", 20'000, "coated"}}, small);
  write(own / "many_lamps.grf", hall_of_lamps(lamps));
  return scene;
}

SceneFiles make_many_brdfs(const fs::path& folder, bool small) {
  const fs::path own = folder / "many_brdfs";
  auto scene = make_scene(own, source_of("many_brdfs"),
                          {{"sphere", 4'000, "material"}, {"knot", 20'000, "material"}}, small);
  for (const char* shape : {"block.grf", "cushion.grf", "ring.grf", "vase.grf"}) {
    fs::copy_file(fs::path(GRANADA_SOURCE_DIR "/samples/gallery/shapes") / shape, own / shape,
                  fs::copy_options::overwrite_existing);
  }
  const auto exported =
      test::run({GRANADA_BIN_DIR "/bpt", "brdf", "export",
                 "torrance rough=0.18 nreal=1.98 nimag=3.74 ks=(0.16, 0.36, 0.8) kd=(0.01, 0.03, 0.1)", "-o",
                 (own / "blue_paint.binary").string()});
  if (exported.exit_code != 0) throw std::runtime_error("bpt brdf export: " + exported.err);
  scene.is_in_cycles = false;
  return scene;
}

SceneFiles make_instances(const fs::path& folder, bool small) {
  const fs::path own = folder / "instances";
  auto scene = make_scene(own, source_of("instances"), {}, small);
  write(own / "instances.grf", forest(10'000, small ? 40 : 1'000));
  write_picture(own / "outdoor.exr", outdoor_map());
  return scene;
}

SceneFiles make_textured(const fs::path& folder, bool small) {
  constexpr int Textures = 50;
  const fs::path own = folder / "textured";
  auto scene = make_scene(own, source_of("textured"), {}, small);
  write(own / "textured.grf", stairs_of_vases(Textures, small ? 12 : 48));
  for (int i = 0; i < Textures; ++i)
    write_picture(own / texture_name(i), texture_pattern(i, small ? 16 : 512));
  return scene;
}

SceneFiles make_interior(const fs::path& folder, bool small) {
  const fs::path own = folder / "interior";
  auto scene =
      make_scene(own, source_of("interior"), {{"sphere", 4'000, "metal"}, {"knot", 20'000, "coated"}}, small);
  image::Image map = outdoor_map();
  for (auto& pixel : map.pixels) pixel *= 20;  // as a camera exposes a room
  write_picture(own / "outdoor.exr", map);
  return scene;
}

}  // namespace

std::vector<SceneFiles> make_scenes(const fs::path& folder, bool small) {
  const Shape sphere = {"sphere", 16'000, "metal"};
  std::vector<SceneFiles> scenes;
  const auto make = [&](const fs::path& source, const std::vector<Shape>& shapes) {
    scenes.push_back(make_scene(folder / source.filename(), source, shapes, small));
  };
  make(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box", {});
  make(source_of("glossy_sphere"), {sphere});
  make(source_of("coated_knot"), {{"knot", 100'000, "coated"}});
  make(source_of("environment"), {sphere, {"knot", 70'000, "glossy"}});
  make_environment_map(folder / "environment" / "outdoor.exr");
  for (const int lamps : {100, 400}) scenes.push_back(make_many_lamps(folder, lamps, small));
  scenes.push_back(make_many_brdfs(folder, small));
  scenes.push_back(make_instances(folder, small));
  scenes.push_back(make_textured(folder, small));
  scenes.push_back(make_interior(folder, small));
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

SceneFiles make_material_scene(const fs::path& folder, const std::string& definition, bool is_in_white) {
  const fs::path source = GRANADA_SOURCE_DIR "/tests/benchmarks/render/materials/material";
  auto scene = make_scene(folder, source, {{"sphere", 20'000, "material"}}, false);
  write(folder / "material.grf", definition + "\nbegin\n  include \"sphere.grf\"\nend\n");
  if (is_in_white) {
    write_picture(folder / "surroundings.exr", {8, 4, std::vector<grf::Colour>(32, grf::Colour(1))});
  } else {
    fs::copy_file(GRANADA_SOURCE_DIR "/samples/environments/studio.exr", folder / "surroundings.exr",
                  fs::copy_options::overwrite_existing);
  }
  return scene;
}

}  // namespace benchmark
