#include "converters/ply/write_ply.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "converters/losses.h"
#include "converters/ply/ply_layout.h"
#include "converters/ply/ply_mesh.h"
#include "converters/world_meshes.h"
#include "grf/relocate.h"
#include "grf/text_file.h"

namespace convert {
namespace {

/// A writer of the body of a file, value by value.
class PlyOutput {
 public:
  PlyOutput(bool is_text, const grf::FileWriter& write) : is_text_(is_text), write_(write) {}

  void put_text(std::string_view text) { buffer_ += text; }
  void put(float value) {
    if (is_text_) return put_word(value);
    put_bytes(std::bit_cast<std::uint32_t>(value), sizeof value);
  }
  void put(std::int32_t value) {
    if (is_text_) return put_word(value);
    put_bytes(std::bit_cast<std::uint32_t>(value), sizeof value);
  }
  void put(std::uint8_t value) {
    if (is_text_) return put_word(unsigned{value});
    put_bytes(value, 1);
  }

  /// Ends an element; returns false if the file could not be written.
  bool end_element() {
    if (is_text_) buffer_.back() = '\n';
    return buffer_.size() < LargestBuffer || flush();
  }
  bool flush() {
    const bool is_written = write_(buffer_);
    buffer_.clear();
    return is_written;
  }

 private:
  static constexpr std::size_t LargestBuffer = 1U << 18U;

  void put_word(auto value) { fmt::format_to(std::back_inserter(buffer_), "{} ", value); }
  void put_bytes(std::uint32_t bits, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) buffer_ += static_cast<char>(bits >> (8 * i) & 0xFFU);
  }

  bool is_text_;
  const grf::FileWriter& write_;
  std::string buffer_;
};

std::uint8_t to_byte(float component) { return static_cast<std::uint8_t>(std::lround(component * 255)); }

bool is_byte(float component) {
  return component >= 0 && component <= 1 && to_component(to_byte(component), PlyType::UInt8) == component;
}
bool are_bytes(const grf::Colour& colour) {
  return is_byte(colour.x) && is_byte(colour.y) && is_byte(colour.z);
}

/// The format of colours, if there are any.
struct Colours {
  bool exist = false;
  bool are_bytes = true;

  void add(const grf::Colour& colour) {
    exist = true;
    are_bytes = are_bytes && convert::are_bytes(colour);
  }
  std::string_view type() const { return are_bytes ? "uchar" : "float"; }
};

class PlyWriter {
 public:
  PlyWriter(const grf::Scene& scene, bool is_text) : world_(scene), is_text_(is_text) {
    for (const WorldMesh& mesh : world_.meshes()) {
      if (!mesh.is_light()) survey(mesh);
    }
    if (!has_uvs_) textures_.clear();
    all_have_texture_ = textures_.size() == 1 && textured_faces_ == faces_;
  }

  bool write(const std::string& path, grf::Diagnostics& diagnostics) const;
  void write_colours_as_floats() { vertex_colours_.are_bytes = false; }

 private:
  void survey(const WorldMesh& placed);
  std::string header() const;
  bool write_vertices(const WorldMesh& placed, PlyOutput& out) const;
  bool write_faces(const WorldMesh& placed, std::uint32_t first_vertex, PlyOutput& out) const;
  void put_colour(const grf::Colour& colour, const Colours& colours, PlyOutput& out) const;
  std::int32_t texture_number(const WorldSurface& surface) const;
  bool write_body(PlyOutput& out) const;
  void report(const std::string& path, grf::Diagnostics& diagnostics) const;

  WorldMeshes world_;
  bool is_text_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  std::size_t most_corners_ = 0;
  bool has_normals_ = false;
  bool has_uvs_ = false;
  Colours vertex_colours_;
  Colours face_colours_;
  std::map<std::string, std::int32_t> textures_;  // numbers in the order of names
  std::uint64_t textured_faces_ = 0;
  bool all_have_texture_ = false;
};

void PlyWriter::survey(const WorldMesh& placed) {
  const grf::Mesh& mesh = placed.mesh();
  vertices_ += mesh.geometry->positions.size();
  faces_ += mesh.face_count();
  has_normals_ = has_normals_ || !mesh.geometry->normals.empty();
  has_uvs_ = has_uvs_ || !mesh.geometry->uvs.empty();
  for (std::size_t i = 0; i < mesh.face_count(); ++i)
    most_corners_ = std::max(most_corners_, mesh.face(i).size());
  for (std::size_t i = 0; !mesh.geometry->colours.empty() && i < mesh.geometry->positions.size(); ++i) {
    if (mesh.geometry->colours.has(i)) vertex_colours_.add(mesh.geometry->colours[i]);
  }
  for (const WorldSurface& surface : placed.surfaces()) {
    if (surface.faces == 0) continue;
    if (surface.colour) face_colours_.add(*surface.colour);
    if (surface.texture == nullptr) continue;
    textured_faces_ += surface.faces;
    textures_.emplace(surface.texture->file, 0);
  }
  std::int32_t number = 0;
  for (auto& [file, texture] : textures_) texture = number++;
}

std::string PlyWriter::header() const {
  std::string text = fmt::format("ply\nformat {} 1.0\n", is_text_ ? "ascii" : "binary_little_endian");
  for (const auto& [file, number] : textures_) text += fmt::format("comment TextureFile {}\n", file);
  for (std::size_t i = 0; i < world_.materials().size(); ++i) {
    text += fmt::format("comment material {} {}\n", i, material_comment(world_.materials()[i]));
  }
  const auto add = [&text](std::string_view type, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) text += fmt::format("property {} {}\n", type, name);
  };
  text += fmt::format("element vertex {}\n", vertices_);
  add("float", {"x", "y", "z"});
  if (has_normals_) add("float", {"nx", "ny", "nz"});
  if (has_uvs_) add("float", {"s", "t"});
  if (vertex_colours_.exist) add(vertex_colours_.type(), {"red", "green", "blue"});
  text += fmt::format("element face {}\n", faces_);
  add(most_corners_ > std::numeric_limits<std::uint8_t>::max() ? "list int int" : "list uchar int",
      {"vertex_indices"});
  if (face_colours_.exist) add(face_colours_.type(), {"red", "green", "blue"});
  if (!world_.materials().empty()) add("int", {"material_index"});
  if (!textures_.empty() && !all_have_texture_) add("int", {"texnumber"});
  return text + "end_header\n";
}

bool PlyWriter::write_body(PlyOutput& out) const {
  for (const WorldMesh& mesh : world_.meshes()) {
    if (!mesh.is_light() && !write_vertices(mesh, out)) return false;
  }
  std::uint32_t first_vertex = 0;
  for (const WorldMesh& mesh : world_.meshes()) {
    if (mesh.is_light()) continue;
    if (!write_faces(mesh, first_vertex, out)) return false;
    first_vertex += static_cast<std::uint32_t>(mesh.mesh().geometry->positions.size());
  }
  return out.flush();
}

bool PlyWriter::write_vertices(const WorldMesh& placed, PlyOutput& out) const {
  const grf::Mesh& mesh = placed.mesh();
  const auto put = [&out](const auto& v) {
    for (unsigned i = 0; i < v.dimensions(); ++i) out.put(v[static_cast<int>(i)]);
  };
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    put(placed.position(i));
    if (has_normals_) put(mesh.geometry->normals.has(i) ? placed.normal(i) : grf::Vec3f(0));
    if (has_uvs_) put(mesh.geometry->uvs.has(i) ? mesh.geometry->uvs[i] : grf::Vec2f(0));
    if (vertex_colours_.exist) {
      put_colour(mesh.geometry->colours.has(i) ? mesh.geometry->colours[i] : grf::Colour(1), vertex_colours_,
                 out);
    }
    if (!out.end_element()) return false;
  }
  return true;
}

bool PlyWriter::write_faces(const WorldMesh& placed, std::uint32_t first_vertex, PlyOutput& out) const {
  for (std::size_t i = 0; i < placed.mesh().face_count(); ++i) {
    const auto corners = placed.face(i);
    if (most_corners_ > std::numeric_limits<std::uint8_t>::max()) {
      out.put(static_cast<std::int32_t>(corners.size()));
    } else {
      out.put(static_cast<std::uint8_t>(corners.size()));
    }
    for (const std::uint32_t corner : corners) out.put(static_cast<std::int32_t>(first_vertex + corner));
    const WorldSurface& surface = placed.surface(i);
    if (face_colours_.exist) put_colour(surface.colour.value_or(grf::Colour(1)), face_colours_, out);
    if (!world_.materials().empty()) {
      out.put(surface.material ? static_cast<std::int32_t>(*surface.material) : std::int32_t{-1});
    }
    if (!textures_.empty() && !all_have_texture_) out.put(texture_number(surface));
    if (!out.end_element()) return false;
  }
  return true;
}

void PlyWriter::put_colour(const grf::Colour& colour, const Colours& colours, PlyOutput& out) const {
  for (int i = 0; i < 3; ++i) {
    if (colours.are_bytes) {
      out.put(to_byte(colour[i]));
    } else {
      out.put(colour[i]);
    }
  }
}

std::int32_t PlyWriter::texture_number(const WorldSurface& surface) const {
  return surface.texture == nullptr ? -1 : textures_.at(surface.texture->file);
}

bool PlyWriter::write(const std::string& path, grf::Diagnostics& diagnostics) const {
  const auto fail = [&](std::string_view why) {
    diagnostics.error(grf::whole_file(path), fmt::format("cannot write the file: {}", why));
    return false;
  };
  if (faces_ == 0) return fail("the scene has no faces other than lights");
  if (!world_.is_finite()) return fail("a transform moves a vertex out of the range of a float");
  if (vertices_ > std::numeric_limits<std::int32_t>::max())
    return fail("there are too many vertices for PLY");
  const bool is_written = grf::replace_file(
      path,
      [this](const grf::FileWriter& write) {
        PlyOutput out(is_text_, write);
        out.put_text(header());
        return write_body(out);
      },
      diagnostics);
  if (is_written) report(path, diagnostics);
  return is_written;
}

void PlyWriter::report(const std::string& path, grf::Diagnostics& diagnostics) const {
  Losses losses;
  world_.count({Loss::Brdf, Loss::SamplingScheme, Loss::Emission, Loss::Opacity, Loss::Irradiance,
                Loss::AreaLight, Loss::MeshName},
               losses);
  losses.report_written(grf::whole_file(path), "PLY", diagnostics);
  if (has_uvs_ || textured_faces_ == 0) return;
  Losses textures;
  textures.add(Loss::Texture, textured_faces_);
  textures.report_written(grf::whole_file(path), "a PLY file without texture coordinates", diagnostics);
}

// The scene is flattened, since included files name textures relative to their own folders.
bool write_flat(const grf::Scene& scene, bool is_text, const std::string& path,
                grf::Diagnostics& diagnostics) {
  return PlyWriter(scene, is_text).write(path, diagnostics);
}

}  // namespace

bool write_ply_mesh(const grf::Mesh& mesh, const std::string& path, grf::Diagnostics& diagnostics) {
  grf::Scene scene;
  grf::Mesh bare = mesh;
  bare.name.clear();
  bare.surfaces.assign(mesh.surfaces.size(), grf::Surface());
  scene.contents.blocks.push_back({grf::Shared<grf::Mesh>(std::move(bare)), {}, {}});
  PlyWriter writer(scene, false);
  writer.write_colours_as_floats();
  return writer.write(path, diagnostics);
}

bool write_ply(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
  return write_flat(grf::flatten(scene, path), false, path, diagnostics);
}

bool write_ply_ascii(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
  return write_flat(grf::flatten(scene, path), true, path, diagnostics);
}

}  // namespace convert
