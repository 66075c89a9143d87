#include "renderer/transport/scene/mesh_builder.h"

#include <limits>
#include <utility>
#include <variant>

namespace transport {
namespace {

using grf::Matrix44d;

Colour sum_of(const grf::Irradiance& irradiance) {
  if (const auto* value = std::get_if<Colour>(&irradiance)) return *value;
  Colour sum(0);
  for (const grf::DirectionalIrradiance& part :
       std::get<std::vector<grf::DirectionalIrradiance>>(irradiance)) {
    sum += part.irradiance;
  }
  return sum;
}

}  // namespace

bool mirrors(const Matrix44d& map) { return map.determinant() < 0; }

void MeshSize::add(const grf::Mesh& mesh, const UsedVertices& used, bool needs_uvs,
                   const EffectSet& effects) {
  vertices += used.count();
  triangles += mesh.geometry->triangle_count();
  has_normals |= effects.has(Effect::InterpolatedNormals) && !mesh.geometry->normals.empty();
  has_colours |= effects.has(Effect::VertexColours) && !mesh.geometry->colours.empty();
  has_uvs |= needs_uvs && !mesh.geometry->uvs.empty();
  has_irradiance |= effects.has(Effect::Irradiance) && !mesh.irradiance->empty();
}

MeshBuilder::MeshBuilder(const MeshSize& size) : size_(size) {
  mesh_.triangles.reserve(size.triangles);
  mesh_.positions.reserve(size.vertices + 1);
  if (size.has_normals) mesh_.normals.reserve(size.vertices);
  if (size.has_colours) mesh_.colours.reserve(size.vertices);
  if (size.has_uvs) mesh_.uvs.reserve(size.vertices);
  if (size.has_irradiance) mesh_.irradiance.reserve(size.vertices);
}

// A reflection turns triangles inside out: the other winding order keeps their front.
void MeshBuilder::add(const grf::Mesh& mesh, const UsedVertices& used, const Matrix44d& map,
                      std::span<const CompiledSurface> surfaces, std::uint32_t first_surface) {
  const auto first_vertex = static_cast<std::uint32_t>(mesh_.positions.size());
  add_vertices(mesh, used, map);
  const bool turns = mirrors(map);
  const grf::Triangulation& triangles = mesh.geometry.triangulation();
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const std::uint32_t surface = (*mesh.surface_of_face)[face];
    const bool emits = !reflectance::is_black(surfaces[surface].emission);
    mesh_.has_cutouts |= surfaces[surface].is_cutout();
    for (std::size_t i = triangles.first_of(face); i < triangles.first_of(face + 1); ++i) {
      std::array<std::uint32_t, 3> corners = triangles[i];
      if (turns) std::swap(corners[1], corners[2]);
      for (std::uint32_t& corner : corners) corner = first_vertex + used.index_of(corner);
      Triangle triangle;
      triangle.corners = corners;
      triangle.surface = (first_surface + surface) & 0x7fffffffU;
      triangle.is_flat = is_flat(corners) ? 1U : 0U;
      add_triangle(triangle, emits);
    }
  }
}

void MeshBuilder::add_vertices(const grf::Mesh& mesh, const UsedVertices& used, const Matrix44d& map) {
  const grf::Geometry& geometry = *mesh.geometry;
  const grf::VertexIrradiance& irradiance = *mesh.irradiance;
  for (std::size_t number = 0; number < used.count(); ++number) {
    const std::uint32_t i = used[number];
    mesh_.positions.emplace_back(grf::Vec3d(geometry.positions[i]) * map);
    if (size_.has_colours) mesh_.colours.push_back(geometry.colours.has(i) ? geometry.colours[i] : Colour(1));
    if (size_.has_uvs) mesh_.uvs.push_back(geometry.uvs.has(i) ? geometry.uvs[i] : Vec2f(0));
    if (size_.has_irradiance) {
      mesh_.irradiance.push_back(irradiance.has(i) ? sum_of(irradiance[i])
                                                   : Colour(std::numeric_limits<float>::quiet_NaN()));
    }
  }
  if (size_.has_normals) add_normals(mesh, used, map);
}

// Normals transform by the inverse transpose.
void MeshBuilder::add_normals(const grf::Mesh& mesh, const UsedVertices& used, const Matrix44d& map) {
  const Matrix44d normal_map = map.inverse().transposed();
  const auto& normals = mesh.geometry->normals;
  for (std::size_t number = 0; number < used.count(); ++number) {
    const std::uint32_t i = used[number];
    grf::Vec3d normal(0);
    if (normals.has(i)) normal_map.multDirMatrix(grf::Vec3d(normals[i]), normal);
    mesh_.normals.emplace_back(normal.normalized());
  }
}

bool MeshBuilder::is_flat(const std::array<std::uint32_t, 3>& corners) const {
  if (mesh_.normals.empty()) return true;
  const auto lacks_normal = [&](std::uint32_t corner) { return mesh_.normals[corner] == Vec3f(0); };
  return lacks_normal(corners[0]) || lacks_normal(corners[1]) || lacks_normal(corners[2]);
}

void MeshBuilder::add_triangle(const Triangle& triangle, bool emits) {
  const auto index = static_cast<std::uint32_t>(mesh_.triangles.size());
  mesh_.triangles.push_back(triangle);
  if (!emits) return;
  if (mesh_.emitting_runs.empty() || last_emitting_triangle_ + 1 != index) {
    mesh_.emitting_runs.push_back({index, emitting_triangles_});
  }
  last_emitting_triangle_ = index;
  ++emitting_triangles_;
}

void MeshBuilder::add(const Emitter& light, std::uint32_t surface) {
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  const Vec3f& corner = light.corner;
  for (const Vec3f& position :
       {corner, corner + light.edge1, corner + light.edge1 + light.edge2, corner + light.edge2}) {
    mesh_.positions.push_back(position);
    if (size_.has_normals) mesh_.normals.emplace_back(0.0F);
    if (size_.has_colours) mesh_.colours.emplace_back(1.0F);
    if (size_.has_uvs) mesh_.uvs.emplace_back(0.0F);
    if (size_.has_irradiance) mesh_.irradiance.emplace_back(std::numeric_limits<float>::quiet_NaN());
  }
  const bool emits = !reflectance::is_black(light.radiance);
  for (const std::array<std::uint32_t, 3>& corners :
       {std::array{first, first + 1, first + 2}, std::array{first, first + 2, first + 3}}) {
    Triangle triangle;
    triangle.corners = corners;
    triangle.surface = surface & 0x7fffffffU;
    add_triangle(triangle, emits);
  }
}

TriangleMesh MeshBuilder::finish() {
  mesh_.positions.emplace_back(0.0F);  // padding, see RayCaster
  return std::move(mesh_);
}

}  // namespace transport
