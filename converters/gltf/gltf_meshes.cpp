#include "converters/gltf/gltf_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace convert {
namespace {

constexpr auto Unused = std::numeric_limits<std::uint32_t>::max();

/// Vertices that primitives share, with flags of those in use.
struct Block {
  GltfVertices vertices;
  std::vector<bool> used;
};

/// The corners of one primitive in the mesh, as indices into its block of vertices.
struct Run {
  std::size_t block = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

bool has_direction(const grf::Vec3f& normal) {
  const float squared = normal.length2();
  return squared > 0 && std::isfinite(squared);
}

class MeshReader {
 public:
  MeshReader(const tinygltf::Mesh& source, const GltfPose& pose, GltfAccessors& accessors,
             GltfMaterials& materials, Losses& losses)
      : source_(source), pose_(pose), accessors_(accessors), materials_(materials), losses_(losses) {}

  std::optional<grf::Mesh> run() {
    for (const tinygltf::Primitive& primitive : source_.primitives) {
      if (!read(primitive)) return std::nullopt;
    }
    place_vertices();
    return std::move(mesh_);
  }

 private:
  bool read(const tinygltf::Primitive& primitive) {
    if (!materials_.has(primitive.material)) {
      accessors_.fail(fmt::format("there is no material {}", primitive.material));
      return false;
    }
    const auto position = primitive.attributes.find("POSITION");
    // Section 3.7.2.1: a primitive without positions has no geometry.
    if (position == primitive.attributes.end()) return true;
    const std::size_t vertices = accessors_.count(position->second);
    std::optional<std::vector<std::uint32_t>> indices;
    if (primitive.indices >= 0) {
      indices = accessors_.integers(primitive.indices);
      if (!indices || !is_in_range(*indices, vertices, primitive.indices)) return false;
    }
    const std::size_t corners = indices ? indices->size() : vertices;
    if (!has_faces(primitive.mode, corners)) return primitive.mode >= 0 && primitive.mode <= 3;
    const auto block = block_of(primitive);
    if (!block || !accessors_.spend(3 * corners)) return false;
    return add_faces(primitive, *block, indices);
  }

  bool is_in_range(const std::vector<std::uint32_t>& indices, std::size_t vertices, int accessor) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] < vertices) continue;
      accessors_.fail(
          fmt::format("accessor {}: index {} is vertex {} of {}", accessor, i, indices[i], vertices));
      return false;
    }
    return true;
  }

  /// Counts lost points and lines.
  bool has_faces(int mode, std::size_t corners) {
    switch (mode) {
      case TINYGLTF_MODE_POINTS:
        losses_.add(Loss::Point, corners);
        return false;
      case TINYGLTF_MODE_LINE:
        losses_.add(Loss::Line, corners / 2);
        return false;
      case TINYGLTF_MODE_LINE_LOOP:
        losses_.add(Loss::Line, corners);
        return false;
      case TINYGLTF_MODE_LINE_STRIP:
        losses_.add(Loss::Line, corners == 0 ? 0 : corners - 1);
        return false;
      case TINYGLTF_MODE_TRIANGLES:
      case TINYGLTF_MODE_TRIANGLE_STRIP:
      case TINYGLTF_MODE_TRIANGLE_FAN:
        return true;
      default:
        accessors_.fail(fmt::format("a primitive has the mode {}, expected 0 to 6", mode));
        return false;
    }
  }

  std::optional<std::size_t> block_of(const tinygltf::Primitive& primitive) {
    const GltfVertexSource source{primitive.attributes, primitive.targets,
                                  materials_.lookup(primitive.material)};
    const auto [known, is_new] = known_blocks_.emplace(source, blocks_.size());
    if (!is_new) return known->second;
    auto vertices = read_vertices(source, pose_, accessors_, losses_);
    if (!vertices) return std::nullopt;
    const std::size_t count = vertices->positions.size();
    blocks_.push_back({std::move(*vertices), std::vector<bool>(count)});
    return known->second;
  }

  bool has_further_uvs(const tinygltf::Primitive& primitive) const {
    const std::string own = fmt::format("TEXCOORD_{}", materials_.lookup(primitive.material).set);
    return std::any_of(primitive.attributes.begin(), primitive.attributes.end(), [&](const auto& attribute) {
      return attribute.first.starts_with("TEXCOORD_") && attribute.first != own;
    });
  }

  bool add_faces(const tinygltf::Primitive& primitive, std::size_t block,
                 const std::optional<std::vector<std::uint32_t>>& indices) {
    const std::size_t corners = indices ? indices->size() : blocks_[block].used.size();
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners % 3 != 0 : corners < 3 && corners != 0) {
      losses_.add(Loss::DegenerateFace);
    }
    const std::size_t faces = corners < 3                                 ? 0
                              : primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners / 3
                                                                          : corners - 2;
    if (faces == 0) return true;
    if (mesh_.corners.size() + 3 * faces >= Unused) {
      accessors_.fail("a mesh has more than 4294967295 corners");
      return false;
    }
    const std::uint32_t surface = surface_index(materials_.surface(primitive.material, faces, losses_));
    if (has_further_uvs(primitive)) losses_.add(Loss::SecondTextureCoordinates, faces);
    const auto vertex = [&](std::size_t i) {
      return indices ? (*indices)[i] : static_cast<std::uint32_t>(i);
    };
    runs_.push_back({block, mesh_.corners.size(), mesh_.corners.size() + 3 * faces});
    reserve(faces);
    for (std::size_t i = 0; i < faces; ++i) {
      const std::array<std::size_t, 3> places = corners_of_face(primitive.mode, i);
      const std::array<std::uint32_t, 3> face = {vertex(places[0]), vertex(places[1]), vertex(places[2])};
      for (const std::uint32_t corner : face) blocks_[block].used[corner] = true;
      mesh_.add_face(face, surface);
    }
    return true;
  }

  /// Adds a triangle strip, in which every second triangle has the opposite winding (section 3.7.2.1).
  static std::array<std::size_t, 3> corners_of_face(int mode, std::size_t face) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return {3 * face, 3 * face + 1, 3 * face + 2};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {face + 1, face + 2, 0};
    return {face, face + 1 + face % 2, face + 2 - face % 2};
  }

  void reserve(std::size_t faces) {
    if (runs_.size() > 1) return;  // then arrays grow by doubling
    mesh_.corners.reserve(3 * faces);
    mesh_.face_offsets.reserve(faces + 1);
    mesh_.surface_of_face.reserve(faces);
  }

  std::uint32_t surface_index(const grf::Surface& surface) {
    if (!surfaces_) {
      mesh_.surfaces = {surface};
      surfaces_.emplace(mesh_.surfaces);
    }
    return surfaces_->index_of(surface);
  }

  void place_vertices() {
    std::vector<std::vector<std::uint32_t>> vertex_of;
    for (Block& block : blocks_) vertex_of.push_back(place(block));
    for (const Run& run : runs_) {
      const auto& places = vertex_of[run.block];
      if (places.empty()) continue;
      for (std::size_t i = run.begin; i < run.end; ++i) mesh_.corners[i] = places[mesh_.corners[i]];
    }
    mesh_.free_spare_memory();
  }

  /// Appends the used vertices of a block to the mesh, and returns their new indices; nothing if they are
  /// unchanged.
  std::vector<std::uint32_t> place(Block& block) {
    const GltfVertices& from = block.vertices;
    const std::size_t count = from.positions.size();
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    std::vector<std::uint32_t> places(count, Unused);
    std::uint32_t next = first;
    for (std::size_t i = 0; i < count; ++i) {
      if (block.used[i]) places[i] = next++;
    }
    const bool all_stay = first == 0 && next == count;
    if (all_stay) {
      mesh_.positions = std::move(block.vertices.positions);
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        if (block.used[i]) mesh_.positions.push_back(from.positions[i]);
      }
    }
    place_values(from, places, next);
    block.vertices = {};
    if (all_stay) return {};
    return places;
  }

  void place_values(const GltfVertices& from, const std::vector<std::uint32_t>& places, std::size_t end) {
    const auto put = [&](const auto& values, auto& target, const auto& condition) {
      if (values.empty()) return;
      target.reserve(end);
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] != Unused && condition(values[i])) target.set(places[i], values[i]);
      }
    };
    const auto always = [](const auto&) { return true; };
    put(from.normals, mesh_.normals, [this](const grf::Vec3f& normal) {
      if (has_direction(normal)) return true;
      losses_.add(Loss::BadNormal);
      return false;
    });
    put(from.colours, mesh_.colours, always);
    put(from.uvs, mesh_.uvs, always);
  }

  const tinygltf::Mesh& source_;
  const GltfPose& pose_;
  GltfAccessors& accessors_;
  GltfMaterials& materials_;
  Losses& losses_;
  grf::MeshDraft mesh_;
  std::optional<grf::SurfaceIndex> surfaces_;
  std::map<GltfVertexSource, std::size_t> known_blocks_;
  std::deque<Block> blocks_;
  std::vector<Run> runs_;
};

}  // namespace

std::optional<grf::Mesh> read_mesh(const tinygltf::Mesh& source, const GltfPose& pose,
                                   GltfAccessors& accessors, GltfMaterials& materials, Losses& losses) {
  return MeshReader(source, pose, accessors, materials, losses).run();
}

}  // namespace convert
