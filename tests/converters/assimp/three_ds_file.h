// 3DS files made by tests, chunk by chunk.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace convert {

inline std::string little_endian(std::uint32_t number, std::size_t bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>((number >> (8 * i)) & 0xFFU);
  return text;
}
inline std::string word(unsigned number) { return little_endian(number, 2); }
inline std::string floats(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) bytes += little_endian(std::bit_cast<std::uint32_t>(value), 4);
  return bytes;
}
inline std::string text(const std::string& value) { return value + '\0'; }

inline std::string chunk(unsigned id, const std::string& data) {
  return word(id) + little_endian(static_cast<std::uint32_t>(data.size() + 6), 4) + data;
}

struct ThreeDsParts {
  std::vector<float> positions;
  std::vector<std::vector<unsigned>> faces;
  std::vector<unsigned> groups;                                          ///< none: no such chunk
  std::vector<std::pair<std::string, std::vector<unsigned>>> materials;  ///< names and faces
  std::vector<float> uvs;
};

/// An object of triangles.
inline std::string object(const std::string& name, const ThreeDsParts& parts) {
  std::string faces = word(static_cast<unsigned>(parts.faces.size()));
  for (const auto& face : parts.faces) {
    for (const unsigned corner : face) faces += word(corner);
    faces += word(7);
  }
  for (const auto& [material, of_faces] : parts.materials) {
    std::string list = text(material) + word(static_cast<unsigned>(of_faces.size()));
    for (const unsigned face : of_faces) list += word(face);
    faces += chunk(0x4130, list);
  }
  if (!parts.groups.empty()) {
    std::string list;
    for (const unsigned group : parts.groups) list += little_endian(group, 4);
    faces += chunk(0x4150, list);
  }
  std::string mesh =
      chunk(0x4110, word(static_cast<unsigned>(parts.positions.size() / 3)) + floats(parts.positions));
  mesh += chunk(0x4120, faces);
  if (!parts.uvs.empty()) {
    mesh += chunk(0x4140, word(static_cast<unsigned>(parts.uvs.size() / 2)) + floats(parts.uvs));
  }
  return chunk(0x4000, text(name) + chunk(0x4100, mesh));
}

inline std::string colour_chunk(unsigned id, float r, float g, float b) {
  return chunk(id, chunk(0x0010, floats({r, g, b})));
}
inline std::string percentage_chunk(unsigned id, unsigned percentage) {
  return chunk(id, chunk(0x0030, word(percentage)));
}

/// Makes a material of a name and further chunks.
inline std::string material(const std::string& name, const std::string& chunks) {
  return chunk(0xAFFF, chunk(0xA000, text(name)) + chunks);
}

inline std::string three_ds_file(const std::string& editor_chunks) {
  return chunk(0x4D4D, chunk(0x0002, little_endian(3, 4)) + chunk(0x3D3D, editor_chunks));
}

}  // namespace convert
