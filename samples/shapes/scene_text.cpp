#include "samples/shapes/scene_text.h"

#include <cmath>

#include <fmt/format.h>

namespace shape {

std::string text_of(const V3d& v, double parts) {
  const auto round = [parts](double x) { return std::round(x * parts) / parts + 0.0; };  // no negative zero
  return fmt::format("({:g}, {:g}, {:g})", round(v.x), round(v.y), round(v.z));
}

int MeshText::add_vertex(const V3d& position, const std::string& attributes) {
  if (!attributes.empty()) vertices_ += attributes + " ";
  vertices_ += text_of(position, parts_) + "\n";
  return count_++;
}

void MeshText::add_face(const std::vector<int>& corners) {
  faces_ += fmt::format("({})\n", fmt::join(corners, ", "));
}

void MeshText::add_quad(const V3d& corner, const V3d& edge1, const V3d& edge2) {
  const int first = add_vertex(corner);
  add_vertex(corner + edge1);
  add_vertex(corner + edge1 + edge2);
  add_vertex(corner + edge2);
  add_face({first, first + 1, first + 2, first + 3});
}

void MeshText::add_box(const V3d& low, const V3d& high) {
  const V3d size = high - low;
  const V3d x(size.x, 0, 0);
  const V3d y(0, size.y, 0);
  const V3d z(0, 0, size.z);
  add_quad(low, y, x);
  add_quad(low, z, y);
  add_quad(low, x, z);
  add_quad(high, -x, -y);
  add_quad(high, -y, -z);
  add_quad(high, -z, -x);
}

std::string MeshText::block(const std::string& attributes) const {
  return "begin mesh " + attributes + " begin vertexs\n" + vertices_ + "end vertexs begin faces\n" + faces_ +
         "end faces end mesh\n";
}

}  // namespace shape
