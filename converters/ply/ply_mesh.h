// PlyMesh collects the mesh of a PLY file while it is read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "converters/format.h"
#include "converters/losses.h"
#include "converters/materials.h"
#include "converters/ply/ply_header.h"
#include "grf/mesh.h"

namespace convert {

/// The attributes of a face.
struct PlyFace {
  std::optional<grf::Colour> colour;
  std::int64_t material = -1;           ///< below 0: none
  std::optional<std::int64_t> texture;  ///< below 0: none; absent: the first one in the comments, if any
  std::span<const grf::Vec2f> uvs;      ///< one per corner, or empty
};

/// A mesh builder that keeps the vertices of the file in order and shared, including unused ones.
class PlyMesh {
 public:
  /// Takes the names of materials and textures from the comments. The header must outlive this.
  PlyMesh(const PlyHeader& header, const ReadOptions& options);
  PlyMesh(const PlyMesh&) = delete;  // surfaces_ refers to the materials
  PlyMesh& operator=(const PlyMesh&) = delete;

  void reserve(std::size_t vertices, std::size_t faces);

  std::uint32_t add_vertex() {
    mesh_.positions.emplace_back(0);
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }
  void set_position(std::uint32_t vertex, const grf::Vec3f& position) { mesh_.positions[vertex] = position; }
  /// Sets a normal, unless it is zero, as the writer marks vertices without one.
  void set_normal(std::uint32_t vertex, const grf::Vec3f& normal);
  void set_colour(std::uint32_t vertex, const grf::Colour& colour);
  void set_uv(std::uint32_t vertex, const grf::Vec2f& uv);

  /// Adds a face of existing vertices. A face of fewer than three corners is counted and skipped.
  void add_face(std::span<const std::uint32_t> corners, const PlyFace& face);

  std::size_t vertex_count() const { return mesh_.positions.size(); }
  std::size_t face_count() const { return mesh_.face_count(); }
  bool has_room_for(std::size_t corners) const;

  void add(Loss loss, std::size_t count = 1) { losses_.add(loss, count); }
  void add_rounded_position() { ++rounded_positions_; }

  /// Reports losses and moves out the scene. The object must not be used afterwards.
  grf::Scene take(const grf::SourceLocation& location, grf::Diagnostics& diagnostics);

 private:
  using SurfaceKey = std::tuple<std::optional<std::array<float, 3>>, std::int64_t, std::int64_t>;
  struct UvHash {
    std::size_t operator()(const std::array<std::uint32_t, 3>& key) const;
  };

  void read_comments(const PlyHeader& header);
  std::uint32_t surface_of(const PlyFace& face);
  grf::Surface make_surface(const SurfaceKey& key, std::size_t faces);
  std::size_t material_of(std::int64_t number);
  std::uint32_t corner_with_uv(std::uint32_t vertex, const grf::Vec2f& uv);
  grf::Colour checked(const grf::Colour& colour);
  void report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const;

  grf::MeshDraft mesh_;
  grf::BrdfModel brdf_;
  DefinitionNames names_;
  Materials materials_;
  Losses losses_;
  std::map<std::int64_t, std::string> material_names_;      // from comments
  std::map<std::int64_t, std::size_t> material_of_number_;  // index into `materials_`
  std::vector<std::string> textures_;
  std::map<SurfaceKey, std::uint32_t> surfaces_;
  std::optional<SurfaceKey> last_key_;
  std::uint32_t last_surface_ = 0;
  // Vertices duplicated for faces with different uvs, by vertex and the bits of uv.
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, UvHash> copies_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> faces_of_surface_;
  std::size_t rounded_positions_ = 0;
  std::size_t faces_without_texture_ = 0;
  std::size_t faces_with_material_ = 0;
  std::size_t clamped_colours_ = 0;
  bool has_uvs_ = false;
};

/// Returns the name of a material for a comment `comment material 0 NAME`: unchanged if it reads back, or
/// else as an identifier, which `material_name` decodes.
std::string material_comment(const std::string& name);
std::string material_name(const std::string& comment);

}  // namespace convert
