// Writes the Utah teapot as OBJ: quads with normals, y up.
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "grf/diagnostics.h"
#include "grf/text_file.h"
#include "samples/shapes/teapot.h"

namespace {

using grf::Vec3f;

/// Five decimals, without the sign of a 0, which the reflections make.
std::string numbers(const Vec3f& v) {
  std::string text;
  for (const float x : {v.x, v.y, v.z}) text += fmt::format(" {:.6g}", std::round(1e5F * x) / 1e5F + 0.0F);
  return text;
}

std::string teapot(int subdivisions) {
  std::string text =
      fmt::format("# The Utah teapot, {0} by {0} quads a patch: make_teapot {0}\no teapot\n", subdivisions);
  std::size_t first = 1;
  for (const shape::Patch& patch : shape::teapot_patches(subdivisions)) {
    for (std::size_t i = 0; i < patch.positions.size(); ++i)
      text += fmt::format("v{}\nvn{}\n", numbers(patch.positions[i]), numbers(patch.normals[i]));
    for (const auto& corners : patch.faces) {
      text += "f";
      for (const std::uint32_t corner : corners) text += fmt::format(" {0}//{0}", corner + first);
      text += "\n";
    }
    first += patch.positions.size();
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  int subdivisions = 0;
  const std::string count = argc == 3 ? argv[1] : "";
  std::from_chars(count.data(), count.data() + count.size(), subdivisions);
  if (subdivisions < 1 || subdivisions > 1000) {
    fmt::print(stderr,
               "usage: make_teapot SUBDIVISIONS FILE.obj    (1 to 1000 quads along a side of a patch)\n");
    return 2;
  }
  grf::Diagnostics diagnostics;
  if (grf::replace_file(argv[2], teapot(subdivisions), diagnostics)) return 0;
  fmt::print(stderr, "{}", diagnostics.to_text());
  return 1;
}
