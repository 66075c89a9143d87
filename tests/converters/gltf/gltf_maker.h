// Small glTF files made by tests, without the code that is tested.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/converters/reading.h"

namespace convert {

class GltfMaker {
 public:
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  /// Adds an accessor of numbers that are stored as T.
  template <class T>
  int add(const std::vector<T>& values, const char* type, int component_type,
          const nlohmann::json& more = {}) {
    const std::size_t components = components_of(type);
    while (buffer.size() % 4 != 0) buffer += '\0';
    const std::size_t bytes = values.size() * sizeof(T);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes}});
    buffer.append(reinterpret_cast<const char*>(values.data()), bytes);
    nlohmann::json accessor = {{"bufferView", json["bufferViews"].size() - 1},
                               {"componentType", component_type},
                               {"count", values.size() / components},
                               {"type", type}};
    accessor.update(more.is_object() ? more : nlohmann::json::object());
    json["accessors"].push_back(accessor);
    return static_cast<int>(json["accessors"].size() - 1);
  }
  int floats(const std::vector<float>& values, const char* type) { return add(values, type, 5126); }
  int indices(const std::vector<std::uint16_t>& values) { return add(values, "SCALAR", 5123); }

  /// Adds a mesh of one primitive, and a node for it in the scene.
  void add_mesh(nlohmann::json primitive, nlohmann::json node = nlohmann::json::object()) {
    json["meshes"].push_back({{"primitives", nlohmann::json::array({std::move(primitive)})}});
    node["mesh"] = json["meshes"].size() - 1;
    add_root(std::move(node));
  }
  void add_root(nlohmann::json node) {
    json["nodes"].push_back(std::move(node));
    json["scene"] = 0;
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
  }

  std::string base64() const {
    constexpr std::string_view Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < buffer.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        bits = bits << 8U | (i + k < buffer.size() ? static_cast<unsigned char>(buffer[i + k]) : 0U);
      }
      for (std::size_t k = 0; k < 4; ++k) {
        text += i + k > buffer.size() ? '=' : Digits[bits >> (18 - 6 * k) & 63U];
      }
    }
    return text;
  }

  /// Returns the file with its buffer in a data URI.
  std::string gltf() const {
    nlohmann::json whole = json;
    if (!buffer.empty() && !whole.contains("buffers")) {
      whole["buffers"] = {
          {{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64()}}};
    }
    return whole.dump();
  }

  std::string glb() const {
    nlohmann::json whole = json;
    std::string binary = buffer;
    if (!binary.empty()) whole["buffers"] = {{{"byteLength", binary.size()}}};
    std::string text = whole.dump();
    while (text.size() % 4 != 0) text += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    std::string bytes = "glTF";
    const std::size_t size = 20 + text.size() + (binary.empty() ? 0 : 8 + binary.size());
    append(bytes, {2, size, text.size(), 0x4E4F534A});
    bytes += text;
    if (!binary.empty()) {
      append(bytes, {binary.size(), 0x004E4942});
      bytes += binary;
    }
    return bytes;
  }

  Reading read() const { return read_bytes("model.gltf", gltf()); }

  static Reading read_bytes(const std::string& name, const std::string& bytes) {
    const test::TemporaryFolder folder;
    return read_path(folder.add(name, bytes));
  }

  /// Makes a file of one triangle.
  static GltfMaker triangle(nlohmann::json node = nlohmann::json::object()) {
    GltfMaker maker;
    const int positions = maker.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    maker.add_mesh({{"attributes", {{"POSITION", positions}}}}, std::move(node));
    return maker;
  }
  /// Makes a file of one triangle with a material, and two textures of an image, of which the second one is
  /// clamped.
  static GltfMaker with_material(const nlohmann::json& material) {
    GltfMaker maker = triangle();
    maker.primitive()["material"] = 0;
    maker.json["materials"] = nlohmann::json::array({material});
    maker.json["textures"] = {{{"source", 0}}, {{"source", 0}, {"sampler", 0}}};
    maker.json["samplers"] = {{{"wrapS", 33071}}};
    maker.json["images"] = {{{"uri", "wood%20a.png"}}};
    return maker;
  }
  nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }
  nlohmann::json& attributes() { return primitive()["attributes"]; }

 private:
  static std::size_t components_of(std::string_view type) {
    if (type == "SCALAR") return 1;
    if (type == "MAT4") return 16;
    return static_cast<std::size_t>(type[3] - '0');
  }
  static void append(std::string& bytes, const std::vector<std::size_t>& words) {
    for (const std::size_t word : words) {
      for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFFU);
    }
  }
};

/// Expects that a file was not read, with an error that has this text.
inline void expect_error(const Reading& reading, const std::string& text) {
  EXPECT_FALSE(reading.scene.has_value()) << text;
  EXPECT_TRUE(reading.diagnostics.has_errors());
  EXPECT_THAT(reading.text(), testing::HasSubstr(text));
}

}  // namespace convert
