#include "converters/ply/ply.h"

#include "converters/ply/ply_header.h"
#include "converters/ply/read_ply.h"
#include "converters/ply/write_ply.h"

namespace convert {
namespace {

constexpr std::string_view Lost =
    "names of meshes, BRDFs but for their names, sampling schemes, emission, opacity, lights, irradiance, "
    "transforms and instances (applied)";

bool sniff_nothing(std::string_view) { return false; }

}  // namespace

Format ply_format() {
  Format format;
  format.name = "ply";
  format.title = "PLY, Stanford's polygon format";
  format.extensions = {"ply"};
  format.sniff = begins_as_ply;
  format.read = read_ply;
  format.write = write_ply;
  format.keeps =
      "polygons, triangle strips, shared vertices, normals, texture coordinates, colours of vertices and "
      "faces, "
      "textures, names of materials";
  format.loses = Lost;
  return format;
}

Format ply_ascii_format() {
  Format format = ply_format();
  format.name = "ply-ascii";
  format.title = "PLY as text";
  format.sniff = sniff_nothing;
  format.read = nullptr;
  format.write = write_ply_ascii;
  return format;
}

}  // namespace convert
