#include "converters/vrml/vrml.h"

#include <utility>

#include "converters/vrml/appearance.h"
#include "converters/vrml/source.h"
#include "converters/vrml/world.h"

namespace convert {
namespace {

std::optional<Import> import_of(std::shared_ptr<const vrml::Source> source, grf::Diagnostics& diagnostics) {
  if (!source) return std::nullopt;
  const std::string path = source->path();
  auto scene = vrml::World(path, diagnostics).read(std::move(source));
  if (!scene) return std::nullopt;
  return Import{std::move(*scene), {}};
}

std::optional<Import> read_vrml(const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
  return import_of(vrml::read_source(path, {}, diagnostics), diagnostics);
}

}  // namespace

std::optional<Import> read_vrml_bytes(std::string_view bytes, const std::string& path,
                                      grf::Diagnostics& diagnostics) {
  return import_of(vrml::make_source(bytes, path, {}, diagnostics), diagnostics);
}

Format vrml_format() {
  Format format;
  format.name = "vrml";
  format.title = "VRML 1.0 and VRML97";
  format.extensions = {"wrl", "wrz", "vrml"};
  format.sniff = vrml::sniff;
  format.read = read_vrml;
  format.keeps =
      "polygons, shared vertices, normals, texture coordinates, colours of vertices and faces, names, "
      "materials, textures, emission, transforms, instances, inlined files";
  format.loses =
      "lights, viewpoints, lines, points, text, prototypes, scripts, animation, pixels of "
      "textures in the file, curves of solids";
  format.read_materials = vrml::material_rules();
  return format;
}

}  // namespace convert
