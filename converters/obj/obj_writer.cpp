#include "converters/obj/obj_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "converters/index_table.h"
#include "converters/losses.h"
#include "converters/obj/mtl_writer.h"
#include "converters/wording.h"
#include "converters/world_meshes.h"
#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/visit.h"

namespace convert {
namespace {

constexpr std::uint32_t InvalidIndex = 0xFFFFFFFF;

template <std::size_t N>
using Numbers = std::array<float, N>;

template <std::size_t N>
std::uint64_t hash_of(const Numbers<N>& numbers) {
  std::uint64_t hash = 0;
  for (const float number : numbers) hash = mixed_hash(hash, std::bit_cast<std::uint32_t>(number));
  return hash;
}

/// Deduplicates elements of one kind per mesh, in the order of writing. Numbers are compared bit for bit, so
/// that the sign of a zero is kept.
template <std::size_t N>
class ElementList {
 public:
  /// Starts a new mesh; elements of previous meshes keep their indices.
  void begin_mesh() {
    before_ += elements_.size();
    elements_.clear();
    table_ = {};
  }
  std::uint32_t index_of(const Numbers<N>& element) {
    const auto next = static_cast<std::uint32_t>(elements_.size());
    const std::uint32_t index = table_.find_or_add(hash_of(element), next, [&](std::uint32_t known) {
      return std::bit_cast<Bits>(elements_[known]) == std::bit_cast<Bits>(element);
    });
    if (index == next) elements_.push_back(element);
    return index;
  }
  /// Returns the index as written in a face.
  std::uint64_t number(std::uint32_t index) const { return before_ + index + 1; }
  const std::vector<Numbers<N>>& elements() const { return elements_; }

 private:
  using Bits = std::array<std::uint32_t, N>;

  std::vector<Numbers<N>> elements_;
  IndexTable table_;
  std::uint64_t before_ = 0;
};

/// Formats a statement with a name. A backslash at the end of a line would join the next one to it.
std::string on_a_line(std::string_view keyword, std::string_view name) {
  std::string line = name.empty() ? std::string(keyword) : fmt::format("{} {}", keyword, name);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return line.ends_with('\\') ? line + " " : line;
}

Numbers<3> numbers_of(const grf::Vec3f& v) { return {v.x, v.y, v.z}; }

/// A buffered writer of text to a file.
class Output {
 public:
  explicit Output(const grf::FileWriter& write) : write_(write) {}

  std::string& text() { return text_; }
  void line(std::string_view line) { text_.append(line) += '\n'; }
  template <std::size_t N>
  void line(std::string_view keyword, const Numbers<N>& numbers, std::size_t count = N) {
    text_ += keyword;
    for (std::size_t i = 0; i < count; ++i)
      fmt::format_to(std::back_inserter(text_), FMT_COMPILE(" {}"), numbers[i]);
    text_ += '\n';
    pass_on();
  }
  void number(char before, std::uint64_t number) {
    const fmt::format_int digits(number);
    text_ += before;
    text_.append(digits.data(), digits.size());
  }
  void pass_on() {
    constexpr std::size_t LargePart = 1U << 20U;
    if (text_.size() > LargePart) finish();
  }
  /// Flushes the buffer; returns false if any text could not be written.
  bool finish() {
    is_written_ = is_written_ && write_(text_);
    text_.clear();
    return is_written_;
  }

 private:
  const grf::FileWriter& write_;
  std::string text_;
  bool is_written_ = true;
};

class ObjWriter {
 public:
  ObjWriter(const WorldMeshes& meshes, const MtlWriter& materials, std::string library, Losses& losses)
      : meshes_(meshes), materials_(materials), library_(std::move(library)), losses_(losses) {
    const auto is_coloured = [](const WorldMesh& mesh) { return !mesh.mesh().geometry->colours.empty(); };
    has_colours_ = std::any_of(meshes.meshes().begin(), meshes.meshes().end(), is_coloured);
  }

  bool write(const grf::FileWriter& file) {
    Output output(file);
    output.line("# Exported by grfconvert");
    if (!materials_.empty()) output.line(on_a_line("mtllib", library_));
    for (const WorldMesh& mesh : meshes_.meshes()) write_mesh(mesh, output);
    return output.finish();
  }

 private:
  void write_mesh(const WorldMesh& mesh, Output& output);
  void write_name(const std::string& name, Output& output);
  void write_vertices(const WorldMesh& placed, Output& output);
  void write_face(const WorldMesh& placed, std::size_t index, Output& output);
  std::uint32_t uv_index(const grf::Mesh& mesh, std::uint32_t vertex, bool face_has_uvs);
  Numbers<6> position_and_colour(const WorldMesh& placed, std::size_t vertex) const;

  const WorldMeshes& meshes_;
  const MtlWriter& materials_;
  std::string library_;
  Losses& losses_;
  bool has_colours_ = false;
  bool is_first_mesh_ = true;
  const std::string* material_ = nullptr;  // current material
  ElementList<6> positions_;
  ElementList<2> uvs_;
  ElementList<3> normals_;
  std::vector<std::uint32_t> position_of_vertex_;
  std::vector<std::uint32_t> uv_of_vertex_;
  std::vector<std::uint32_t> normal_of_vertex_;
  std::uint32_t zero_uv_ = InvalidIndex;
};

void ObjWriter::write_mesh(const WorldMesh& mesh, Output& output) {
  write_name(mesh.name(), output);
  write_vertices(mesh, output);
  std::vector<const std::string*> materials;
  for (const WorldSurface& surface : mesh.surfaces()) {
    materials.push_back(materials_.name_of(surface, mesh.is_light()));
  }
  for (std::size_t i = 0; i < mesh.mesh().face_count(); ++i) {
    const std::string* material = materials[(*mesh.mesh().surface_of_face)[i]];
    if (material == nullptr && material_ != nullptr) material = materials_.name_of_none();
    if (material != material_) {
      output.line(on_a_line("usemtl", *material));
      material_ = material;
    }
    write_face(mesh, i, output);
  }
}

// Elements before any `o` are a mesh without a name.
void ObjWriter::write_name(const std::string& name, Output& output) {
  if (!is_first_mesh_ || !name.empty()) output.line(on_a_line("o", name));
  is_first_mesh_ = false;
}

void ObjWriter::write_vertices(const WorldMesh& placed, Output& output) {
  const grf::Mesh& mesh = placed.mesh();
  const std::size_t count = mesh.geometry->positions.size();
  positions_.begin_mesh();
  uvs_.begin_mesh();
  normals_.begin_mesh();
  position_of_vertex_.resize(count);
  uv_of_vertex_.assign(count, InvalidIndex);
  normal_of_vertex_.assign(count, InvalidIndex);
  for (std::size_t i = 0; i < count; ++i) {
    position_of_vertex_[i] = positions_.index_of(position_and_colour(placed, i));
    if (mesh.geometry->uvs.has(i))
      uv_of_vertex_[i] = uvs_.index_of({mesh.geometry->uvs[i].x, mesh.geometry->uvs[i].y});
    if (mesh.geometry->normals.has(i)) normal_of_vertex_[i] = normals_.index_of(numbers_of(placed.normal(i)));
  }
  const bool some_lack_uvs =
      !mesh.geometry->uvs.empty() && std::count(uv_of_vertex_.begin(), uv_of_vertex_.end(), InvalidIndex) > 0;
  if (some_lack_uvs) zero_uv_ = uvs_.index_of({0, 0});
  for (const Numbers<6>& v : positions_.elements()) output.line("v", v, has_colours_ ? 6 : 3);
  for (const Numbers<2>& vt : uvs_.elements()) output.line("vt", vt);
  for (const Numbers<3>& vn : normals_.elements()) output.line("vn", vn);
}

// If any vertex of the file has a colour, all get one: Assimp, for example, assigns the colours to the first
// vertices. A missing colour is 1 in GRF.
Numbers<6> ObjWriter::position_and_colour(const WorldMesh& placed, std::size_t vertex) const {
  const grf::Vec3f position = placed.position(vertex);
  if (!has_colours_) return {position.x, position.y, position.z, 0, 0, 0};
  const grf::Mesh& mesh = placed.mesh();
  const grf::Colour colour =
      mesh.geometry->colours.has(vertex) ? mesh.geometry->colours[vertex] : grf::Colour(1);
  return {position.x, position.y, position.z, colour.x, colour.y, colour.z};
}

// All corners of a face have a normal, or none has: in GRF too, a face is flat-shaded if a corner lacks one.
// A missing texture coordinate is (0, 0).
void ObjWriter::write_face(const WorldMesh& placed, std::size_t index, Output& output) {
  const std::span<const std::uint32_t> face = placed.face(index);
  const auto has_normal = [this](std::uint32_t vertex) { return normal_of_vertex_[vertex] != InvalidIndex; };
  const auto has_uv = [this](std::uint32_t vertex) { return uv_of_vertex_[vertex] != InvalidIndex; };
  const bool has_normals = std::all_of(face.begin(), face.end(), has_normal);
  const bool has_uvs = std::any_of(face.begin(), face.end(), has_uv);
  if (!has_normals && std::any_of(face.begin(), face.end(), has_normal)) losses_.add(Loss::FlatNormal);
  output.text() += 'f';
  for (const std::uint32_t vertex : face) {
    output.number(' ', positions_.number(position_of_vertex_[vertex]));
    if (has_uvs) output.number('/', uvs_.number(has_uv(vertex) ? uv_of_vertex_[vertex] : zero_uv_));
    if (has_normals && !has_uvs) output.text() += '/';
    if (has_normals) output.number('/', normals_.number(normal_of_vertex_[vertex]));
  }
  output.text() += '\n';
  output.pass_on();
}

}  // namespace

bool write_obj(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
  const grf::Scene flat = grf::flatten(scene, path);
  const WorldMeshes meshes(flat);
  const grf::SourceLocation location = grf::whole_file(path);
  if (!meshes.is_finite()) {
    diagnostics.error(location, "a transform moves a vertex out of the range of a float");
    return false;
  }
  const MtlWriter materials(flat, meshes);
  const std::string library = std::filesystem::path(path).replace_extension(".mtl").string();
  Losses losses;
  meshes.count({Loss::ParameterMap, Loss::SamplingScheme, Loss::Irradiance, Loss::Cutoff}, losses);
  losses.add(Loss::Observer, grf::observers_of(flat).size());
  ObjWriter obj(meshes, materials, std::filesystem::path(library).filename().string(), losses);
  std::vector<grf::NewFile> files;
  if (!materials.empty()) {
    files.push_back({library, [&](const grf::FileWriter& write) { return write(materials.text()); }});
  }
  files.push_back({path, [&](const grf::FileWriter& write) { return obj.write(write); }});
  if (!grf::replace_files(files, diagnostics)) return false;
  losses.report(location, diagnostics);
  if (materials.approximated_faces() > 0) {
    diagnostics.note(location,
                     fmt::format("{} a BRDF that MTL only approximates: comments have the exact one",
                                 counted(materials.approximated_faces(), "face has", "faces have")));
  }
  return true;
}

}  // namespace convert
