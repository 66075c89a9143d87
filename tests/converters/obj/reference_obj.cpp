#include "tests/converters/obj/reference_obj.h"

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>

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

ReferenceFace parse_face(std::istringstream& words, const std::vector<grf::Vec3d>& positions) {
  ReferenceFace face;
  for (std::string word; words >> word;) {
    const long index = std::strtol(word.c_str(), nullptr, 10);
    face.corners.push_back(positions.at(index > 0 ? index - 1 : positions.size() + index));
  }
  return face;
}

std::string rest_of(std::istringstream& words) {
  std::string rest;
  std::getline(words >> std::ws, rest);
  rest.erase(rest.find_last_not_of(" \t\r") + 1);
  return rest;
}

// The area vector of a polygon as the sum of the cross products of its edges' ends, about the origin.
double area_of(const ReferenceFace& face) {
  grf::Vec3d doubled(0);
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    doubled += face.corners[i].cross(face.corners[(i + 1) % face.corners.size()]);
  }
  return doubled.length() / 2;
}

}  // namespace

double ReferenceModel::area() const {
  double area = 0;
  for (const ReferenceFace& face : faces) area += area_of(face);
  return area;
}

std::size_t ReferenceModel::distinct_positions() const {
  std::set<std::tuple<double, double, double>> positions;
  for (const ReferenceFace& face : faces) {
    for (const grf::Vec3d& p : face.corners) positions.emplace(p.x, p.y, p.z);
  }
  return positions.size();
}

ReferenceModel read_reference(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  ReferenceModel model;
  std::vector<grf::Vec3d> positions;
  std::string material;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v") positions.push_back(parse_position(words));
    if (keyword == "usemtl") material = rest_of(words);
    if (keyword != "f") continue;
    ReferenceFace face = parse_face(words, positions);
    face.material = material;
    if (face.corners.size() >= 3) model.faces.push_back(face);
  }
  return model;
}

}  // namespace convert
