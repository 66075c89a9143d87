#include "tests/converters/ply/reference_ply.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace convert {
namespace {

const std::map<std::string, std::string> Codes = {
    {"char", "b"},   {"int8", "b"},    {"uchar", "B"},  {"uint8", "B"},  {"short", "h"}, {"int16", "h"},
    {"ushort", "H"}, {"uint16", "H"},  {"int", "i"},    {"int32", "i"},  {"uint", "I"},  {"uint32", "I"},
    {"float", "f"},  {"float32", "f"}, {"double", "d"}, {"float64", "d"}};

struct Property {
  std::string name, count, type;  // an empty count: no list
};
struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

class Body {
 public:
  Body(std::istream& in, const std::string& format) : in_(in), format_(format) {}

  double value(const std::string& type) {
    if (format_ == "ascii") {
      std::string word;
      in_ >> word;
      return type == "f" ? std::strtof(word.c_str(), nullptr) : std::strtod(word.c_str(), nullptr);
    }
    switch (type[0]) {
      case 'b':
        return bytes<std::int8_t>();
      case 'B':
        return bytes<std::uint8_t>();
      case 'h':
        return bytes<std::int16_t>();
      case 'H':
        return bytes<std::uint16_t>();
      case 'i':
        return bytes<std::int32_t>();
      case 'I':
        return bytes<std::uint32_t>();
      case 'f':
        return bytes<float>();
      default:
        return bytes<double>();
    }
  }

 private:
  template <class T>
  T bytes() {
    char raw[sizeof(T)] = {};
    in_.read(raw, sizeof raw);
    if (format_ == "binary_big_endian") std::reverse(raw, raw + sizeof raw);
    T value;
    std::memcpy(&value, raw, sizeof value);
    return value;
  }

  std::istream& in_;
  std::string format_;
};

}  // namespace

double ReferencePly::area() const {
  double area = 0;
  for (const auto& face : faces) {
    grf::Vec3d doubled(0);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const grf::Vec3d origin(positions[face[0]]);
      doubled += (grf::Vec3d(positions[face[i]]) - origin)
                     .cross(grf::Vec3d(positions[face[(i + 1) % face.size()]]) - origin);
    }
    area += doubled.length() / 2;
  }
  return area;
}

std::size_t ReferencePly::distinct_positions() const {
  std::set<std::tuple<float, float, float>> distinct;
  for (const auto& p : positions) distinct.emplace(p.x, p.y, p.z);
  return distinct.size();
}

grf::Box3f ReferencePly::bounds() const {
  grf::Box3f box;
  for (const auto& p : positions) box.extendBy(p);
  return box;
}

ReferencePly read_reference_ply(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::vector<Element> elements;
  std::string format;
  for (std::string line, word; std::getline(in, line) && line.rfind("end_header", 0) != 0;) {
    std::istringstream words(line);
    words >> word;
    if (word == "format") words >> format;
    if (word == "element") words >> elements.emplace_back().name >> elements.back().count;
    if (word != "property") continue;
    Property property;
    words >> word;
    if (word == "list") words >> property.count >> word;
    property.type = Codes.at(word);
    if (!property.count.empty()) property.count = Codes.at(property.count);
    words >> property.name;
    elements.back().properties.push_back(property);
  }
  Body body(in, format);
  ReferencePly model;
  for (const Element& element : elements) {
    for (std::size_t i = 0; i < element.count; ++i) {
      grf::Vec3f position(0);
      for (const Property& property : element.properties) {
        std::vector<std::size_t> list;
        const bool is_list = !property.count.empty();
        const std::size_t count = is_list ? static_cast<std::size_t>(body.value(property.count)) : 1;
        for (std::size_t k = 0; k < count; ++k) {
          const double value = body.value(property.type);
          if (is_list) list.push_back(static_cast<std::size_t>(value));
          if (property.name == "x") position.x = static_cast<float>(value);
          if (property.name == "y") position.y = static_cast<float>(value);
          if (property.name == "z") position.z = static_cast<float>(value);
        }
        if (element.name == "face" && property.name.rfind("vertex_ind", 0) == 0) model.faces.push_back(list);
      }
      if (element.name == "vertex") model.positions.push_back(position);
    }
  }
  return model;
}

}  // namespace convert
