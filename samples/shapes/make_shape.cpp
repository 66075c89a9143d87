// Writes a closed mesh with smooth normals as GRF, made by formula and the same on every machine: a subject
// for measurements that need a chosen number of triangles. It stands on y = 0 about the y axis, and its
// longest side is 2. samples/shapes/shape.h says what the shapes are.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "grf/write.h"
#include "samples/shapes/shape.h"

namespace {

using grf::Mesh;

struct Maker {
  std::string_view name;
  Mesh (*make)(int triangles);
};

constexpr std::array<Maker, 4> Makers = {
    {{"knot", shape::knot}, {"sphere", shape::sphere}, {"dragon", shape::dragon}, {"jug", shape::jug}}};

grf::Scene scene_of(Mesh mesh, const std::string& name, const std::string& brdf, const std::string& pdf) {
  mesh.name = name;
  if (!brdf.empty()) mesh.surfaces[0].brdf = grf::Reference{brdf, {}};
  if (!pdf.empty()) mesh.surfaces[0].pdf = grf::Reference{pdf, {}};
  grf::Scene scene;
  grf::Block block;
  block.content = grf::Shared<Mesh>(std::move(mesh));
  scene.contents.blocks.push_back(std::move(block));
  return scene;
}

}  // namespace

int main(int argc, char** argv) {
  const auto word = [&](int i) { return std::string(argc > i ? argv[i] : ""); };
  const std::string count = word(2);
  int triangles = 0;
  std::from_chars(count.data(), count.data() + count.size(), triangles);
  const auto maker =
      std::find_if(Makers.begin(), Makers.end(), [&](const Maker& one) { return one.name == word(1); });
  if (argc < 4 || argc > 6 || maker == Makers.end() || triangles < 100 || triangles > 100'000'000) {
    fmt::print(
        stderr,
        "usage: make_shape knot|sphere|dragon|jug TRIANGLES FILE.grf [BRDF [PDF]]\n"
        "TRIANGLES from 100 to 100000000: what comes nearest. BRDF, PDF: names of definitions where the file "
        "is included\n");
    return 2;
  }
  grf::Diagnostics diagnostics;
  if (grf::write(scene_of(maker->make(triangles), word(1), word(4), word(5)), word(3), diagnostics)) return 0;
  fmt::print(stderr, "{}", diagnostics.to_text());
  return 1;
}
