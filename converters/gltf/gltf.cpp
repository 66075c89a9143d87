#include "converters/gltf/gltf.h"

#include <algorithm>
#include <array>

#include "converters/gltf/gltf_file.h"
#include "converters/gltf/gltf_material_writer.h"
#include "converters/gltf/gltf_materials.h"
#include "converters/gltf/gltf_reader.h"
#include "converters/gltf/gltf_writer.h"
#include "grf/text_file.h"

namespace convert {
namespace {

bool is_glb(std::string_view first_bytes) { return first_bytes.starts_with(GlbMagic); }

/// Detects a JSON object with a top-level key of glTF among the first bytes.
bool is_gltf(std::string_view first_bytes) {
  constexpr std::array<std::string_view, 6> Names = {
      "\"asset\"", "\"accessors\"", "\"bufferViews\"", "\"extensionsUsed\"", "\"animations\"", "\"buffers\""};
  if (first_bytes.starts_with(grf::ByteOrderMark)) first_bytes.remove_prefix(grf::ByteOrderMark.size());
  first_bytes.remove_prefix(std::min(first_bytes.find_first_not_of(" \t\r\n"), first_bytes.size()));
  return first_bytes.starts_with('{') && std::any_of(Names.begin(), Names.end(), [&](std::string_view name) {
           return first_bytes.find(name) != std::string_view::npos;
         });
}

Format common() {
  Format format;
  format.read = read_gltf;
  format.has_variants = true;
  format.keeps =
      "all of a scene that came from GRF (in extras); else polygons as triangles, shared vertices, normals, "
      "texture coordinates, vertex colours, textures, names, transforms, instances, materials with clear "
      "coats, sheen and anisotropy, glass, emission, opacity, perspective cameras (those of OP files)";
  format.loses =
      "normal, occlusion and emission maps, rough transmission, points, lines, other cameras, lenses, cones "
      "of spot lights, animations; for other programs: BRDFs that are not metallic-roughness, sampling "
      "schemes, irradiance";
  format.read_materials = gltf_material_rules();
  format.written_materials = gltf_material_writer_rules();
  return format;
}

}  // namespace

Format gltf_format() {
  Format format = common();
  format.name = "gltf";
  format.title = "glTF 2 as JSON, with a .bin file beside it";
  format.extensions = {"gltf"};
  format.sniff = is_gltf;
  format.write = [](const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
    return write_gltf(scene, path, {}, diagnostics);
  };
  format.write_view = write_gltf;
  return format;
}

Format glb_format() {
  Format format = common();
  format.name = "glb";
  format.title = "glTF 2 as one binary file";
  format.extensions = {"glb"};
  format.sniff = is_glb;
  format.embeds_images = true;
  format.write = [](const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
    return write_glb(scene, path, {}, diagnostics);
  };
  format.write_view = write_glb;
  return format;
}

}  // namespace convert
