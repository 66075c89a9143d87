#include "converters/gltf/gltf_document.h"

#include <algorithm>
#include <array>

#include "converters/gltf/gltf_check.h"
#include "converters/gltf/gltf_file.h"

namespace convert {
namespace {

constexpr int Float = 5126;
constexpr int Byte = 5121;
constexpr int Short = 5123;
constexpr int Integer = 5125;

void append_word(std::string& bytes, std::size_t word) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((word >> shift) & 0xFFU);
}

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

void append_chunk(std::string& glb, std::string_view type, std::string_view bytes, char filling) {
  append_word(glb, padded(bytes.size()));
  glb += type;
  glb += bytes;
  glb.append(padded(bytes.size()) - bytes.size(), filling);
}

}  // namespace

GltfDocument::GltfDocument() { json_["asset"] = {{"version", "2.0"}, {"generator", "Granada"}}; }

int GltfDocument::append(const char* array, nlohmann::json item) {
  nlohmann::json& items = json_[array];
  items.push_back(std::move(item));
  return static_cast<int>(items.size() - 1);
}

int GltfDocument::add_view(const void* bytes, std::size_t size, Use use) {
  buffer_.resize(padded(buffer_.size()));
  nlohmann::json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", size}};
  if (use == Use::Vertices) view["target"] = 34962;
  if (use == Use::Indices) view["target"] = 34963;
  buffer_.append(static_cast<const char*>(bytes), size);
  return append("bufferViews", std::move(view));
}

int GltfDocument::add_view(std::string_view bytes) { return add_view(bytes.data(), bytes.size(), Use::Data); }

int GltfDocument::add_accessor(int view, int component_type, std::size_t count, const char* type) {
  return append("accessors",
                {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}});
}

int GltfDocument::add(std::span<const grf::Vec3f> values, Use use, bool with_bounds) {
  const int view = add_view(values.data(), values.size_bytes(), use);
  const int accessor = add_accessor(view, Float, values.size(), "VEC3");
  if (!with_bounds) return accessor;
  grf::Vec3f lowest = values[0];
  grf::Vec3f highest = values[0];
  for (const grf::Vec3f& value : values) {
    for (int i = 0; i < 3; ++i) {
      lowest[i] = std::min(lowest[i], value[i]);
      highest[i] = std::max(highest[i], value[i]);
    }
  }
  nlohmann::json& item = json_["accessors"].back();
  item["min"] = {lowest.x, lowest.y, lowest.z};
  item["max"] = {highest.x, highest.y, highest.z};
  return accessor;
}

int GltfDocument::add(std::span<const grf::Vec2f> values, Use use) {
  const int view = add_view(values.data(), values.size_bytes(), use);
  return add_accessor(view, Float, values.size(), "VEC2");
}

int GltfDocument::add(std::span<const std::uint32_t> values, Use use) {
  // The maximum of a type is not allowed as an index (primitive restart).
  constexpr std::uint32_t HighestShort = 65534;
  const bool are_short =
      std::all_of(values.begin(), values.end(), [](std::uint32_t i) { return i <= HighestShort; });
  if (!are_short) {
    const int view = add_view(values.data(), values.size_bytes(), use);
    return add_accessor(view, Integer, values.size(), "SCALAR");
  }
  std::vector<std::uint16_t> shorts(values.size());
  std::transform(values.begin(), values.end(), shorts.begin(),
                 [](std::uint32_t i) { return static_cast<std::uint16_t>(i); });
  const int view = add_view(shorts.data(), 2 * shorts.size(), use);
  return add_accessor(view, Short, values.size(), "SCALAR");
}

int GltfDocument::add_bytes(std::span<const std::uint8_t> values) {
  const int view = add_view(values.data(), values.size(), Use::Data);
  return add_accessor(view, Byte, values.size(), "SCALAR");
}

std::string GltfDocument::text(const std::string& uri) {
  if (!buffer_.empty()) {
    nlohmann::json buffer = {{"byteLength", buffer_.size()}};
    if (!uri.empty()) buffer["uri"] = uri;
    json_["buffers"] = nlohmann::json::array({std::move(buffer)});
  }
  std::string text = json_.dump();
  const std::size_t check = text.find(CheckMember);
  if (check != std::string::npos) {
    text.replace(check + CheckMember.size(), NoCheck.size(), check_of(text, buffer_));
  }
  return text;
}

std::string glb_of(std::string_view json, std::string_view buffer) {
  constexpr std::size_t ChunkHeader = 8;
  const std::size_t binary = buffer.empty() ? 0 : ChunkHeader + padded(buffer.size());
  const std::size_t size = 12 + ChunkHeader + padded(json.size()) + binary;
  std::string glb(GlbMagic);
  glb.reserve(size);
  append_word(glb, 2);
  append_word(glb, size);
  append_chunk(glb, "JSON", json, ' ');
  if (binary != 0) append_chunk(glb, std::string_view("BIN\0", 4), buffer, '\0');
  return glb;
}

}  // namespace convert
