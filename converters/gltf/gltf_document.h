#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "grf/math.h"

namespace convert {

/// A glTF file under construction: its JSON, and the single buffer of its accessors. tinygltf's own writer is
/// not used: it writes in place, so that an error loses the old file, and holds text, buffer and base64 in
/// memory at once.
class GltfDocument {
 public:
  enum class Use { Vertices, Indices, Data };

  GltfDocument();

  nlohmann::json& json() { return json_; }

  /// Appends an item to a top-level array, and returns its index.
  int append(const char* array, nlohmann::json item);

  // These add accessors; those of positions have bounds, as the specification requires.

  int add(std::span<const grf::Vec3f> values, Use use, bool with_bounds = false);
  int add(std::span<const grf::Vec2f> values, Use use);
  /// Adds indices, in 16 bits if they fit.
  int add(std::span<const std::uint32_t> values, Use use);
  int add_bytes(std::span<const std::uint8_t> values);

  /// Adds a buffer view of bytes without an accessor, such as those of an image.
  int add_view(std::string_view bytes);

  /// Returns the JSON as text, with the checksum of `gltf_check.h`. `uri` is the name of the buffer's file,
  /// empty inside a GLB file.
  std::string text(const std::string& uri);
  const std::string& buffer() const { return buffer_; }

 private:
  int add_view(const void* bytes, std::size_t size, Use use);
  int add_accessor(int view, int component_type, std::size_t count, const char* type);

  nlohmann::json json_;
  std::string buffer_;
};

/// Packs both into a GLB file (glTF 2.0, section 4.4).
std::string glb_of(std::string_view json, std::string_view buffer);

}  // namespace convert
