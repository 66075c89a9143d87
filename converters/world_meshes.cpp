#include "converters/world_meshes.h"

#include <algorithm>
#include <cmath>

#include "grf/keywords.h"

namespace convert {
namespace {

bool is_identity_3x3(const grf::Matrix44d& matrix) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (matrix[i][k] != (i == k ? 1.0 : 0.0)) return false;
    }
  }
  return true;
}

double determinant_3x3(const grf::Matrix44d& m) {
  const grf::Vec3d x(m[0][0], m[0][1], m[0][2]);
  const grf::Vec3d y(m[1][0], m[1][1], m[1][2]);
  const grf::Vec3d z(m[2][0], m[2][1], m[2][2]);
  return x.cross(y).dot(z);
}

std::size_t count_vertices(const grf::Mesh& mesh, const auto& values) {
  if (values.empty()) return 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) count += values.has(i) ? 1 : 0;
  return count;
}

std::size_t count_faces_with_uv(const grf::Mesh& mesh) {
  if (mesh.geometry->uvs.empty()) return 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const auto face = mesh.face(i);
    const auto has_uv = [&mesh](std::uint32_t vertex) { return mesh.geometry->uvs.has(vertex); };
    if (std::any_of(face.begin(), face.end(), has_uv)) ++count;
  }
  return count;
}

std::size_t count_polygons(const grf::Mesh& mesh) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) count += mesh.face(i).size() > 3 ? 1 : 0;
  return count;
}

std::size_t count_loose_vertices(const grf::Mesh& mesh) {
  std::vector<bool> used(mesh.geometry->positions.size());
  for (const std::uint32_t corner : mesh.geometry->corners) used[corner] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

bool has(Loss loss, const WorldSurface& surface) {
  switch (loss) {
    case Loss::Brdf:
      return surface.brdf != nullptr;
    case Loss::ParameterMap:
      return surface.brdf != nullptr && has_maps(*surface.brdf);
    case Loss::SamplingScheme:
      return surface.pdf != nullptr;
    case Loss::Texture:
      return surface.texture != nullptr;
    case Loss::FaceColour:
      return surface.colour.has_value();
    case Loss::Emission:
      return surface.emission.has_value();
    case Loss::Opacity:
      return surface.opacity != grf::Opacity();
    case Loss::Cutoff:
      return surface.opacity.kind == grf::Opacity::Kind::Mask;
    default:
      return false;
  }
}

std::size_t count_in(const WorldMesh& placed, Loss loss) {
  const grf::Mesh& mesh = placed.mesh();
  if (loss == Loss::AreaLight) return placed.is_light() ? 1 : 0;
  if (placed.is_light()) return 0;
  switch (loss) {
    case Loss::Irradiance:
      return count_vertices(mesh, *mesh.irradiance);
    case Loss::VertexColour:
      return count_vertices(mesh, mesh.geometry->colours);
    case Loss::Normal:
      return count_vertices(mesh, mesh.geometry->normals);
    case Loss::TextureCoordinates:
      return count_faces_with_uv(mesh);
    case Loss::Polygon:
      return count_polygons(mesh);
    case Loss::LooseVertex:
      return count_loose_vertices(mesh);
    case Loss::MeshName:
      return placed.name().empty() ? 0 : 1;
    default:
      break;
  }
  std::size_t faces = 0;
  for (const WorldSurface& surface : placed.surfaces()) faces += has(loss, surface) ? surface.faces : 0;
  return faces;
}

}  // namespace

std::vector<const grf::BrdfModel*> named_brdfs(const grf::BrdfModel& brdf, const grf::Scope& scope) {
  std::vector<const grf::BrdfModel*> named;
  for (const grf::CombineTerm& term : brdf.terms) {
    named.push_back(scope.find<grf::BrdfModel>(term.brdf.name));
  }
  return named;
}

WorldMesh::WorldMesh(const grf::Mesh& mesh, const grf::Matrix44d& to_world, bool is_light)
    : mesh_(&mesh),
      to_world_(to_world),
      normals_to_world_(to_world.inverse().transposed()),
      moves_(to_world != grf::Matrix44d()),
      turns_normals_(!is_identity_3x3(to_world)),
      mirrors_(determinant_3x3(to_world) < 0),
      is_light_(is_light),
      name_(mesh.name),
      surfaces_(mesh.surfaces.size()) {
  for (const std::uint32_t surface : *mesh.surface_of_face) ++surfaces_[surface].faces;
}

grf::Vec3f WorldMesh::position(std::size_t vertex) const {
  const grf::Vec3f& position = mesh_->geometry->positions[vertex];
  return moves_ ? grf::Vec3f(grf::Vec3d(position) * to_world_) : position;
}

grf::Vec3f WorldMesh::normal(std::size_t vertex) const {
  const grf::Vec3f& normal = mesh_->geometry->normals[vertex];
  if (!turns_normals_) return normal;
  grf::Vec3d turned(0);
  normals_to_world_.multDirMatrix(grf::Vec3d(normal), turned);
  return grf::Vec3f(turned.normalized());
}

std::span<const std::uint32_t> WorldMesh::face(std::size_t index) const {
  const auto corners = mesh_->face(index);
  if (!mirrors_) return corners;
  turned_face_.assign(corners.begin(), corners.end());
  std::reverse(turned_face_.begin() + 1, turned_face_.end());
  return turned_face_;
}

WorldMeshes::WorldMeshes(const grf::Scene& scene) {
  grf::SceneVisitor visitor;
  visitor.mesh = [this](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    add(mesh, placement);
  };
  visitor.mesh_light = [this](const grf::MeshLight& light, const grf::Placement& placement,
                              const grf::Block&) { add_light(*light.mesh, placement); };
  visitor.light = [this](const grf::AreaLight& light, const grf::Placement& placement, const grf::Block&) {
    grf::MeshDraft mesh;
    mesh.positions = {light.corner, light.corner + light.edge1, light.corner + light.edge1 + light.edge2,
                      light.corner + light.edge2};
    if (light.radiance) mesh.surfaces.front().colour = *light.radiance;
    mesh.add_face(std::array<std::uint32_t, 4>{0, 1, 2, 3}, 0);
    add_light(parallelograms_.emplace_back(std::move(mesh)), placement);
  };
  grf::visit(scene, visitor);
}

void WorldMeshes::add(const grf::Mesh& mesh, const grf::Placement& placement) {
  WorldMesh& placed = meshes_.emplace_back(mesh, placement.to_world, false);
  if (placed.name_.empty() && placement.instance_of != nullptr) {
    placed.name_ = grf::from_identifier(placement.instance_of->name);
  }
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    const grf::Surface& given = mesh.surfaces[i];
    const grf::ResolvedSurface resolved = grf::resolve(given, placement.scope);
    WorldSurface& surface = placed.surfaces_[i];
    if (given.colour) surface.colour = resolved.colour;
    surface.brdf = resolved.brdf;
    if (resolved.brdf != nullptr) surface.terms = named_brdfs(*resolved.brdf, resolved.brdf_scope);
    surface.pdf = resolved.pdf;
    surface.texture = resolved.texture;
    surface.emission = resolved.emission;
    surface.opacity = resolved.opacity;
    const auto* name = given.brdf ? std::get_if<grf::Reference>(&*given.brdf) : nullptr;
    if (name == nullptr || resolved.brdf == nullptr || surface.faces == 0) continue;
    surface.material = material_of(*placement.scope.find(name->name));
  }
}

// The colour of a mesh light is its radiance, 1 by default.
void WorldMeshes::add_light(const grf::Mesh& mesh, const grf::Placement& placement) {
  WorldMesh& placed = meshes_.emplace_back(mesh, placement.to_world, true);
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    placed.surfaces_[i].emission = grf::resolve(mesh.surfaces[i], placement.scope).colour;
  }
}

std::size_t WorldMeshes::material_of(const grf::Definition& definition) {
  const auto [known, is_new] = material_of_definition_.emplace(&definition, materials_.size());
  if (is_new) materials_.push_back(grf::from_identifier(names_.take(grf::from_identifier(definition.name))));
  return known->second;
}

bool WorldMeshes::is_finite() const {
  const auto fits = [](const grf::Vec3f& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  for (const WorldMesh& placed : meshes_) {
    const grf::Mesh& mesh = placed.mesh();
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
      if (!fits(placed.position(i)) || (mesh.geometry->normals.has(i) && !fits(placed.normal(i))))
        return false;
    }
  }
  return true;
}

void WorldMeshes::count(std::initializer_list<Loss> kinds, Losses& losses) const {
  for (const WorldMesh& mesh : meshes_) {
    for (const Loss loss : kinds) losses.add(loss, count_in(mesh, loss));
  }
}

}  // namespace convert
