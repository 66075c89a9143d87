#include "converters/assimp/assimp_formats.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "converters/assimp/assimp_import.h"
#include "converters/assimp/assimp_materials.h"
#include "converters/assimp/assimp_rules.h"
#include "converters/assimp/assimp_scene.h"
#include "converters/assimp/stl_check.h"
#include "converters/assimp/three_ds.h"
#include "converters/assimp/three_ds_scene.h"
#include "converters/stl/write_stl.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"
#include "grf/text_file.h"

namespace convert {
namespace {

/// Reads the bytes of a file; an empty file is an error.
struct SourceBytes {
  std::shared_ptr<const std::string> bytes;
  grf::SourceLocation location;
};

std::optional<SourceBytes> read_bytes(const std::string& path, grf::Diagnostics& diagnostics) {
  SourceBytes source = {grf::read_file(path, diagnostics), grf::whole_file(path)};
  if (!source.bytes) return {};
  if (!source.bytes->empty()) return source;
  diagnostics.error(source.location, "the file is empty, expected a model");
  return {};
}

void report_messages(const AssimpReading& reading, const AssimpRules& rules,
                     const grf::SourceLocation& location, grf::Diagnostics& diagnostics) {
  for (const AssimpMessage& message : reading.messages) {
    const std::string times = message.count > 1 ? fmt::format(" ({} times)", message.count) : "";
    const std::string text = fmt::format("Assimp says: {}{}", message.text, times);
    if (message.is_error && rules.errors_are_fatal) {
      diagnostics.error(location, text);
    } else {
      diagnostics.warning(location, text);
    }
  }
}

std::optional<Import> finish(const AssimpReading& reading, const AssimpRules& rules, const Losses& losses,
                             const grf::SourceLocation& location, grf::Diagnostics& diagnostics) {
  if (!reading.scene) {
    diagnostics.error(location, reading.error.empty() ? "Assimp cannot read the file" : reading.error);
    return {};
  }
  const std::size_t errors = diagnostics.error_count();
  report_messages(reading, rules, location, diagnostics);
  if (diagnostics.error_count() > errors) return {};
  return make_scene(*reading.scene, rules, losses, location, diagnostics);
}

/// Reads a single-file format by Assimp's importer for the extension.
std::optional<Import> read_by_extension(const std::string& path, const AssimpRules& rules,
                                        const std::string& extension, grf::Diagnostics& diagnostics) {
  const auto source = read_bytes(path, diagnostics);
  if (!source) return {};
  return finish(import_bytes(*source->bytes, extension), rules, {}, source->location, diagnostics);
}

/// Counts subdivision surfaces in AC3D: objects with a line `subdiv` and a level.
Losses losses_of_ac3d(std::string_view bytes) {
  constexpr std::string_view Line = "\nsubdiv ";
  const std::string text = to_utf8(bytes);
  Losses losses;
  for (std::size_t i = text.find(Line); i != std::string::npos; i = text.find(Line, i + 1)) {
    const std::size_t level = i + Line.size();
    if (level < text.size() && text[level] != '0') losses.add(Loss::Subdivision);
  }
  return losses;
}

/// Counts subdivision surfaces in LWO: lists of polygons (POLS, a size of four bytes) of the kinds PTCH and
/// SUBD.
Losses losses_of_lwo(std::string_view bytes) {
  Losses losses;
  for (std::size_t i = bytes.find("POLS"); i != std::string_view::npos; i = bytes.find("POLS", i + 1)) {
    const std::string_view kind = bytes.substr(i).substr(std::min<std::size_t>(8, bytes.size() - i), 4);
    if (kind == "PTCH" || kind == "SUBD") losses.add(Loss::Subdivision);
  }
  return losses;
}

/// Detects a truncated file, of which Assimp would read the remaining chunks, by the size in the header (IFF:
/// of the bytes after the first eight, big-endian).
std::optional<Import> read_lwo(const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
  const auto source = read_bytes(path, diagnostics);
  if (!source) return {};
  constexpr std::size_t IffHeaderSize = 8;
  const std::string& bytes = *source->bytes;
  std::uint64_t size = IffHeaderSize;
  for (std::size_t i = 0; i < 4 && bytes.size() >= IffHeaderSize; ++i) {
    size += std::uint64_t{static_cast<std::uint8_t>(bytes[4 + i])} << (24 - 8 * i);
  }
  if (size > bytes.size()) {
    diagnostics.error(source->location, fmt::format("the file has {}, and says that it has {}: it is "
                                                    "truncated or damaged",
                                                    counted(bytes.size(), "byte", "bytes"), size));
    return {};
  }
  return finish(import_bytes(bytes, "lwo"), LwoRules, losses_of_lwo(bytes), source->location, diagnostics);
}

std::optional<Import> read_3ds(const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
  const auto source = read_bytes(path, diagnostics);
  if (!source) return {};
  const auto file = read_three_ds(*source->bytes, source->location, diagnostics);
  if (!file) return {};
  const AssimpReading reading = import_bytes(*source->bytes, "3ds");
  Losses losses;
  if (reading.scene) restore_three_ds(*file, *reading.scene, losses);
  return finish(reading, ThreeDsRules, losses, source->location, diagnostics);
}

std::optional<Import> read_stl(const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
  const auto source = read_bytes(path, diagnostics);
  if (!source) return {};
  const auto bytes = check_stl(*source->bytes, source->location, diagnostics);
  if (!bytes) return {};
  return finish(import_bytes(*bytes, "stl"), StlRules, {}, source->location, diagnostics);
}

/// Reads a text format in any encoding by converting it to UTF-8: some of Assimp's conversions from UTF-16
/// fail.
AssimpReading import_text(std::string_view bytes, const std::string& extension) {
  return import_bytes(to_utf8(bytes), extension);
}

// A zip archive of COLLADA is not text, and Assimp can read it only from a file.
std::optional<Import> read_collada(const std::string& path, const ReadOptions&,
                                   grf::Diagnostics& diagnostics) {
  const auto source = read_bytes(path, diagnostics);
  if (!source) return {};
  const bool is_archive = source->bytes->starts_with("PK");
  return finish(is_archive ? import_file(path) : import_text(*source->bytes, "dae"), ColladaRules, {},
                source->location, diagnostics);
}

std::optional<Import> read_ac3d(const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
  const auto source = read_bytes(path, diagnostics);
  if (!source) return {};
  return finish(import_text(*source->bytes, "ac"), Ac3dRules, losses_of_ac3d(*source->bytes),
                source->location, diagnostics);
}

// Files of these formats may refer to others beside them.
std::optional<Import> read_other(const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
  const auto source = read_bytes(path, diagnostics);
  if (!source) return {};
  return finish(import_file(path), OtherRules, {}, source->location, diagnostics);
}

bool sniff_3ds(std::string_view bytes) {
  // The main chunk is only marked by its number, so that the number of the first chunk in it is tested too.
  constexpr std::string_view Version("\x02\0", 2);
  const std::string_view first = bytes.substr(std::min<std::size_t>(6, bytes.size()), 2);
  return bytes.starts_with("MM") && (first == Version || first == "==");
}

bool sniff_dxf(std::string_view bytes) {
  if (bytes.starts_with("AutoCAD Binary DXF")) return true;
  std::vector<std::string_view> lines;
  while (!bytes.empty() && lines.size() < 64) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    const std::size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
    line.remove_prefix(begin);
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    lines.push_back(line);
  }
  // DXF is pairs of lines, a group code and a value; 999 is for comments.
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    if (lines[i] != "999") return lines[i] == "0" && lines[i + 1] == "SECTION";
  }
  return false;
}

bool sniff_collada(std::string_view bytes) { return to_utf8(bytes).find("<COLLADA") != std::string::npos; }

bool sniff_fbx(std::string_view bytes) {
  return bytes.starts_with("Kaydara FBX Binary") || bytes.starts_with("; FBX") ||
         bytes.starts_with("FBXHeaderExtension:");
}

bool sniff_lwo(std::string_view bytes) {
  constexpr std::array<std::string_view, 4> Kinds = {"LWOB", "LWO2", "LWLO", "LXOB"};
  const std::string_view kind = bytes.substr(std::min<std::size_t>(8, bytes.size()), 4);
  return bytes.starts_with("FORM") && std::find(Kinds.begin(), Kinds.end(), kind) != Kinds.end();
}

bool sniff_other(std::string_view bytes) {
  constexpr std::array<std::string_view, 18> Marks = {"IDP2",       "IDP3",
                                                      "IDPC",       "IDPO",
                                                      "MD5Version", "MS3D000000",
                                                      "BLENDER",    "LWSC",
                                                      "BB3D",       "Caligari V00.",
                                                      "HMP4",       "HMP5",
                                                      "HMP7",       "quest3Do",
                                                      "IQM",        "INTERQUAKEMODEL",
                                                      "TERRAGEN",   "*3DSMAX_ASCIIEXPORT"};
  return std::any_of(Marks.begin(), Marks.end(),
                     [bytes](std::string_view mark) { return bytes.starts_with(mark); });
}

}  // namespace

Format three_ds_format() {
  Format format;
  format.name = "3ds";
  format.title = "3D Studio";
  format.extensions = {"3ds"};
  format.sniff = sniff_3ds;
  format.read = read_3ds;
  format.keeps =
      "triangles, shared vertices, smoothing groups, texture coordinates, objects, transforms, instances, "
      "materials, textures, emission";
  format.loses = "bump and other maps, transparency, cameras, lights, animation";
  format.read_materials = assimp_material_rules();
  return format;
}

Format stl_format() {
  Format format;
  format.name = "stl";
  format.title = "Stereolithography, in text or binary, written as binary";
  format.extensions = {"stl"};
  format.sniff = is_text_stl;
  format.read = read_stl;
  format.write = write_stl;
  format.keeps = "triangles; when read, solids and colours of facets";
  format.loses =
      "when read, normals of facets that their corners contradict; when written, shared vertices, polygons "
      "(cut into triangles), names, materials, colours, textures and their coordinates, normals, lights, "
      "irradiance, transforms and instances (applied)";
  return format;
}

Format dxf_format() {
  Format format;
  format.name = "dxf";
  format.title = "AutoCAD DXF";
  format.extensions = {"dxf"};
  format.sniff = sniff_dxf;
  format.read = [](const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
    return read_by_extension(path, DxfRules, "dxf", diagnostics);
  };
  format.keeps = "polygons, shared vertices, layers";
  format.loses = "lines, curves, solids, colours, rotation of blocks, binary files";
  return format;
}

Format collada_format() {
  Format format;
  format.name = "collada";
  format.title = "COLLADA";
  format.extensions = {"dae", "zae"};
  format.sniff = sniff_collada;
  format.read = read_collada;
  format.keeps =
      "polygons, shared vertices, normals, one set of texture coordinates, vertex colours, objects, "
      "transforms, instances, materials, textures, emission";
  format.loses = "bump and other maps, transparency, lines, cameras, lights, animation, bones";
  format.read_materials = assimp_material_rules();
  return format;
}

Format fbx_format() {
  Format format = collada_format();
  format.name = "fbx";
  format.title = "Autodesk FBX, in text or binary";
  format.extensions = {"fbx"};
  format.sniff = sniff_fbx;
  format.read = [](const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
    return read_by_extension(path, FbxRules, "fbx", diagnostics);
  };
  return format;
}

Format lwo_format() {
  Format format;
  format.name = "lwo";
  format.title = "LightWave object";
  format.extensions = {"lwo", "lxo"};
  format.sniff = sniff_lwo;
  format.read = read_lwo;
  format.keeps =
      "polygons, shared vertices, smoothing angles, one set of texture coordinates, vertex colours, layers, "
      "materials, textures, emission";
  format.loses = "bump and other maps, transparency, subdivision, lines, points";
  format.read_materials = assimp_material_rules();
  return format;
}

Format ac3d_format() {
  Format format;
  format.name = "ac3d";
  format.title = "AC3D";
  format.extensions = {"ac", "acc", "ac3d"};
  format.sniff = [](std::string_view bytes) { return to_utf8(bytes).starts_with("AC3D"); };
  format.read = read_ac3d;
  format.keeps =
      "polygons, shared vertices, texture coordinates, objects, transforms, materials, textures, emission";
  format.loses = "transparency, crease angles, subdivision, lines, lights";
  format.read_materials = assimp_material_rules();
  return format;
}

Format x_format() {
  Format format;
  format.name = "x";
  format.title = "DirectX model";
  format.extensions = {"x"};
  format.sniff = [](std::string_view bytes) { return bytes.starts_with("xof 0"); };
  format.read = [](const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
    return read_by_extension(path, XRules, "x", diagnostics);
  };
  format.keeps =
      "polygons, shared vertices, normals, one set of texture coordinates, vertex colours, objects, "
      "transforms, materials, textures, emission";
  format.loses = "other maps, transparency, animation, bones";
  format.read_materials = assimp_material_rules();
  return format;
}

Format other_assimp_format() {
  Format format;
  format.name = "other";
  format.title = "Other formats that Assimp reads";
  format.extensions = {"3d",      "3mf", "amf", "ase",    "ask",  "assbin", "b3d",     "blend", "bsp", "cob",
                       "enff",    "hmp", "ifc", "ifczip", "iqm",  "irr",    "irrmesh", "lws",   "md2", "md3",
                       "md5mesh", "mdc", "mdl", "mesh",   "ms3d", "ndo",    "nff",     "ogex",  "pk3", "pmx",
                       "prj",     "q3o", "q3s", "raw",    "scn",  "sib",    "smd",     "step",  "stp", "ter",
                       "uc",      "vta", "x3d", "x3db",   "xgl",  "xml",    "zgl"};
  format.sniff = sniff_other;
  format.read = read_other;
  format.keeps = "what Assimp reads: faces, normals, texture coordinates, colours, transforms, materials";
  format.loses = "bump and other maps, transparency, lines, points, cameras, lights, animation, bones";
  format.read_materials = assimp_material_rules();
  return format;
}

}  // namespace convert
