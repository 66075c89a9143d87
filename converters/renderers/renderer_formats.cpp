#include "converters/renderers/renderer_formats.h"

#include <algorithm>

#include <fmt/format.h>

#include "converters/losses.h"
#include "converters/renderers/mitsuba_text.h"
#include "converters/renderers/pbrt_text.h"
#include "converters/renderers/renderer_materials.h"
#include "converters/renderers/written_scene.h"
#include "converters/wording.h"
#include "grf/text_file.h"

namespace convert {
namespace {

/// Notes how far the tables of BRDFs are from them.
void note_table_errors(const WrittenScene& scene, grf::Diagnostics& diagnostics) {
  std::size_t tables = 0;
  double largest = 0;
  for (const WrittenMaterial& material : scene.materials) {
    if (material.base != WrittenMaterial::Base::Measured) continue;
    ++tables;
    largest = std::max(largest, material.table_error);
  }
  if (tables == 0) return;
  diagnostics.note(grf::whole_file(scene.path),
                   fmt::format("{} with a mean error of up to {:.2g} % of the mean value",
                               counted(tables, "BRDF is tabulated", "BRDFs are tabulated"), 100 * largest));
}

/// Writes a scene with its files; false after an error.
bool write_scene(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
                 const RenderTarget& target, std::string (*text)(const WrittenScene& scene),
                 std::string_view name, grf::Diagnostics& diagnostics) {
  Losses losses;
  const auto written = write_scene_files(scene, path, options.op_file, target, losses, diagnostics);
  if (!written || !grf::replace_file(path, text(*written), diagnostics)) return false;
  losses.report_written(grf::whole_file(path), name, diagnostics);
  note_table_errors(*written, diagnostics);
  return true;
}

bool write_pbrt(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
                grf::Diagnostics& diagnostics) {
  return write_scene(scene, path, options, pbrt_target(), pbrt_text, "pbrt", diagnostics);
}

bool write_mitsuba(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
                   grf::Diagnostics& diagnostics) {
  return write_scene(scene, path, options, mitsuba_target(), mitsuba_text, "Mitsuba", diagnostics);
}

bool sniff_nothing_of_pbrt(std::string_view) { return false; }

/// Skips white space, the declaration and comments; the root element of a scene follows.
bool sniff_mitsuba(std::string_view bytes) {
  for (;;) {
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return false;
    bytes.remove_prefix(begin);
    const std::string_view close = bytes.starts_with("<!--") ? "-->" : bytes.starts_with("<?") ? "?>" : "";
    if (close.empty()) return bytes.starts_with("<scene version=");
    const std::size_t end = bytes.find(close);
    if (end == std::string_view::npos) return false;
    bytes.remove_prefix(end + close.size());
  }
}

constexpr std::string_view Kept =
    "faces in their order, as triangles, normals, texture coordinates, instances, area lights, BRDFs (as "
    "tables, where the renderer has no such model), colours of faces and vertices, textures of diffuse "
    "faces, opacity; with an OP file its camera, lens, film size, samples, depth and environment map";
constexpr std::string_view Lost =
    "polygons (cut into triangles), names, sampling schemes, irradiance, textures of BRDFs that are not "
    "diffuse, normals of emitting faces, backplates, camera paths";

}  // namespace

Format pbrt_format() {
  Format format;
  format.name = "pbrt";
  format.title = "pbrt-v4 scene, with a folder of its files beside it";
  format.extensions = {"pbrt"};
  format.sniff = sniff_nothing_of_pbrt;
  format.write = [](const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
    return write_pbrt(scene, path, {}, diagnostics);
  };
  format.write_view = write_pbrt;
  format.keeps = Kept;
  format.loses = Lost;
  format.embeds_images = true;
  format.written_materials = pbrt_materials();
  return format;
}

Format mitsuba_format() {
  Format format;
  format.name = "mitsuba";
  format.title = "Mitsuba 3 scene, with a folder of its files beside it";
  format.extensions = {"xml"};
  format.sniff = sniff_mitsuba;
  format.write = [](const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
    return write_mitsuba(scene, path, {}, diagnostics);
  };
  format.write_view = write_mitsuba;
  format.keeps = Kept;
  format.loses = Lost;
  format.embeds_images = true;
  format.written_materials = mitsuba_materials();
  return format;
}

}  // namespace convert
