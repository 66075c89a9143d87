#include "converters/gltf/gltf_compression.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <draco/compression/decode.h>
#include <fmt/format.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include "converters/gltf/gltf_accessors.h"

namespace convert {
namespace {

constexpr const char* Draco = "KHR_draco_mesh_compression";
constexpr const char* Meshopt = "EXT_meshopt_compression";

/// Returns a non-negative integer of an object, or nothing.
std::optional<std::size_t> whole_number(const tinygltf::Value& object, const char* name) {
  if (!object.IsObject() || !object.Has(name)) return std::nullopt;
  const tinygltf::Value& value = object.Get(name);
  if (!value.IsNumber() || value.GetNumberAsDouble() < 0) return std::nullopt;
  return static_cast<std::size_t>(std::min(value.GetNumberAsDouble(), 9e15));
}

std::string text_of(const tinygltf::Value& object, const char* name, const char* otherwise) {
  if (!object.Has(name) || !object.Get(name).IsString()) return otherwise;
  return object.Get(name).Get<std::string>();
}

/// A compressed view, as the extension describes it.
struct MeshoptView {
  std::span<const unsigned char> bytes;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode;
  std::string filter;

  /// The sizes that the decoders take.
  bool is_valid() const {
    if (mode == "ATTRIBUTES") {
      if (stride == 0 || stride > 256 || stride % 4 != 0) return false;
      if (filter == "OCTAHEDRAL") return stride == 4 || stride == 8;
      if (filter == "QUATERNION") return stride == 8;
      return filter == "NONE" || filter == "EXPONENTIAL";
    }
    const bool are_indices = mode == "INDICES" || (mode == "TRIANGLES" && count % 3 == 0);
    return are_indices && (stride == 2 || stride == 4) && filter == "NONE";
  }

  bool decode(unsigned char* to) const {
    if (mode == "TRIANGLES")
      return meshopt_decodeIndexBuffer(to, count, stride, bytes.data(), bytes.size()) == 0;
    if (mode == "INDICES")
      return meshopt_decodeIndexSequence(to, count, stride, bytes.data(), bytes.size()) == 0;
    if (meshopt_decodeVertexBuffer(to, count, stride, bytes.data(), bytes.size()) != 0) return false;
    if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(to, count, stride);
    if (filter == "QUATERNION") meshopt_decodeFilterQuat(to, count, stride);
    if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(to, count, stride);
    return true;
  }
};

/// Writes the values of all points of an attribute as numbers of one type, one after the other.
template <class Number>
bool write_values(const draco::PointAttribute& attribute, std::size_t points,
                  std::vector<unsigned char>& bytes) {
  const auto components = static_cast<std::size_t>(attribute.num_components());
  std::vector<Number> values(components);
  bytes.resize(points * components * sizeof(Number));
  for (std::size_t i = 0; i < points; ++i) {
    const auto point = draco::PointIndex(static_cast<std::uint32_t>(i));
    if (!attribute.ConvertValue<Number>(attribute.mapped_index(point), values.data())) return false;
    std::memcpy(bytes.data() + i * components * sizeof(Number), values.data(), components * sizeof(Number));
  }
  return true;
}

bool write_values(const draco::PointAttribute& attribute, int component_type, std::size_t points,
                  std::vector<unsigned char>& bytes) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return write_values<std::int8_t>(attribute, points, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return write_values<std::uint8_t>(attribute, points, bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return write_values<std::int16_t>(attribute, points, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return write_values<std::uint16_t>(attribute, points, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return write_values<std::uint32_t>(attribute, points, bytes);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return write_values<float>(attribute, points, bytes);
    default:
      return false;
  }
}

class Decompressor {
 public:
  Decompressor(GltfFile& file, grf::Diagnostics& diagnostics)
      : file_(file),
        accessors_(file, diagnostics),
        allowed_(std::max(LeastAllowed, BytesPerByte * file.bytes)) {}

  bool run() {
    for (std::size_t i = 0; i < file_.model.bufferViews.size(); ++i) {
      if (file_.model.bufferViews[i].extensions.contains(Meshopt) && !decode_view(i)) return false;
    }
    for (tinygltf::Mesh& mesh : file_.model.meshes) {
      for (tinygltf::Primitive& primitive : mesh.primitives) {
        const auto found = primitive.extensions.find(Draco);
        if (found != primitive.extensions.end() && !decode_primitive(primitive, found->second)) return false;
      }
    }
    return true;
  }

 private:
  static constexpr std::size_t LeastAllowed = std::size_t{1} << 28U;
  static constexpr std::size_t BytesPerByte = 64;

  bool fail(const std::string& message) {
    accessors_.fail(message);
    return false;
  }

  /// Adds to the bytes that the file expands to; false, after an error, once there are too many.
  bool spend(std::size_t count, std::size_t size) {
    if (size != 0 && count > (allowed_ - spent_) / size) {
      return fail(fmt::format("its compressed meshes expand to more than {} MB", allowed_ >> 20U));
    }
    spent_ += count * size;
    file_.bytes += count * size;
    return true;
  }

  /// Adds a buffer, and returns its index.
  int add_buffer(std::vector<unsigned char> bytes) {
    tinygltf::Buffer& buffer = file_.model.buffers.emplace_back();
    buffer.data = std::move(bytes);
    return static_cast<int>(file_.model.buffers.size()) - 1;
  }

  bool decode_view(std::size_t index) {
    const tinygltf::Value extension = file_.model.bufferViews[index].extensions.at(Meshopt);
    const auto number = [&](const char* name) { return whole_number(extension, name); };
    const auto buffer = number("buffer");
    const auto length = number("byteLength");
    const std::size_t offset = number("byteOffset").value_or(0);
    if (!buffer || !length || *buffer >= file_.model.buffers.size())
      return fail(fmt::format("buffer view {}: {} does not say where its data are", index, Meshopt));
    const std::span<const unsigned char> all = file_.model.buffers[*buffer].data;
    if (offset > all.size() || *length > all.size() - offset) {
      return fail(fmt::format("buffer view {}: {} compressed bytes from byte {} of a buffer that has {}",
                              index, *length, offset, all.size()));
    }
    const MeshoptView view = {all.subspan(offset, *length), number("count").value_or(0),
                              number("byteStride").value_or(0), text_of(extension, "mode", ""),
                              text_of(extension, "filter", "NONE")};
    if (!view.is_valid()) {
      return fail(
          fmt::format("buffer view {}: mode '{}' and filter '{}' for {} elements of {} bytes cannot be read",
                      index, view.mode, view.filter, view.count, view.stride));
    }
    if (!spend(view.count, view.stride)) return false;
    std::vector<unsigned char> bytes(view.count * view.stride);
    if (!view.decode(bytes.data()))
      return fail(fmt::format("buffer view {}: its compressed data are damaged", index));
    tinygltf::BufferView& plain = file_.model.bufferViews[index];
    plain.byteOffset = 0;
    plain.byteLength = bytes.size();
    plain.buffer = add_buffer(std::move(bytes));
    return true;
  }

  bool decode_primitive(tinygltf::Primitive& primitive, const tinygltf::Value& extension) {
    const auto index = whole_number(extension, "bufferView");
    if (!index || !extension.Has("attributes") || !extension.Get("attributes").IsObject())
      return fail(fmt::format("{} has no buffer view or no attributes", Draco));
    const auto compressed = accessors_.view(static_cast<int>(std::min<std::size_t>(*index, 1U << 30U)));
    if (!compressed) return false;
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(compressed->data()), compressed->size());
    draco::Decoder decoder;
    std::unique_ptr<draco::Mesh> mesh;
    try {
      auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
      if (decoded.ok()) mesh = std::move(decoded).value();
    } catch (const std::length_error&) {  // a size that no memory has
    }
    if (!mesh) return fail(fmt::format("buffer view {}: its compressed mesh is damaged", *index));
    if (!take_indices(primitive, *mesh)) return false;
    const tinygltf::Value& attributes = extension.Get("attributes");
    for (const std::string& name : attributes.Keys()) {
      const auto place = primitive.attributes.find(name);
      const auto id = whole_number(attributes, name.c_str());
      if (place == primitive.attributes.end() || !id) continue;
      const draco::PointAttribute* attribute =
          mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(std::min<std::size_t>(*id, 1U << 30U)));
      if (attribute == nullptr) return fail(fmt::format("the compressed mesh has no attribute {}", *id));
      if (!take_attribute(place->second, *attribute, mesh->num_points())) return false;
    }
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    return true;
  }

  bool take_indices(tinygltf::Primitive& primitive, const draco::Mesh& mesh) {
    const std::size_t corners = 3 * std::size_t{mesh.num_faces()};
    if (!spend(corners, sizeof(std::uint32_t))) return false;
    std::vector<unsigned char> bytes(corners * sizeof(std::uint32_t));
    for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
      const draco::Mesh::Face& face = mesh.face(draco::FaceIndex(i));
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = face[k].value();
        std::memcpy(bytes.data() + (3 * std::size_t{i} + k) * sizeof(corner), &corner, sizeof(corner));
      }
    }
    return replace(primitive.indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, corners, std::move(bytes));
  }

  bool take_attribute(int& accessor, const draco::PointAttribute& attribute, std::size_t points) {
    if (!accessors_.has_components(accessor, static_cast<std::size_t>(attribute.num_components())))
      return fail(fmt::format("accessor {}: its compressed values have another type", accessor));
    const int type = file_.model.accessors[static_cast<std::size_t>(accessor)].componentType;
    const auto components = static_cast<std::size_t>(attribute.num_components());
    if (!spend(points, components * sizeof(float))) return false;
    std::vector<unsigned char> bytes;
    if (!write_values(attribute, type, points, bytes))
      return fail(fmt::format("accessor {}: its compressed values do not fit its type", accessor));
    return replace(accessor, type, points, std::move(bytes));
  }

  /// Replaces an accessor by one of these elements, which other primitives do not share.
  bool replace(int& accessor, int component_type, std::size_t count, std::vector<unsigned char> bytes) {
    if (accessors_.count(accessor) != count) {
      return fail(fmt::format("accessor {}: it has {} elements, and its compressed mesh {}", accessor,
                              accessors_.count(accessor), count));
    }
    tinygltf::BufferView view;
    view.byteLength = bytes.size();
    view.buffer = add_buffer(std::move(bytes));
    file_.model.bufferViews.push_back(std::move(view));
    tinygltf::Accessor plain = file_.model.accessors[static_cast<std::size_t>(accessor)];
    plain.bufferView = static_cast<int>(file_.model.bufferViews.size()) - 1;
    plain.byteOffset = 0;
    plain.componentType = component_type;
    plain.sparse.isSparse = false;
    file_.model.accessors.push_back(std::move(plain));
    accessor = static_cast<int>(file_.model.accessors.size()) - 1;
    return true;
  }

  GltfFile& file_;
  GltfAccessors accessors_;
  std::size_t allowed_;  ///< bytes that the file may expand to
  std::size_t spent_ = 0;
};

/// Returns the items of an array of the document, or of a mesh; nothing if it is not there.
nlohmann::json* items_of(nlohmann::json& object, const char* name) {
  if (!object.is_object() || !object.contains(name) || !object[name].is_array()) return nullptr;
  return &object[name];
}

bool fill_fallback_buffers(nlohmann::json& document) {
  bool has_changed = false;
  nlohmann::json* buffers = items_of(document, "buffers");
  if (buffers == nullptr) return false;
  const nlohmann::json::json_pointer fallback(fmt::format("/extensions/{}/fallback", Meshopt));
  for (nlohmann::json& buffer : *buffers) {
    const bool is_fallback = buffer.is_object() && buffer.contains(fallback) && buffer[fallback] == true;
    if (!is_fallback || buffer.contains("uri")) continue;
    buffer["uri"] = "data:application/octet-stream;base64,AA==";
    buffer["byteLength"] = 1;
    has_changed = true;
  }
  return has_changed;
}

/// Gives the accessor of a primitive's indices the compressed view, until they are decompressed.
bool fill_index_view(nlohmann::json& primitive, nlohmann::json& accessors) {
  const nlohmann::json::json_pointer view(fmt::format("/extensions/{}/bufferView", Draco));
  const bool is_compressed = primitive.is_object() && primitive.contains(view) &&
                             primitive.contains("indices") && primitive["indices"].is_number_unsigned();
  if (!is_compressed || primitive["indices"].get<std::size_t>() >= accessors.size()) return false;
  nlohmann::json& accessor = accessors[primitive["indices"].get<std::size_t>()];
  if (!accessor.is_object() || accessor.contains("bufferView")) return false;
  accessor["bufferView"] = primitive[view];
  return true;
}

bool fill_index_views(nlohmann::json& document) {
  nlohmann::json* meshes = items_of(document, "meshes");
  nlohmann::json* accessors = items_of(document, "accessors");
  if (meshes == nullptr || accessors == nullptr) return false;
  bool has_changed = false;
  for (nlohmann::json& mesh : *meshes) {
    nlohmann::json* primitives = items_of(mesh, "primitives");
    if (primitives == nullptr) continue;
    for (nlohmann::json& primitive : *primitives) {
      has_changed = fill_index_view(primitive, *accessors) || has_changed;
    }
  }
  return has_changed;
}

}  // namespace

bool decompress(GltfFile& file, grf::Diagnostics& diagnostics) {
  return Decompressor(file, diagnostics).run();
}

std::string with_placeholders(std::string_view json) {
  if (json.find(Meshopt) == std::string_view::npos && json.find(Draco) == std::string_view::npos) return {};
  nlohmann::json document = nlohmann::json::parse(json, nullptr, false);
  if (!document.is_object()) return {};
  const bool has_buffers = fill_fallback_buffers(document);
  const bool has_views = fill_index_views(document);
  return has_buffers || has_views ? document.dump() : std::string();
}

}  // namespace convert
