#include "converters/ply/ply_elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "converters/ply/ply_layout.h"
#include "converters/ply/ply_values.h"
#include "converters/wording.h"

namespace convert {
namespace {

using Slot = PlySlot;

/// Returns whether a number separates two strips: -1, also as an unsigned value.
bool ends_strip(double value) { return value == -1 || value == std::numeric_limits<std::uint32_t>::max(); }

class ElementReader {
 public:
  ElementReader(const PlySource& source, const PlyHeader& header, PlyMesh& mesh,
                grf::Diagnostics& diagnostics)
      : values_(source, header, diagnostics), header_(header), mesh_(mesh) {}

  bool run();
  std::size_t position() const { return values_.position(); }

 private:
  bool read(const PlyElement& element);
  bool skip(const PlyElement& element);
  bool read_vertices(const PlyElement& element);
  bool read_faces(const PlyElement& element);
  bool read_strips(const PlyElement& element);
  bool read_properties(const PlyElement& element, const PlyLayout& layout);
  bool read_list(const PlyProperty& property, std::vector<double>& list);
  bool read_number(const PlyProperty& property, Slot slot);

  bool add_vertex(const PlyLayout& layout);
  bool add_face(const PlyLayout& layout);
  bool add_strip();
  bool take_corners();
  bool take_uvs(PlyFace& face);
  grf::Colour colour_of(const PlyLayout& layout) const;
  void count_alpha(const PlyLayout& layout);

  float number(Slot slot) const { return static_cast<float>(at(slots_, slot)); }

  PlyValues values_;
  const PlyHeader& header_;
  PlyMesh& mesh_;
  double vertex_count_ = 0;
  bool reads_strips_ = false;
  // The values of the current vertex or face.
  PlySlotValues slots_ = {};
  std::vector<double> corner_list_;
  std::vector<double> uv_list_;
  std::vector<std::uint32_t> corners_;
  std::vector<grf::Vec2f> uvs_;
};

// Faces may precede their vertices: then they are skipped, and read in a second pass.
bool ElementReader::run() {
  const PlyElement* vertices = header_.find("vertex");
  vertex_count_ = static_cast<double>(vertices->count);
  bool has_vertices = false;
  std::vector<std::pair<const PlyElement*, std::size_t>> put_off;
  for (const PlyElement& element : header_.elements) {
    has_vertices = has_vertices || &element == vertices;
    if (!has_vertices) put_off.emplace_back(&element, values_.position());
    if (!(has_vertices ? read(element) : skip(element))) return false;
  }
  const std::size_t end = values_.position();
  for (const auto& [element, position] : put_off) {
    values_.go_to(position);
    if (!read(*element)) return false;
  }
  values_.go_to(end);
  return true;
}

bool ElementReader::read(const PlyElement& element) {
  if (element.name == "vertex") return read_vertices(element);
  if (element.name == "face") return read_faces(element);
  if (element.name == "tristrips") return read_strips(element);
  return skip(element);
}

bool ElementReader::skip(const PlyElement& element) {
  if (element.properties.empty()) return true;  // without properties any number of elements is empty
  for (std::uint64_t i = 0; i < element.count; ++i) {
    values_.begin(element, i);
    if (!values_.skip_element()) return false;
  }
  return true;
}

bool ElementReader::read_vertices(const PlyElement& element) {
  const PlyLayout layout = vertex_layout(element);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    values_.begin(element, i);
    if (!read_properties(element, layout) || !add_vertex(layout)) return false;
  }
  return true;
}

bool ElementReader::read_faces(const PlyElement& element) {
  const PlyLayout layout = face_layout(element);
  reads_strips_ = false;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    values_.begin(element, i);
    if (!read_properties(element, layout) || !add_face(layout)) return false;
  }
  return true;
}

bool ElementReader::read_strips(const PlyElement& element) {
  const PlyLayout layout = face_layout(element);
  reads_strips_ = true;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    values_.begin(element, i);
    if (!read_properties(element, layout) || !add_strip()) return false;
  }
  return true;
}

bool ElementReader::read_properties(const PlyElement& element, const PlyLayout& layout) {
  uv_list_.clear();
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    const PlyLayout::Meaning& meaning = layout.meanings[i];
    const bool is_read =
        meaning.slot   ? read_number(property, *meaning.slot)
        : meaning.list ? read_list(property, *meaning.list == PlyList::Corners ? corner_list_ : uv_list_)
                       : values_.skip(property);
    if (!is_read) return false;
  }
  return true;
}

bool ElementReader::read_list(const PlyProperty& property, std::vector<double>& list) {
  std::size_t count = 0;
  if (!values_.next_count(property, count)) return false;
  list.resize(count);
  const bool is_index = &list == &corner_list_;
  for (double& value : list) {
    if (!values_.next(property.type, value)) return false;
    const bool is_vertex = value >= 0 && value < vertex_count_;
    if (is_index && !is_vertex && !(reads_strips_ && ends_strip(value))) {
      return values_.fail(fmt::format("there is no vertex {}: the file has {}", value, vertex_count_));
    }
  }
  return true;
}

bool ElementReader::read_number(const PlyProperty& property, Slot slot) {
  double& value = slots_[static_cast<std::size_t>(slot)];
  if (!values_.next(property.type, value)) return false;
  // A position out of the range of a float is an error; other values are optional.
  const bool is_position = slot == Slot::X || slot == Slot::Y || slot == Slot::Z;
  if (!is_position || std::abs(value) <= std::numeric_limits<float>::max()) return true;
  return values_.fail(
      fmt::format("{} is {}, expected a finite number that a float can hold", property.name, value));
}

bool ElementReader::add_vertex(const PlyLayout& layout) {
  const std::uint32_t vertex = mesh_.add_vertex();
  const grf::Vec3d exact(at(slots_, Slot::X), at(slots_, Slot::Y), at(slots_, Slot::Z));
  const grf::Vec3f position(exact);
  if (grf::Vec3d(position) != exact) mesh_.add_rounded_position();
  mesh_.set_position(vertex, position);
  if (layout.has_normal()) {
    mesh_.set_normal(vertex, {number(Slot::NormalX), number(Slot::NormalY), number(Slot::NormalZ)});
  }
  if (layout.has_colour()) mesh_.set_colour(vertex, colour_of(layout));
  if (layout.has_uv()) mesh_.set_uv(vertex, {number(Slot::U), number(Slot::V)});
  count_alpha(layout);
  return true;
}

bool ElementReader::add_face(const PlyLayout& layout) {
  PlyFace face;
  if (!take_corners() || !take_uvs(face)) return false;
  if (layout.has_colour()) face.colour = colour_of(layout);
  if (layout.has(Slot::Material)) face.material = static_cast<std::int64_t>(at(slots_, Slot::Material));
  if (layout.has(Slot::Texture)) face.texture = static_cast<std::int64_t>(at(slots_, Slot::Texture));
  count_alpha(layout);
  mesh_.add_face(corners_, face);
  return true;
}

bool ElementReader::take_corners() {
  if (!mesh_.has_room_for(corner_list_.size())) return values_.fail("there are too many corners");
  corners_.clear();
  for (const double corner : corner_list_) corners_.push_back(static_cast<std::uint32_t>(corner));
  return true;
}

bool ElementReader::take_uvs(PlyFace& face) {
  if (uv_list_.empty()) return true;
  if (uv_list_.size() != 2 * corner_list_.size()) {
    return values_.fail(fmt::format("{} for {}, expected two numbers a corner",
                                    counted(uv_list_.size(), "texture coordinate", "texture coordinates"),
                                    counted(corner_list_.size(), "corner", "corners")));
  }
  uvs_.clear();
  for (std::size_t i = 0; i < uv_list_.size(); i += 2) {
    uvs_.emplace_back(static_cast<float>(uv_list_[i]), static_cast<float>(uv_list_[i + 1]));
  }
  face.uvs = uvs_;
  return true;
}

// Triangle strips: each vertex but the first two makes a triangle with the two before it, with alternating
// winding. Degenerate triangles connect parts of a strip.
bool ElementReader::add_strip() {
  std::array<std::uint32_t, 3> corners = {};
  std::size_t length = 0;
  for (const double corner : corner_list_) {
    if (ends_strip(corner)) {
      length = 0;
      continue;
    }
    corners = {corners[1], corners[2], static_cast<std::uint32_t>(corner)};
    if (++length < 3) continue;
    const auto [a, b, c] = corners;
    if (a == b || b == c || c == a) continue;
    if (!mesh_.has_room_for(3)) return values_.fail("there are too many corners");
    const bool turns = length % 2 == 0;
    mesh_.add_face(std::array{turns ? b : a, turns ? a : b, c}, {});
  }
  return true;
}

grf::Colour ElementReader::colour_of(const PlyLayout& layout) const {
  const auto component = [&](Slot slot) { return to_component(at(slots_, slot), layout.of(slot)->type); };
  return {component(Slot::Red), component(Slot::Green), component(Slot::Blue)};
}

void ElementReader::count_alpha(const PlyLayout& layout) {
  const PlyProperty* alpha = layout.of(Slot::Alpha);
  if (alpha != nullptr && at(slots_, Slot::Alpha) != full_component(alpha->type)) mesh_.add(Loss::Alpha);
}

}  // namespace

bool read_ply_elements(const PlySource& source, const PlyHeader& header, PlyMesh& mesh, std::size_t& end,
                       grf::Diagnostics& diagnostics) {
  ElementReader reader(source, header, mesh, diagnostics);
  const bool is_read = reader.run();
  end = reader.position();
  return is_read;
}

}  // namespace convert
