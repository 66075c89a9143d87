#include <array>
#include <utility>

#include <fmt/format.h>

#include "grf/visit.h"
#include "renderer/transport/scene/compiled_scene.h"
#include "renderer/transport/scene/triangulation.h"

namespace transport {
namespace {

using grf::AreaLight;
using grf::Matrix44d;
using grf::Mesh;
using grf::Placement;
using grf::ResolvedSurface;

Vec3f transformed(const Vec3f& position, const Matrix44d& to_world) {
  return Vec3f(grf::Vec3d(position) * to_world);
}

Vec3f transformed_edge(const Vec3f& edge, const Matrix44d& to_world) {
  grf::Vec3d result;
  to_world.multDirMatrix(grf::Vec3d(edge), result);
  return Vec3f(result);
}

/// Normals follow the inverse transpose.
Matrix44d normal_matrix(const Matrix44d& to_world) { return to_world.inverse().transposed(); }

bool mirrors(const Matrix44d& to_world) { return to_world.determinant() < 0; }

class Compiler {
 public:
  Compiler(const CompileSettings& settings, grf::Diagnostics& diagnostics)
      : settings_(settings),
        diagnostics_(diagnostics),
        reflectors_(settings.scheme, settings.missed_part, diagnostics) {}

  void add(const Mesh& mesh, const Placement& placement);
  void add(const grf::MeshLight& light, const Placement& placement);
  void add(const AreaLight& light, const Placement& placement);

  CompiledScene finish() {
    if (textured_faces_ > 0) {
      diagnostics_.warning({}, fmt::format("textures are not rendered: {} {} shown without", textured_faces_,
                                           textured_faces_ == 1 ? "face is" : "faces are"));
    }
    if (emitters_.empty()) geometry_.emitter_of_triangle.clear();
    for (const Vec3f& position : geometry_.positions) geometry_.bounds.extendBy(position);
    geometry_.positions.emplace_back(0.0F);  // padding, see RayCaster
    return CompiledScene(std::move(geometry_), std::move(surfaces_), reflectors_.build(settings_.threads),
                         Lights(std::move(emitters_)));
  }

 private:
  void add_vertices(const Mesh& mesh, const Matrix44d& to_world);
  bool has_room_for(const Mesh& mesh);
  std::vector<std::uint32_t> add_surfaces(const Mesh& mesh, const grf::Scope& scope);
  std::vector<std::uint32_t> add_light_surfaces(const Mesh& mesh, const grf::Scope& scope);
  void add_faces(const Mesh& mesh, const Matrix44d& to_world, const std::vector<std::uint32_t>& surfaces);
  void add_face(const Mesh& mesh, std::size_t face, std::uint32_t surface, std::uint32_t first_vertex,
                bool turn);
  void add_triangle(const std::array<std::uint32_t, 3>& corners, TriangleSurface surface,
                    std::uint32_t emitter);
  std::uint32_t reflector_of(const ResolvedSurface& surface);
  std::uint32_t add_triangle_emitter(const std::array<std::uint32_t, 3>& corners, const Rgb& radiance);

  const CompileSettings& settings_;
  grf::Diagnostics& diagnostics_;
  ReflectorSetBuilder reflectors_;
  Geometry geometry_;
  std::vector<CompiledSurface> surfaces_;
  std::vector<Emitter> emitters_;
  std::size_t textured_faces_ = 0;
  bool is_too_large_ = false;
};

void Compiler::add(const Mesh& mesh, const Placement& placement) {
  if (!has_room_for(mesh)) return;
  add_faces(mesh, placement.to_world, add_surfaces(mesh, placement.scope));
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    if (mesh.surface(i).texture) ++textured_faces_;
  }
}

void Compiler::add(const grf::MeshLight& light, const Placement& placement) {
  if (!has_room_for(*light.mesh)) return;
  add_faces(*light.mesh, placement.to_world, add_light_surfaces(*light.mesh, placement.scope));
}

// Each instance is a copy here, so a scene that is small as a file can be large.
bool Compiler::has_room_for(const Mesh& mesh) {
  constexpr std::size_t MostTriangles = 200'000'000;
  if (is_too_large_) return false;
  is_too_large_ = geometry_.triangle_surfaces.size() + mesh.corners.size() > MostTriangles;
  if (is_too_large_) {
    diagnostics_.error(
        {}, fmt::format("more than {} million triangles, each instance counted, cannot be rendered",
                        MostTriangles / 1'000'000));
  }
  return !is_too_large_;
}

// A mirroring transform turns triangles inside out: the other winding keeps their front where it was.
void Compiler::add_faces(const Mesh& mesh, const Matrix44d& to_world,
                         const std::vector<std::uint32_t>& surfaces) {
  const auto first_vertex = static_cast<std::uint32_t>(geometry_.positions.size());
  add_vertices(mesh, to_world);
  const bool turn = mirrors(to_world);
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    add_face(mesh, i, surfaces[mesh.surface_of_face[i]], first_vertex, turn);
  }
}

void Compiler::add_vertices(const Mesh& mesh, const Matrix44d& to_world) {
  const std::size_t first = geometry_.positions.size();
  const std::size_t count = mesh.positions.size();
  for (const Vec3f& position : mesh.positions) geometry_.positions.push_back(transformed(position, to_world));
  if (!mesh.normals.empty()) geometry_.normals.resize(first, Vec3f(0));
  if (!geometry_.normals.empty() || !mesh.normals.empty()) {
    const Matrix44d to_world_normal = normal_matrix(to_world);
    for (std::size_t i = 0; i < count; ++i) {
      geometry_.normals.push_back(
          mesh.normals.has(i) ? transformed_edge(mesh.normals[i], to_world_normal).normalized() : Vec3f(0));
    }
  }
  if (!mesh.colours.empty()) geometry_.colours.resize(first, Colour(1));
  if (!geometry_.colours.empty() || !mesh.colours.empty()) {
    for (std::size_t i = 0; i < count; ++i) {
      geometry_.colours.push_back(mesh.colours.has(i) ? mesh.colours[i] : Colour(1));
    }
  }
}

std::vector<std::uint32_t> Compiler::add_surfaces(const Mesh& mesh, const grf::Scope& scope) {
  const std::vector<bool> used = used_surfaces(mesh);
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    indices.push_back(static_cast<std::uint32_t>(surfaces_.size()));
    if (!used[i]) continue;
    const ResolvedSurface resolved = resolve(mesh.surfaces[i], scope);
    surfaces_.push_back({resolved.colour, resolved.emission.value_or(Colour(0)), reflector_of(resolved)});
  }
  return indices;
}

// The colour of a mesh light is what it emits.
std::vector<std::uint32_t> Compiler::add_light_surfaces(const Mesh& mesh, const grf::Scope& scope) {
  std::vector<std::uint32_t> indices;
  for (const grf::Surface& surface : mesh.surfaces) {
    indices.push_back(static_cast<std::uint32_t>(surfaces_.size()));
    surfaces_.push_back({Rgb(1), resolve(surface, scope).colour, None});
  }
  return indices;
}

// An emitter without a BRDF reflects nothing; any other face without one is diffuse.
std::uint32_t Compiler::reflector_of(const ResolvedSurface& surface) {
  if (surface.brdf == nullptr && surface.emission) return None;
  return reflectors_.index_of(surface);
}

void Compiler::add_face(const Mesh& mesh, std::size_t face, std::uint32_t surface, std::uint32_t first_vertex,
                        bool turn) {
  const auto corners = mesh.face(face);
  std::vector<Vec3f> positions;
  bool is_flat = geometry_.normals.empty();
  for (const std::uint32_t corner : corners) {
    positions.push_back(geometry_.positions[first_vertex + corner]);
    is_flat = is_flat || geometry_.normals[first_vertex + corner] == Vec3f(0);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangulate(positions, triangles);
  const bool emits = !reflectance::is_black(surfaces_[surface].emission);
  for (auto [a, b, c] : triangles) {
    if (turn) std::swap(b, c);
    const std::array<std::uint32_t, 3> vertices = {first_vertex + corners[a], first_vertex + corners[b],
                                                   first_vertex + corners[c]};
    const std::uint32_t emitter = emits ? add_triangle_emitter(vertices, surfaces_[surface].emission) : None;
    add_triangle(vertices, {surface, is_flat}, emitter);
  }
}

void Compiler::add_triangle(const std::array<std::uint32_t, 3>& corners, TriangleSurface surface,
                            std::uint32_t emitter) {
  geometry_.triangles.insert(geometry_.triangles.end(), corners.begin(), corners.end());
  geometry_.triangle_surfaces.push_back(surface);
  geometry_.emitter_of_triangle.push_back(emitter);
}

std::uint32_t Compiler::add_triangle_emitter(const std::array<std::uint32_t, 3>& corners,
                                             const Rgb& radiance) {
  const Vec3f& a = geometry_.positions[corners[0]];
  const Emitter emitter{a, geometry_.positions[corners[1]] - a, geometry_.positions[corners[2]] - a, true,
                        radiance};
  if (!(emitter.area() > 0)) return None;
  emitters_.push_back(emitter);
  return static_cast<std::uint32_t>(emitters_.size() - 1);
}

void Compiler::add(const AreaLight& light, const Placement& placement) {
  const Matrix44d& to_world = placement.to_world;
  Emitter emitter{transformed(light.corner, to_world), transformed_edge(light.edge1, to_world),
                  transformed_edge(light.edge2, to_world), false, light.radiance.value_or(Colour(1))};
  if (mirrors(to_world)) std::swap(emitter.edge1, emitter.edge2);
  const auto first = static_cast<std::uint32_t>(geometry_.positions.size());
  const Vec3f& corner = emitter.corner;
  for (const Vec3f& position :
       {corner, corner + emitter.edge1, corner + emitter.edge1 + emitter.edge2, corner + emitter.edge2}) {
    geometry_.positions.push_back(position);
    if (!geometry_.normals.empty()) geometry_.normals.emplace_back(0.0F);
    if (!geometry_.colours.empty()) geometry_.colours.emplace_back(1.0F);
  }
  const auto surface = static_cast<std::uint32_t>(surfaces_.size());
  surfaces_.push_back({Rgb(1), emitter.radiance, None});
  std::uint32_t index = None;
  if (emitter.area() > 0 && !reflectance::is_black(emitter.radiance)) {
    index = static_cast<std::uint32_t>(emitters_.size());
    emitters_.push_back(emitter);
  }
  add_triangle({first, first + 1, first + 2}, {surface, true}, index);
  add_triangle({first, first + 2, first + 3}, {surface, true}, index);
}

}  // namespace

std::optional<CompiledScene> compile(const grf::Scene& scene, grf::Diagnostics& diagnostics,
                                     const CompileSettings& settings) {
  const std::size_t errors_before = diagnostics.error_count();
  Compiler compiler(settings, diagnostics);
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const grf::Block&) {
    compiler.add(mesh, placement);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const Placement& placement, const grf::Block&) {
    compiler.add(light, placement);
  };
  visitor.light = [&](const AreaLight& light, const Placement& placement, const grf::Block&) {
    compiler.add(light, placement);
  };
  grf::visit(scene, visitor);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return compiler.finish();
}

}  // namespace transport
