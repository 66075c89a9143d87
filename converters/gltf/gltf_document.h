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

/// A glTF file in the making: its JSON, and the one buffer that its accessors look into.
///
/// tinygltf's own writer is not used: it writes files in place, so that one that cannot be finished is lost,
/// and holds text, buffer and base64 of it at once.
class GltfDocument {
 public:
  enum class Use { Vertices, Indices, Data };

  GltfDocument();

  nlohmann::json& json() { return json_; }

  /// Appends to an array of the first level, and gives the place.
  int append(const char* array, nlohmann::json item);

  // Accessors; of positions with their bounds, as the specification asks.

  int add(std::span<const grf::Vec3f> values, Use use, bool with_bounds = false);
  int add(std::span<const grf::Vec2f> values, Use use);
  /// In 16 bits where they fit.
  int add(std::span<const std::uint32_t> values, Use use);
  int add_bytes(std::span<const std::uint8_t> values);

  /// A view of bytes that are no accessor's, such as those of an image.
  int add_view(std::string_view bytes);

  /// The JSON as text and the buffer: `uri` is the name of the buffer's file, empty inside a GLB file. The
  /// JSON has the check of `gltf_check.h`.
  std::string text(const std::string& uri);
  const std::string& buffer() const { return buffer_; }

 private:
  int add_view(const void* bytes, std::size_t size, Use use);
  int add_accessor(int view, int component_type, std::size_t count, const char* type);

  nlohmann::json json_;
  std::string buffer_;
};

/// A GLB file of both (glTF 2.0, section 4.4).
std::string glb_of(std::string_view json, std::string_view buffer);

}  // namespace convert
