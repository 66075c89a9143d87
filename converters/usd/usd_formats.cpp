#include "converters/usd/usd_formats.h"

#include "converters/losses.h"
#include "converters/usd/exchange_rules.h"
#include "converters/usd/mtlx_text.h"
#include "converters/usd/usd_scene.h"
#include "grf/relocate.h"
#include "grf/text_file.h"

namespace convert {
namespace {

bool write_usd(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
               grf::Diagnostics& diagnostics) {
  const grf::Scene whole = grf::flatten(scene, path);
  const auto result = usd_scene_of(whole, path, options, diagnostics);
  if (!result || !grf::replace_file(path, result->text, diagnostics)) return false;
  result->losses.report_written(grf::whole_file(path), "USD", diagnostics);
  return true;
}

bool write_materialx(const grf::Scene& scene, const std::string& path, const WriteOptions&,
                     grf::Diagnostics& diagnostics) {
  const grf::Scene whole = grf::flatten(scene, path);
  UsdScene result = usd_scene_of(whole, path);
  if (!grf::replace_file(path, mtlx_text(result), diagnostics)) return false;
  result.losses.add(Loss::Geometry, result.meshes);
  result.losses.report_written(grf::whole_file(path), "MaterialX", diagnostics);
  return true;
}

bool sniff_usd(std::string_view bytes) { return bytes.starts_with("#usda "); }

bool sniff_materialx(std::string_view bytes) {
  const std::size_t root = bytes.find("<materialx");
  return root != std::string_view::npos && bytes.substr(0, root).find_first_not_of(" \t\r\n") == 0 &&
         bytes.starts_with("<?xml");
}

}  // namespace

Format usd_format() {
  Format format;
  format.name = "usd";
  format.title = "Universal Scene Description, as text";
  format.extensions = {"usda"};
  format.sniff = sniff_usd;
  format.write = [](const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
    return write_usd(scene, path, {}, diagnostics);
  };
  format.write_view = write_usd;
  format.keeps =
      "polygons, shared vertices, normals, texture coordinates, colours of faces and vertices, names, "
      "transforms, "
      "instances, lights, emission, textures, opacity, materials for UsdPreviewSurface and MaterialX, the "
      "text of "
      "surfaces; with an OP file its cameras, lens, film size and environment map";
  format.loses =
      "sampling schemes, irradiance, backplates, camera paths; for other programs: BRDFs that MaterialX "
      "lacks";
  format.written_materials = usd_materials();
  return format;
}

Format materialx_format() {
  Format format;
  format.name = "materialx";
  format.title = "MaterialX 1.39 document";
  format.extensions = {"mtlx"};
  format.sniff = sniff_materialx;
  format.write = [](const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
    return write_materialx(scene, path, {}, diagnostics);
  };
  format.write_view = write_materialx;
  format.keeps =
      "materials with textures, emission and opacity, the text of surfaces, and which faces of the "
      "scene's USD file have them";
  format.loses = "all but materials, sampling schemes; for other programs: BRDFs that MaterialX lacks";
  format.written_materials = materialx_materials();
  return format;
}

}  // namespace convert
