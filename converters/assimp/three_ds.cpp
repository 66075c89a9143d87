#include "converters/assimp/three_ds.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "converters/wording.h"
#include "grf/keywords.h"

namespace convert {
namespace {

enum ChunkId : unsigned {
  MainChunk = 0x4D4D,
  EditorChunk = 0x3D3D,
  ObjectChunk = 0x4000,
  TrianglesChunk = 0x4100,
  VerticesChunk = 0x4110,
  FacesChunk = 0x4120,
  FaceMaterialChunk = 0x4130,
  TextureCoordinatesChunk = 0x4140,
  SmoothingGroupsChunk = 0x4150,
  MaterialChunk = 0xAFFF,
  MaterialNameChunk = 0xA000,
};

constexpr std::size_t ChunkHeaderSize = 6;

/// The rest of a chunk, from an offset in the file. Numbers are little-endian; callers must check `size`
/// before they read one.
class ChunkData {
 public:
  ChunkData(std::string_view file, std::size_t begin, std::size_t end)
      : file_(file), position_(begin), end_(end) {}

  std::size_t position() const { return position_; }
  std::size_t size() const { return end_ - position_; }

  std::uint32_t take_number(std::size_t bytes) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      number |= std::uint32_t{static_cast<std::uint8_t>(file_[position_ + i])} << (8 * i);
    }
    position_ += bytes;
    return number;
  }
  std::uint16_t take_index() { return static_cast<std::uint16_t>(take_number(2)); }
  float take_float() { return std::bit_cast<float>(take_number(4)); }

  /// Reads a string up to a zero byte or the end.
  std::string take_text() {
    const std::string_view rest = file_.substr(position_, size());
    const std::size_t length = std::min(rest.find('\0'), rest.size());
    position_ += std::min(length + 1, rest.size());
    return std::string(rest.substr(0, length));
  }

  /// Reads a chunk's number and its size, including the header, which must fit.
  std::pair<unsigned, std::size_t> take_header() {
    const unsigned id = take_number(2);
    return {id, take_number(4)};
  }

  /// Takes a number of bytes, which must fit.
  ChunkData take_data(std::size_t bytes) {
    position_ += bytes;
    return {file_, position_ - bytes, position_};
  }

 private:
  std::string_view file_;
  std::size_t position_;
  std::size_t end_;
};

class ThreeDsReader {
 public:
  ThreeDsReader(std::string_view bytes, grf::SourceLocation location, grf::Diagnostics& diagnostics)
      : bytes_(bytes), location_(std::move(location)), diagnostics_(diagnostics) {}

  std::optional<ThreeDsFile> run() {
    ChunkData file(bytes_, 0, bytes_.size());
    while (auto chunk = take_chunk(file)) {
      if (chunk->first == MainChunk) read_main(chunk->second);
    }
    for (const auto& [object, position] : places_) check(file_.objects[object], position);
    if (failed_) return {};
    return std::move(file_);
  }

 private:
  /// Returns the next child chunk with its number; empty after the last one, and after an error. An
  /// incomplete chunk is truncated, or read at a wrong offset.
  std::optional<std::pair<unsigned, ChunkData>> take_chunk(ChunkData& data) {
    if (data.size() == 0) return {};
    const std::size_t begin = data.position();
    if (data.size() >= ChunkHeaderSize) {
      const auto [id, length] = data.take_header();
      if (length >= ChunkHeaderSize && length - ChunkHeaderSize <= data.size()) {
        return std::pair(id, data.take_data(length - ChunkHeaderSize));
      }
    }
    error(begin, "the file is truncated or damaged: a chunk extends past its parent chunk");
    return {};
  }

  void read_main(ChunkData data) {
    while (auto chunk = take_chunk(data)) {
      if (chunk->first == EditorChunk) read_editor(chunk->second);
    }
  }

  void read_editor(ChunkData data) {
    while (auto chunk = take_chunk(data)) {
      if (chunk->first == MaterialChunk) read_material(chunk->second);
      if (chunk->first == ObjectChunk) read_object(chunk->second);
    }
  }

  void read_material(ChunkData data) {
    file_.materials.emplace_back();
    while (auto chunk = take_chunk(data)) {
      if (chunk->first == MaterialNameChunk) file_.materials.back() = chunk->second.take_text();
    }
  }

  void read_object(ChunkData data) {
    const std::string name = data.take_text();
    while (auto chunk = take_chunk(data)) {
      if (chunk->first != TrianglesChunk) continue;
      places_.emplace_back(file_.objects.size(), chunk->second.position() - ChunkHeaderSize);
      file_.objects.push_back({name, {}, {}, 0});
      read_triangles(chunk->second, file_.objects.back());
    }
  }

  void read_triangles(ChunkData data, ThreeDsObject& object) {
    while (auto chunk = take_chunk(data)) {
      if (chunk->first == VerticesChunk) read_positions(chunk->second, object);
      if (chunk->first == FacesChunk) read_faces(chunk->second, object);
      if (chunk->first == TextureCoordinatesChunk) {
        object.uv_count += count_of(chunk->second, 8, "texture coordinate", "texture coordinates");
      }
    }
  }

  void read_positions(ChunkData data, ThreeDsObject& object) {
    for (std::size_t n = count_of(data, 12, "vertex", "vertices"); n > 0; --n) {
      const float x = data.take_float();
      const float y = data.take_float();
      object.positions.emplace_back(x, y, data.take_float());
    }
  }

  void read_faces(ChunkData data, ThreeDsObject& object) {
    for (std::size_t n = count_of(data, 8, "face", "faces"); n > 0; --n) {
      ThreeDsFace face;
      for (std::uint16_t& corner : face.corners) corner = data.take_index();
      data.take_number(2);  // edge visibility
      object.faces.push_back(face);
    }
    if (failed_) return;
    while (auto chunk = take_chunk(data)) {
      if (chunk->first == FaceMaterialChunk) read_face_material(chunk->second, object);
      if (chunk->first == SmoothingGroupsChunk) read_groups(chunk->second, object);
    }
  }

  void read_face_material(ChunkData data, ThreeDsObject& object) {
    const std::string name = data.take_text();
    const auto found = std::find_if(file_.materials.begin(), file_.materials.end(), [&](const auto& other) {
      return !other.empty() && grf::same_keyword(name, other);
    });
    const std::size_t material = found == file_.materials.end()
                                     ? ThreeDsFace::NoMaterial
                                     : static_cast<std::size_t>(found - file_.materials.begin());
    for (std::size_t n = count_of(data, 2, "face of a material", "faces of a material"); n > 0; --n) {
      const std::size_t face = data.take_index();
      if (face < object.faces.size()) object.faces[face].material = material;
    }
  }

  static void read_groups(ChunkData data, ThreeDsObject& object) {
    for (ThreeDsFace& face : object.faces) {
      if (data.size() < 4) return;
      face.groups = data.take_number(4);
    }
  }

  /// Reads the count at the start of a list; returns 0 after an error.
  std::size_t count_of(ChunkData& data, std::size_t bytes_each, std::string_view one, std::string_view many) {
    const std::size_t begin = data.position() - ChunkHeaderSize;
    const std::size_t count = data.size() < 2 ? 0 : data.take_index();
    const std::size_t there = data.size() / bytes_each;
    if (count <= there) return count;
    error(begin, fmt::format("the list of {} ends after {}", counted(count, one, many), there));
    return 0;
  }

  void check(const ThreeDsObject& object, std::size_t position) {
    const std::size_t count = object.positions.size();
    for (const grf::Vec3f& p : object.positions) {
      if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
      return error(position, fmt::format("a vertex of the object '{}' is not finite", object.name));
    }
    for (const ThreeDsFace& face : object.faces) {
      const std::size_t largest = *std::max_element(face.corners.begin(), face.corners.end());
      if (largest < count) continue;
      return error(position,
                   fmt::format("a face of the object '{}' has vertex {} of {}", object.name, largest, count));
    }
    if (object.uv_count > 0 && object.uv_count < count) {
      error(position,
            fmt::format("the object '{}' has {} for {} vertices", object.name,
                        counted(object.uv_count, "texture coordinate", "texture coordinates"), count));
    }
  }

  void error(std::size_t position, const std::string& message) {
    failed_ = true;
    diagnostics_.error({location_.file, 0, static_cast<std::uint32_t>(position)}, message);
  }

  std::string_view bytes_;
  grf::SourceLocation location_;
  grf::Diagnostics& diagnostics_;
  ThreeDsFile file_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;  // offsets of objects in the file
  bool failed_ = false;
};

}  // namespace

std::optional<ThreeDsFile> read_three_ds(std::string_view bytes, const grf::SourceLocation& location,
                                         grf::Diagnostics& diagnostics) {
  return ThreeDsReader(bytes, location, diagnostics).run();
}

}  // namespace convert
