#include "converters/ply/ply_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "converters/scene_building.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"
#include "grf/keywords.h"
#include "grf/write.h"

namespace convert {
namespace {

bool is_finite(const auto& v) {
  for (unsigned i = 0; i < v.dimensions(); ++i) {
    if (!std::isfinite(v[static_cast<int>(i)])) return false;
  }
  return true;
}

/// Returns the text after the first word, if that is the given word.
std::optional<std::string_view> behind(std::string_view text, std::string_view word) {
  if (!text.starts_with(word) || text.substr(word.size(), 1) != " ") return std::nullopt;
  text.remove_prefix(word.size());
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text;
}

}  // namespace

PlyMesh::PlyMesh(const PlyHeader& header, const ReadOptions& options)
    : brdf_(options.brdf.value_or(default_brdf())), materials_(names_) {
  read_comments(header);
}

// The comments are `comment material 0 NAME`, of this project, and `comment TextureFile NAME`, of MeshLab.
void PlyMesh::read_comments(const PlyHeader& header) {
  for (const std::string& comment : header.comments) {
    if (const auto file = behind(comment, "TextureFile"); file && !file->empty()) {
      textures_.emplace_back(*file);
    }
    const auto material = behind(comment, "material");
    if (!material) continue;
    std::int64_t number = 0;
    const auto result = std::from_chars(material->data(), material->data() + material->size(), number);
    const auto name =
        behind(*material, material->substr(0, static_cast<std::size_t>(result.ptr - material->data())));
    if (result.ec == std::errc() && name && !name->empty()) {
      material_names_.emplace(number, material_name(std::string(*name)));
    }
  }
}

void PlyMesh::reserve(std::size_t vertices, std::size_t faces) {
  mesh_.positions.reserve(vertices);
  mesh_.corners.reserve(3 * faces);
  mesh_.face_offsets.reserve(faces + 1);
  mesh_.surface_of_face.reserve(faces);
}

void PlyMesh::set_normal(std::uint32_t vertex, const grf::Vec3f& normal) {
  if (!is_finite(normal)) return losses_.add(Loss::BadNormal);
  if (normal == grf::Vec3f(0)) return;
  if (mesh_.normals.empty()) mesh_.normals.reserve(mesh_.positions.capacity());
  mesh_.normals.set(vertex, normal);
}

void PlyMesh::set_colour(std::uint32_t vertex, const grf::Colour& colour) {
  if (mesh_.colours.empty()) mesh_.colours.reserve(mesh_.positions.capacity());
  mesh_.colours.set(vertex, checked(colour));
}

void PlyMesh::set_uv(std::uint32_t vertex, const grf::Vec2f& uv) {
  has_uvs_ = true;
  if (!is_finite(uv)) return losses_.add(Loss::BadTextureCoordinates);
  if (mesh_.uvs.empty()) mesh_.uvs.reserve(mesh_.positions.capacity());
  mesh_.uvs.set(vertex, uv);
}

grf::Colour PlyMesh::checked(const grf::Colour& colour) {
  grf::Colour inside = colour;
  for (int i = 0; i < 3; ++i) {
    if (!(colour[i] >= 0) || !std::isfinite(colour[i])) inside[i] = 0;
  }
  if (inside != colour) ++clamped_colours_;
  return inside;
}

bool PlyMesh::has_room_for(std::size_t corners) const {
  return corners <= std::numeric_limits<std::uint32_t>::max() - mesh_.corners.size();
}

void PlyMesh::add_face(std::span<const std::uint32_t> corners, const PlyFace& face) {
  if (corners.size() < 3) return losses_.add(Loss::DegenerateFace);
  const std::uint32_t surface = surface_of(face);
  if (face.uvs.empty()) return mesh_.add_face(corners, surface);
  has_uvs_ = true;
  corners_.clear();
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners_.push_back(corner_with_uv(corners[i], face.uvs[i]));
  mesh_.add_face(corners_, surface);
}

// The first uv of a vertex is stored in place; other uvs get a copy of the vertex, after those of the file.
std::uint32_t PlyMesh::corner_with_uv(std::uint32_t vertex, const grf::Vec2f& uv) {
  if (!is_finite(uv)) {
    losses_.add(Loss::BadTextureCoordinates);
    return vertex;
  }
  const std::array key = {vertex, std::bit_cast<std::uint32_t>(uv.x), std::bit_cast<std::uint32_t>(uv.y)};
  const bool is_first = !mesh_.uvs.has(vertex);
  if (is_first) mesh_.uvs.set(vertex, uv);
  const grf::Vec2f& own = mesh_.uvs[vertex];
  if (std::bit_cast<std::uint32_t>(own.x) == key[1] && std::bit_cast<std::uint32_t>(own.y) == key[2])
    return vertex;
  const auto [known, is_new] = copies_.emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
  if (is_new) {
    const grf::Vec3f position = mesh_.positions[vertex];
    mesh_.positions.push_back(position);
    if (mesh_.normals.has(vertex)) mesh_.normals.set(known->second, grf::Vec3f(mesh_.normals[vertex]));
    if (mesh_.colours.has(vertex)) mesh_.colours.set(known->second, grf::Colour(mesh_.colours[vertex]));
    mesh_.uvs.set(known->second, uv);
  }
  return known->second;
}

std::size_t PlyMesh::UvHash::operator()(const std::array<std::uint32_t, 3>& key) const {
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a over words
  for (const std::uint32_t word : key) hash = (hash ^ word) * 0x100000001b3ULL;
  return hash ^ (hash >> 32U);
}

std::uint32_t PlyMesh::surface_of(const PlyFace& face) {
  const std::int64_t texture = face.texture.value_or(textures_.empty() ? -1 : 0);
  SurfaceKey key{std::nullopt, std::max<std::int64_t>(face.material, -1),
                 std::max<std::int64_t>(texture, -1)};
  if (face.colour) {
    const grf::Colour colour = checked(*face.colour);
    std::get<0>(key) = std::array{colour.x, colour.y, colour.z};
  }
  if (last_key_ && *last_key_ == key) {
    ++faces_of_surface_[last_surface_];
    return last_surface_;
  }
  const auto [known, is_new] = surfaces_.emplace(key, static_cast<std::uint32_t>(surfaces_.size()));
  if (is_new) faces_of_surface_.push_back(0);
  last_key_ = key;
  last_surface_ = known->second;
  ++faces_of_surface_[last_surface_];
  return last_surface_;
}

std::size_t PlyMesh::material_of(std::int64_t number) {
  const auto [known, is_new] = material_of_number_.emplace(number, 0);
  if (!is_new) return known->second;
  const auto name = material_names_.find(number);
  known->second = materials_.add(unknown_material(
      name == material_names_.end() ? fmt::format("material {}", number) : name->second, brdf_));
  return known->second;
}

grf::Surface PlyMesh::make_surface(const SurfaceKey& key, std::size_t faces) {
  const auto& [colour, material, texture] = key;
  grf::Surface surface;
  if (material >= 0) surface = materials_.surface(material_of(material), faces, losses_);
  if (colour) surface.colour = grf::Colour((*colour)[0], (*colour)[1], (*colour)[2]);
  if (texture < 0) return surface;
  if (has_uvs_ && static_cast<std::size_t>(texture) < textures_.size()) {
    surface.texture = grf::Texture{textures_[static_cast<std::size_t>(texture)], {}};
  } else {
    faces_without_texture_ += faces;
  }
  return surface;
}

grf::Scene PlyMesh::take(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) {
  for (const auto& [number, name] : material_names_) material_of(number);
  mesh_.surfaces.resize(std::max<std::size_t>(surfaces_.size(), 1));
  for (const auto& [key, index] : surfaces_) {
    mesh_.surfaces[index] = make_surface(key, faces_of_surface_[index]);
    if (std::get<1>(key) >= 0) faces_with_material_ += faces_of_surface_[index];
  }
  report(location, diagnostics);
  mesh_.free_spare_memory();
  grf::Block block;
  block.content = grf::Shared<grf::Mesh>(std::move(mesh_));
  block.location = location;
  std::vector<grf::Block> blocks;
  blocks.push_back(std::move(block));
  return scene_of(materials_.definitions(), std::move(blocks), location);
}

void PlyMesh::report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const {
  losses_.report(location, diagnostics);
  if (clamped_colours_ > 0) {
    diagnostics.warning(location, counted(clamped_colours_, "colour has", "colours have") +
                                      " components below 0 or without a finite value: they are 0");
  }
  if (faces_without_texture_ > 0) {
    diagnostics.warning(
        location, counted(faces_without_texture_, "face lost its texture", "faces lost their texture") +
                      ": " + (has_uvs_ ? "no comment names it" : "the file has no texture coordinates"));
  }
  if (rounded_positions_ > 0) {
    diagnostics.note(location, counted(rounded_positions_, "position was", "positions were") +
                                   " rounded to the numbers of GRF, which are floats");
  }
  if (faces_with_material_ == 0) return;
  std::vector<std::string> names;
  for (const grf::Definition& material : materials_.definitions()) {
    names.push_back(grf::from_identifier(material.name));
  }
  diagnostics.note(location, fmt::format("{} of materials of which the file has only the names ({}): BRDF {}",
                                         counted(faces_with_material_, "face is", "faces are"), listed(names),
                                         grf::to_text(brdf_)));
}

std::string material_name(const std::string& comment) {
  const std::string text = grf::from_identifier(comment);
  return grf::to_identifier(text) == comment ? text : comment;
}

std::string material_comment(const std::string& name) {
  const bool is_one_line = !name.empty() && name.front() != ' ' && name.back() != ' ' &&
                           std::none_of(name.begin(), name.end(), [](char c) {
                             return (static_cast<unsigned char>(c) < ' ') || c == 0x7F;
                           });
  const bool reads_back = is_one_line && material_name(name) == name && to_utf8(name) == name;
  return reads_back ? name : grf::to_identifier(name);
}

}  // namespace convert
