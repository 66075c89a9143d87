#include "renderer/plan/coarse_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>

#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/plan/convex_solid.h"
#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/varying_brdf.h"
#include "renderer/transport/scene/mesh_builder.h"
#include "renderer/transport/scene/scene_stats.h"

namespace plan {
namespace {

using grf::Box3d;
using grf::Matrix44d;
using grf::Mesh;
using grf::Placement;
using grf::Vec3d;
using grf::Vec3f;
using transport::InvalidIndex;
using transport::SceneStats;
using transport::UsedVertices;

/// A mesh of more triangles is represented by a box per surface.
constexpr std::size_t MostTrianglesOfMesh = 256;
/// The limit of parts, since all pairs of parts are tested.
constexpr std::size_t MostParts = 1024;

double largest_component(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

Vec3d unit_normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d normal = (b - a).cross(c - a);
  const double length = normal.length();
  return length > 0 ? normal / length : Vec3d(0);
}

/// Facts that do not depend on a mesh's placement.
struct MeshFacts {
  std::vector<std::size_t> faces;  ///< per surface
  std::vector<bool> is_smooth;     ///< per surface: some face has vertex normals that differ from its own
  bool has_colours = false;
};

bool differs(const Vec3f& normal, const Vec3d& geometric) {
  return Vec3d(normal).normalized().dot(geometric) < 1 - 1e-12;
}

bool is_smooth(const Mesh& mesh, std::span<const std::uint32_t> corners) {
  if (mesh.geometry->normals.empty()) return false;
  const auto has = [&](std::uint32_t corner) {
    return mesh.geometry->normals.has(corner) && mesh.geometry->normals[corner] != Vec3f(0);
  };
  if (!std::all_of(corners.begin(), corners.end(), has)) return false;
  const auto at = [&](std::size_t i) { return Vec3d(mesh.geometry->positions[corners[i]]); };
  const Vec3d normal = unit_normal(at(0), at(1), at(2));
  return std::any_of(corners.begin(), corners.end(),
                     [&](std::uint32_t corner) { return differs(mesh.geometry->normals[corner], normal); });
}

MeshFacts facts_of(const Mesh& mesh) {
  MeshFacts facts;
  facts.faces.resize(mesh.surfaces.size());
  facts.is_smooth.resize(mesh.surfaces.size());
  const grf::Triangulation& triangles = mesh.geometry.triangulation();
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const std::uint32_t surface = (*mesh.surface_of_face)[face];
    ++facts.faces[surface];
    if (mesh.geometry->normals.empty() || facts.is_smooth[surface]) continue;
    // Of more than three corners, some may lack a normal and others have different ones: any triangle counts.
    for (std::size_t i = triangles.first_of(face); i < triangles.first_of(face + 1); ++i) {
      if (is_smooth(mesh, triangles[i])) facts.is_smooth[surface] = true;
    }
  }
  for (std::size_t i = 0; i < mesh.geometry->positions.size() && !facts.has_colours; ++i) {
    facts.has_colours = mesh.geometry->colours.has(i) && mesh.geometry->colours[i] != grf::Colour(1);
  }
  return facts;
}

class CoarseSceneBuilder {
 public:
  CoarseSceneBuilder(CoarseScene& coarse_scene, const SceneStats& stats)
      : coarse_scene_(coarse_scene), stats_(stats), brdfs_(ignored_diagnostics_) {}

  void add(const Mesh& mesh, const Placement& placement, bool is_light);
  void add(const grf::AreaLight& light, const Placement& placement);
  void finish();

 private:
  /// The key of a resolved surface: most of thousands of instances have the same one.
  struct SurfaceKey {
    const Mesh* mesh;
    std::uint32_t index;
    const grf::BrdfModel* brdf;
    const grf::PdfModel* pdf;
    const grf::Texture* texture;
    bool is_black;
    bool emits;
    std::string sum;  ///< of a `combine`: what its names resolve to there

    // clang-tidy takes the comparison's own 0 for a pointer.
    auto operator<=>(const SurfaceKey&) const = default;  // NOLINT(modernize-use-nullptr)
  };

  const MeshFacts& facts(const Mesh& mesh);
  CoarseSurface described(const Mesh& mesh, const grf::ResolvedSurface& resolved, bool is_light);
  std::uint32_t surface_of(const Mesh& mesh, std::uint32_t index, const grf::Scope& scope, bool is_light);
  void describe_brdf(const grf::ResolvedSurface& resolved, CoarseSurface& surface);
  void add_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& surfaces,
                     const std::vector<Vec3d>& positions, bool turns);
  void find_solid(std::size_t first_part);
  void add_boxes(const Mesh& mesh, const std::vector<std::uint32_t>& surfaces,
                 const std::vector<Vec3d>& positions);
  void add_box(std::uint32_t surface, const Box3d& box, bool is_smooth);
  void add_part(std::uint32_t surface, std::span<const Vec3d> points, bool is_smooth, bool is_plane);
  Matrix44d to_scene(const Placement& placement) const {
    return placement.to_world * Matrix44d().setTranslation(-coarse_scene_.origin);
  }
  bool has_room() const { return coarse_scene_.parts.size() <= MostParts; }

  CoarseScene& coarse_scene_;
  const SceneStats& stats_;
  grf::Diagnostics ignored_diagnostics_;  // compiling reports these errors
  reflectance::BrdfMaker brdfs_;
  std::unordered_map<const Mesh*, MeshFacts> facts_;
  std::map<SurfaceKey, std::uint32_t> surface_of_key_;
  Box3d bounds_;
  std::uint32_t lights_ = 0;
};

const MeshFacts& CoarseSceneBuilder::facts(const Mesh& mesh) {
  const auto found = facts_.find(&mesh);
  return found != facts_.end() ? found->second : facts_.emplace(&mesh, facts_of(mesh)).first->second;
}

/// Describes a BRDF that images vary, without reading them: it may have any component but those that its
/// model never has.
void describe_varying(const grf::BrdfModel& brdf, CoarseSurface& surface) {
  const reflectance::VaryingBrdf varying(brdf);
  for (const reflectance::VaryingBrdf::Map& map : varying.maps()) surface.maps.push_back(map.path);
  surface.is_diffuse = true;
  surface.is_glossy = !varying.is_diffuse();
  surface.is_specular = varying.may_be_specular();
  surface.is_anisotropic = varying.may_be_anisotropic();
}

/// Describes a BRDF without loading data: a measured one may have any component but a specular one.
void CoarseSceneBuilder::describe_brdf(const grf::ResolvedSurface& resolved, CoarseSurface& surface) {
  surface.brdf = resolved.brdf != nullptr ? to_text(*resolved.brdf) : "diffuse";
  surface.scheme = resolved.pdf != nullptr ? to_text(*resolved.pdf) : "auto";
  if (resolved.brdf != nullptr) surface.identity = brdfs_.identity(*resolved.brdf, resolved.brdf_scope);
  if (reflectance::is_black(resolved.colour)) return;
  const auto add = [&](const reflectance::Brdf& brdf) {
    surface.is_diffuse |= reflectance::has_diffuse_part(brdf);
    surface.is_glossy |= reflectance::has_glossy_part(brdf);
    surface.is_specular |= reflectance::has_specular_part(brdf);
    surface.is_glass |= std::holds_alternative<reflectance::Glass>(brdf);
    surface.is_anisotropic |= reflectance::is_anisotropic(brdf);
  };
  if (resolved.brdf == nullptr) return add(reflectance::default_brdf());
  if (has_maps(*resolved.brdf)) return describe_varying(*resolved.brdf, surface);
  for (const grf::BrdfModel* leaf : brdfs_.models_of(*resolved.brdf, resolved.brdf_scope)) {
    if (const auto brdf = reflectance::make_brdf(*leaf)) add(*brdf);
    if (leaf->data_file.empty()) continue;
    surface.is_measured = surface.is_diffuse = surface.is_glossy = true;
  }
}

std::string path_of(const grf::Texture* texture) {
  if (texture == nullptr) return {};
  const auto& file = texture->location.file;
  return file ? grf::path_beside(file->path, texture->file) : texture->file;
}

CoarseSurface CoarseSceneBuilder::described(const Mesh& mesh, const grf::ResolvedSurface& resolved,
                                            bool is_light) {
  CoarseSurface surface;
  surface.mesh = &mesh;
  const std::string texture = is_light ? std::string() : path_of(resolved.texture);
  if (!is_light) {
    surface.is_cutout = resolved.opacity != grf::Opacity();
    if (resolved.opacity.reads_alpha()) surface.alpha = texture;
  }
  // As in SurfaceSetBuilder: an emitter without a BRDF reflects nothing.
  if (is_light || (resolved.brdf == nullptr && resolved.emission)) return surface;
  describe_brdf(resolved, surface);
  surface.has_colours = facts(mesh).has_colours;
  surface.has_irradiance = !mesh.irradiance->empty();
  surface.texture = texture;
  return surface;
}

std::uint32_t CoarseSceneBuilder::surface_of(const Mesh& mesh, std::uint32_t index, const grf::Scope& scope,
                                             bool is_light) {
  const grf::ResolvedSurface resolved = resolve(mesh.surfaces[index], scope);
  const grf::Colour emission = is_light ? resolved.colour : resolved.emission.value_or(grf::Colour(0));
  SurfaceKey key{&mesh,
                 index,
                 resolved.brdf,
                 resolved.pdf,
                 resolved.texture,
                 reflectance::is_black(resolved.colour),
                 !reflectance::is_black(emission),
                 {}};
  if (resolved.brdf != nullptr && !resolved.brdf->terms.empty()) {
    key.sum = brdfs_.identity(*resolved.brdf, resolved.brdf_scope);
  }
  const bool emits = key.emits;
  const auto [known, is_new] =
      surface_of_key_.try_emplace(std::move(key), static_cast<std::uint32_t>(coarse_scene_.surfaces.size()));
  if (is_new) {
    coarse_scene_.surfaces.push_back(described(mesh, resolved, is_light));
    coarse_scene_.surfaces.back().index = index;
    coarse_scene_.surfaces.back().emits = emits;
    coarse_scene_.surfaces.back().is_smooth = facts(mesh).is_smooth[index];
  }
  coarse_scene_.surfaces[known->second].faces += facts(mesh).faces[index];
  return known->second;
}

void CoarseSceneBuilder::add(const Mesh& mesh, const Placement& placement, bool is_light) {
  std::vector<std::uint32_t> surfaces(mesh.surfaces.size(), InvalidIndex);
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    if (facts(mesh).faces[i] > 0) surfaces[i] = surface_of(mesh, i, placement.scope, is_light);
  }
  coarse_scene_.triangles += mesh.geometry->triangle_count();
  const Matrix44d map = to_scene(placement);
  if (stats_.is_instanced(mesh)) {
    const Box3d box = transport::transformed(stats_.box_of(mesh), map);
    bounds_.extendBy(box);
    ++coarse_scene_.instances;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (surfaces[i] != InvalidIndex) add_box(surfaces[i], box, facts(mesh).is_smooth[i]);
    }
    return;
  }
  const UsedVertices& used = stats_.vertices_of(mesh);
  std::vector<Vec3d> positions;
  for (std::size_t i = 0; i < used.count(); ++i) {
    // Rounded, as in ray tracing.
    positions.emplace_back(Vec3f(Vec3d(mesh.geometry->positions[used[i]]) * map));
    bounds_.extendBy(positions.back());
  }
  if (!has_room()) return;
  if (mesh.geometry->triangle_count() > MostTrianglesOfMesh) return add_boxes(mesh, surfaces, positions);
  add_triangles(mesh, surfaces, positions, transport::mirrors(placement.to_world));
}

void CoarseSceneBuilder::add_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& surfaces,
                                       const std::vector<Vec3d>& positions, bool turns) {
  const std::size_t first_part = coarse_scene_.parts.size();
  const UsedVertices& used = stats_.vertices_of(mesh);
  const grf::Triangulation& triangles = mesh.geometry.triangulation();
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    for (std::size_t i = triangles.first_of(face); i < triangles.first_of(face + 1); ++i) {
      const std::array<std::uint32_t, 3> of_mesh = triangles[i];
      const auto point = [&](std::size_t k) { return positions[used.index_of(of_mesh[k])]; };
      std::array points = {point(0), point(1), point(2)};
      if (turns) std::swap(points[1], points[2]);
      add_part(surfaces[(*mesh.surface_of_face)[face]], points, is_smooth(mesh, of_mesh), true);
    }
  }
  find_solid(first_part);
}

// Light gets into a solid whose faces let it pass.
void CoarseSceneBuilder::find_solid(std::size_t first_part) {
  if (!has_room()) return;
  const std::span parts = std::span(coarse_scene_.parts).subspan(first_part);
  const auto lets_light_in = [&](const CoarsePart& part) {
    const CoarseSurface& surface = coarse_scene_.surfaces[part.surface];
    return surface.is_cutout || surface.is_glass;
  };
  if (std::any_of(parts.begin(), parts.end(), lets_light_in)) return;
  std::vector<PlaneTriangle> triangles;
  double extent = 0;
  for (const CoarsePart& part : parts) {
    triangles.push_back(
        {std::span(coarse_scene_.points).subspan(part.first_point, 3), part.normal, part.height});
    extent = std::max(extent, part.extent);
  }
  if (!enclose_convex_solid(triangles, CoarseRounding * extent)) return;
  for (CoarsePart& part : parts) part.solid = static_cast<std::uint32_t>(coarse_scene_.solids.size());
  coarse_scene_.solids.push_back(
      {static_cast<std::uint32_t>(first_part), static_cast<std::uint32_t>(parts.size())});
}

void CoarseSceneBuilder::add_boxes(const Mesh& mesh, const std::vector<std::uint32_t>& surfaces,
                                   const std::vector<Vec3d>& positions) {
  std::vector<Box3d> boxes(surfaces.size());
  const UsedVertices& used = stats_.vertices_of(mesh);
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    for (const std::uint32_t corner : mesh.face(face)) {
      boxes[(*mesh.surface_of_face)[face]].extendBy(positions[used.index_of(corner)]);
    }
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i] != InvalidIndex) add_box(surfaces[i], boxes[i], facts(mesh).is_smooth[i]);
  }
}

void CoarseSceneBuilder::add_box(std::uint32_t surface, const Box3d& box, bool smooth) {
  std::array<Vec3d, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      corners[i][axis] = (i >> axis & 1U) != 0 ? box.max[axis] : box.min[axis];
    }
  }
  add_part(surface, corners, smooth, false);
}

void CoarseSceneBuilder::add_part(std::uint32_t surface, std::span<const Vec3d> points, bool smooth,
                                  bool is_plane) {
  if (!has_room()) return;
  CoarsePart part;
  part.surface = surface;
  part.first_point = static_cast<std::uint32_t>(coarse_scene_.points.size());
  part.points = static_cast<std::uint32_t>(points.size());
  part.is_smooth = smooth;
  for (const Vec3d& point : points) part.extent = std::max(part.extent, largest_component(point));
  if (is_plane) part.normal = unit_normal(points[0], points[1], points[2]);
  part.height = part.normal.dot(points[0]);
  coarse_scene_.points.insert(coarse_scene_.points.end(), points.begin(), points.end());
  coarse_scene_.parts.push_back(part);
}

void CoarseSceneBuilder::add(const grf::AreaLight& light, const Placement& placement) {
  CoarseSurface surface;
  surface.faces = 1;
  surface.index = lights_++;
  surface.emits = !reflectance::is_black(light.radiance.value_or(grf::Colour(1)));
  const auto index = static_cast<std::uint32_t>(coarse_scene_.surfaces.size());
  coarse_scene_.surfaces.push_back(surface);
  coarse_scene_.triangles += 2;
  const Matrix44d map = to_scene(placement);
  const Vec3f corner(Vec3d(light.corner) * map);
  const auto edge = [&](const Vec3f& of_light) {
    Vec3d result;
    map.multDirMatrix(Vec3d(of_light), result);
    return Vec3f(result);
  };
  Vec3f edge1 = edge(light.edge1);
  Vec3f edge2 = edge(light.edge2);
  if (transport::mirrors(map)) std::swap(edge1, edge2);
  const std::array points = {Vec3d(corner), Vec3d(corner + edge1), Vec3d(corner + edge2),
                             Vec3d(corner + edge1 + edge2)};
  for (const Vec3d& point : points) bounds_.extendBy(point);
  add_part(index, points, false, true);
}

void CoarseSceneBuilder::finish() {
  if (!bounds_.isEmpty()) {
    coarse_scene_.bounds = {bounds_.min + coarse_scene_.origin, bounds_.max + coarse_scene_.origin};
  }
  if (has_room()) return;
  coarse_scene_.parts.clear();
  coarse_scene_.solids.clear();
  coarse_scene_.points.clear();
}

}  // namespace

CoarseScene::CoarseScene(const grf::Scene& scene, std::size_t most_copied_triangles) {
  const SceneStats stats(scene, most_copied_triangles);
  origin = stats.origin;
  if (stats.is_too_large()) return;  // compiling reports it
  CoarseSceneBuilder builder(*this, stats);
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const grf::Block&) {
    builder.add(mesh, placement, false);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const Placement& placement, const grf::Block&) {
    builder.add(*light.mesh, placement, true);
  };
  visitor.light = [&](const grf::AreaLight& light, const Placement& placement, const grf::Block&) {
    builder.add(light, placement);
  };
  grf::visit(scene, visitor);
  builder.finish();
}

}  // namespace plan
