#include "converters/ply/ply_openmesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ios>
#include <limits>
#include <locale>
#include <mutex>
#include <vector>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <boost/interprocess/streams/bufferstream.hpp>

#include "converters/ply/ply_layout.h"

namespace convert {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using Slot = PlySlot;

bool is_in(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether properties are of the type, those that there are.
bool are(PlyType type, const PlyLayout& layout, std::initializer_list<Slot> slots) {
  return std::all_of(slots.begin(), slots.end(), [&](Slot slot) {
    const PlyProperty* property = layout.of(slot);
    return property == nullptr || property->type == type;
  });
}

/// Whether OpenMesh sees in the names of an element's properties what the layout says, and nothing else.
bool names_agree(const PlyElement& element, const PlyLayout& layout) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const std::string& name = element.properties[i].name;
    const bool is_known = is_in(name, {"x", "y", "z", "nx", "ny", "nz", "u", "v", "s", "t", "red", "green",
                                       "blue", "alpha", "diffuse_red", "diffuse_green", "diffuse_blue"});
    if (is_known != layout.meanings[i].slot.has_value()) return false;
  }
  return true;
}

bool reads_vertices(const PlyElement& element) {
  const PlyLayout layout = vertex_layout(element);
  const bool has_list =
      std::any_of(element.properties.begin(), element.properties.end(),
                  [](const PlyProperty& property) { return property.count_type.has_value(); });
  return !has_list && element.count <= std::numeric_limits<int>::max() && names_agree(element, layout) &&
         are(PlyType::Float32, layout,
             {Slot::X, Slot::Y, Slot::Z, Slot::NormalX, Slot::NormalY, Slot::NormalZ, Slot::U, Slot::V}) &&
         are(PlyType::UInt8, layout, {Slot::Red, Slot::Green, Slot::Blue, Slot::Alpha}) &&
         (layout.has_colour() || !layout.has(Slot::Alpha));
}

bool reads_faces(const PlyElement& element) {
  const PlyLayout layout = face_layout(element);
  const PlyProperty& corners = element.properties.front();
  const auto lists =
      std::count_if(element.properties.begin(), element.properties.end(),
                    [](const PlyProperty& property) { return property.count_type.has_value(); });
  return layout.corners == &corners && lists == 1 && corners.count_type == PlyType::UInt8 &&
         (corners.type == PlyType::Int32 || corners.type == PlyType::UInt32) &&
         element.count <= std::numeric_limits<int>::max() && names_agree(element, layout) &&
         are(PlyType::UInt8, layout, {Slot::Red, Slot::Green, Slot::Blue, Slot::Alpha}) &&
         (layout.has_colour() || !layout.has(Slot::Alpha));
}

/// Takes what OpenMesh reads into a mesh of ours, which keeps all faces, those too that no half-edge mesh
/// could have.
class Importer : public OpenMesh::IO::BaseImporter {
 public:
  Importer(PlyMesh& mesh, std::uint64_t vertices) : mesh_(mesh), vertex_count_(vertices) {}

  bool is_sound() const { return is_sound_; }
  std::size_t faces_met() const { return faces_met_; }

  /// Adds the last face, whose colour comes behind it.
  void finish_face() {
    if (!has_face_) return;
    has_face_ = false;
    is_sound_ = is_sound_ && mesh_.has_room_for(corners_.size());
    if (is_sound_) mesh_.add_face(corners_, face_);
    face_ = {};
  }

  VertexHandle add_vertex() override { return VertexHandle(static_cast<int>(mesh_.add_vertex())); }
  void set_point(VertexHandle vertex, const OpenMesh::Vec3f& p) override {
    is_sound_ = is_sound_ && std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    mesh_.set_position(number_of(vertex), {p[0], p[1], p[2]});
  }
  void set_normal(VertexHandle vertex, const OpenMesh::Vec3f& n) override {
    mesh_.set_normal(number_of(vertex), {n[0], n[1], n[2]});
  }
  void set_texcoord(VertexHandle vertex, const OpenMesh::Vec2f& uv) override {
    mesh_.set_uv(number_of(vertex), {uv[0], uv[1]});
  }
  void set_color(VertexHandle vertex, const OpenMesh::Vec4uc& colour) override {
    mesh_.set_colour(number_of(vertex), colour_of(colour));
  }

  FaceHandle add_face(const VHandles& vertices) override {
    finish_face();
    corners_.clear();
    for (const VertexHandle vertex : vertices) {
      is_sound_ = is_sound_ && vertex.is_valid() && static_cast<std::uint64_t>(vertex.idx()) < vertex_count_;
      corners_.push_back(number_of(vertex));
    }
    has_face_ = true;
    ++faces_met_;
    return FaceHandle(static_cast<int>(faces_met_ - 1));
  }
  void set_color(FaceHandle, const OpenMesh::Vec4uc& colour) override { face_.colour = colour_of(colour); }

  std::size_t n_vertices() const override { return mesh_.vertex_count(); }
  std::size_t n_faces() const override { return faces_met_; }
  std::size_t n_edges() const override { return 0; }

  // What OpenMesh's reader of PLY does not call.
  VertexHandle add_vertex(const OpenMesh::Vec3f&) override { return unexpected<VertexHandle>(); }
  VertexHandle add_vertex(const OpenMesh::Vec3d&) override { return unexpected<VertexHandle>(); }
  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return unexpected<HalfedgeHandle>(); }
  FaceHandle add_face(HalfedgeHandle) override { return unexpected<FaceHandle>(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec2f>&) override {
    unexpected();
  }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec3f>&) override {
    unexpected();
  }
  void set_face_texindex(FaceHandle, int) override { unexpected(); }
  void set_halfedge(VertexHandle, HalfedgeHandle) override { unexpected(); }
  void set_normal(VertexHandle, const OpenMesh::Vec3d&) override { unexpected(); }
  void set_color(VertexHandle, const OpenMesh::Vec3uc&) override { unexpected(); }
  void set_color(VertexHandle, const OpenMesh::Vec3f&) override { unexpected(); }
  void set_color(VertexHandle, const OpenMesh::Vec4f&) override { unexpected(); }
  void set_status(VertexHandle, const OpenMesh::Attributes::StatusInfo&) override { unexpected(); }
  void set_next(HalfedgeHandle, HalfedgeHandle) override { unexpected(); }
  void set_face(HalfedgeHandle, FaceHandle) override { unexpected(); }
  void request_face_texcoords2D() override { unexpected(); }
  void set_texcoord(HalfedgeHandle, const OpenMesh::Vec2f&) override { unexpected(); }
  void set_texcoord(VertexHandle, const OpenMesh::Vec3f&) override { unexpected(); }
  void set_texcoord(HalfedgeHandle, const OpenMesh::Vec3f&) override { unexpected(); }
  void set_status(HalfedgeHandle, const OpenMesh::Attributes::StatusInfo&) override { unexpected(); }
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3uc&) override { unexpected(); }
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4uc&) override { unexpected(); }
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3f&) override { unexpected(); }
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4f&) override { unexpected(); }
  void set_status(OpenMesh::EdgeHandle, const OpenMesh::Attributes::StatusInfo&) override { unexpected(); }
  void set_normal(FaceHandle, const OpenMesh::Vec3f&) override { unexpected(); }
  void set_normal(FaceHandle, const OpenMesh::Vec3d&) override { unexpected(); }
  void set_color(FaceHandle, const OpenMesh::Vec3uc&) override { unexpected(); }
  void set_color(FaceHandle, const OpenMesh::Vec3f&) override { unexpected(); }
  void set_color(FaceHandle, const OpenMesh::Vec4f&) override { unexpected(); }
  void set_status(FaceHandle, const OpenMesh::Attributes::StatusInfo&) override { unexpected(); }
  void add_texture_information(int, std::string) override { unexpected(); }

 private:
  static std::uint32_t number_of(VertexHandle vertex) { return static_cast<std::uint32_t>(vertex.idx()); }

  grf::Colour colour_of(const OpenMesh::Vec4uc& colour) {
    if (colour[3] != full_component(PlyType::UInt8)) mesh_.add(Loss::Alpha);
    const auto component = [&](std::size_t i) { return to_component(colour[i], PlyType::UInt8); };
    return {component(0), component(1), component(2)};
  }

  template <class Result = void>
  Result unexpected() {
    is_sound_ = false;
    return Result();
  }

  PlyMesh& mesh_;
  std::uint64_t vertex_count_;
  bool is_sound_ = true;
  bool has_face_ = false;
  std::vector<std::uint32_t> corners_;
  PlyFace face_;
  std::size_t faces_met_ = 0;
};

OpenMesh::IO::Options wanted(const PlyHeader& header) {
  using OpenMesh::IO::Options;
  const PlyLayout vertices = vertex_layout(header.elements[0]);
  Options options;
  if (vertices.has_normal()) options += Options::VertexNormal;
  if (vertices.has_colour()) options += Options::VertexColor;
  if (vertices.has_uv()) options += Options::VertexTexCoord;
  if (face_layout(header.elements[1]).has_colour()) options += Options::FaceColor;
  return options;
}

/// Keeps OpenMesh from writing its messages to the standard error.
class Silence {
 public:
  Silence() : was_enabled_(omerr().is_enabled()) { omerr().disable(); }
  ~Silence() {
    if (was_enabled_) omerr().enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  bool was_enabled_;
};

/// OpenMesh has one reader of PLY files, which keeps what it knows of a file in itself, and one stream of
/// messages: both are held for one reading. A number that cannot be read ends it at once, since OpenMesh
/// would go on with what the variable held before, which can be the length of a list.
bool read_by_manager(std::istream& stream, Importer& importer, OpenMesh::IO::Options options) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const Silence silence;
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  try {
    return OpenMesh::IO::IOManager().read(stream, "ply", importer, options);
  } catch (const std::ios::failure&) {
    return false;
  }
}

}  // namespace

bool openmesh_reads(const PlyHeader& header) {
  return header.is_plain && header.elements.size() == 2 && header.elements[0].name == "vertex" &&
         header.elements[1].name == "face" && reads_vertices(header.elements[0]) &&
         reads_faces(header.elements[1]);
}

bool read_ply_by_openmesh(const PlySource& source, const PlyHeader& header, PlyMesh& mesh, std::size_t& end) {
  boost::interprocess::ibufferstream buffer(source.bytes->data(), source.bytes->size());
  std::istream& stream = buffer;
  stream.imbue(std::locale::classic());
  const std::uint64_t vertices = header.elements[0].count;
  Importer importer(mesh, vertices);
  if (!read_by_manager(stream, importer, wanted(header))) return false;
  importer.finish_face();
  const bool is_whole = mesh.vertex_count() == vertices && importer.faces_met() == header.elements[1].count;
  end = stream.eof() ? source.bytes->size() : static_cast<std::size_t>(stream.tellg());
  return is_whole && importer.is_sound();
}

}  // namespace convert
