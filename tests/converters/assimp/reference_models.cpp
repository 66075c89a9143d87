#include "tests/converters/assimp/reference_models.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

grf::Vec3d parse_position(std::istringstream& words) {
  grf::Vec3d position(0);
  for (double* component : {&position.x, &position.y, &position.z}) {
    std::string word;
    words >> word;
    *component = std::strtof(word.c_str(), nullptr);  // scenes are made of floats
  }
  return position;
}

ReferenceModel read_text_stl(const std::string& bytes) {
  ReferenceModel model;
  std::istringstream words(bytes);
  ReferenceFace face;
  for (std::string word; words >> word;) {
    if (word == "vertex") face.corners.push_back(parse_position(words));
    if (word == "endfacet") model.faces.push_back(std::exchange(face, {}));
  }
  return model;
}

ReferenceModel read_binary_stl(const std::string& bytes, std::uint32_t count) {
  ReferenceModel model;
  for (std::size_t i = 0; i < count; ++i) {
    float numbers[12];
    std::memcpy(numbers, bytes.data() + 84 + 50 * i, sizeof numbers);
    ReferenceFace face;
    for (int k = 1; k < 4; ++k) {
      face.corners.emplace_back(numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]);
    }
    model.faces.push_back(face);
  }
  return model;
}

}  // namespace

ReferenceModel read_reference_stl(const std::string& path) {
  const std::string bytes = test::bytes_of(path);
  std::uint32_t count = 0;
  if (bytes.size() >= 84) std::memcpy(&count, bytes.data() + 80, 4);
  return bytes.size() == 84 + std::size_t{50} * count ? read_binary_stl(bytes, count) : read_text_stl(bytes);
}

ReferenceModel read_reference_off(const std::string& path) {
  std::istringstream words(test::bytes_of(path));
  std::string name;
  std::size_t vertex_count = 0;
  std::size_t face_count = 0;
  std::size_t edges = 0;
  words >> name >> vertex_count >> face_count >> edges;
  if (name != "OFF") throw std::runtime_error(path + " is not of the plain kind");
  std::vector<grf::Vec3d> positions;
  for (std::size_t i = 0; i < vertex_count; ++i) positions.push_back(parse_position(words));
  ReferenceModel model;
  for (std::size_t i = 0; i < face_count; ++i) {
    std::size_t corners = 0;
    words >> corners;
    ReferenceFace face;
    for (std::size_t k = 0; k < corners; ++k) {
      std::size_t index = 0;
      words >> index;
      face.corners.push_back(positions.at(index));
    }
    model.faces.push_back(face);
  }
  return model;
}

}  // namespace convert
