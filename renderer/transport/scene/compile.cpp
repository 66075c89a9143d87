#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "grf/visit.h"
#include "renderer/parallel/loops.h"
#include "renderer/transport/scene/compiled_scene.h"
#include "renderer/transport/scene/mesh_builder.h"
#include "renderer/transport/scene/scene_stats.h"
#include "renderer/transport/scene/surface_set.h"

namespace transport {
namespace {

using grf::AreaLight;
using grf::Matrix44d;
using grf::Mesh;
using grf::Placement;
using grf::Vec3d;

Vec3f transformed_edge(const Vec3f& edge, const Matrix44d& map) {
  Vec3d result;
  map.multDirMatrix(Vec3d(edge), result);
  return Vec3f(result);
}

/// The y axis of an object in scene coordinates, see CompiledSurface.
Vec3f axis_of(const Matrix44d& to_world) {
  Vec3d axis;
  to_world.inverse().transposed().multDirMatrix(Vec3d(0, 1, 0), axis);
  return Vec3f(mirrors(to_world) ? -axis.normalized() : axis.normalized());
}

/// A placed mesh or light.
struct Placed {
  const Mesh* mesh = nullptr;
  const AreaLight* light = nullptr;
  std::uint32_t first_surface = 0;
  Matrix44d to_scene;
  const grf::Block* block = nullptr;
};

EffectSet effects_of(const CompileSettings& settings) {
  EffectSet effects = settings.effects;
  if (!settings.has_irradiance) effects.remove(Effect::Irradiance);
  return effects;
}

/// Collects all placements with their surfaces, while their scope is known; then builds the arrays, whose
/// sizes are known by then.
class Compiler {
 public:
  Compiler(const grf::Scene& scene, const CompileSettings& settings, grf::Diagnostics& diagnostics,
           const CompiledScene* before)
      : settings_(settings),
        before_(before),
        diagnostics_(diagnostics),
        effects_(effects_of(settings)),
        stats_(scene, most_copied_triangles(settings)),
        reflectors_(settings.scheme, settings.missed_part, settings.precision, diagnostics,
                    before != nullptr ? &before->reflectors() : nullptr),
        textures_(settings.image_reader, diagnostics),
        surfaces_(reflectors_, textures_, effects_, settings.reflecting.get()) {
    geometry_.origin = stats_.origin;
  }

  bool has_room();
  void list(const grf::Scene& scene);
  void build();
  /// Reads images, builds tables, and builds the acceleration structure.
  std::optional<CompiledScene> finish();

 private:
  bool is_to_stop() const { return settings_.stop.stop_requested(); }
  RayCaster caster_of(std::shared_ptr<const Geometry> geometry) const;
  void list(const Mesh& mesh, const Placement& placement, const grf::Block& block);
  Matrix44d to_scene(const Placement& placement) const;
  MeshSize size_of_first_mesh() const;
  void place(const Placed& placed, MeshBuilder& builder);
  void place_light(const Placed& placed, MeshBuilder& builder);
  void place_instance(const Placed& placed);
  std::uint32_t mesh_index(const Placed& placed);
  void add_emitters(const TriangleMesh& mesh, std::size_t first_triangle, std::uint32_t first_surface,
                    std::uint32_t instance, const Matrix44d& map);
  void add_emitter(const Emitter& emitter, const TriangleId& id);

  const CompileSettings& settings_;
  const CompiledScene* before_;
  grf::Diagnostics& diagnostics_;
  EffectSet effects_;
  SceneStats stats_;
  ReflectorSetBuilder reflectors_;
  TextureSetBuilder textures_;
  SurfaceSetBuilder surfaces_;
  std::vector<Placed> placed_;
  Geometry geometry_;
  std::vector<Emitter> emitters_;
  /// Keyed by mesh and by which of its surfaces emit: a mesh light can be black in one scope and not in
  /// another.
  std::map<std::pair<const Mesh*, std::vector<bool>>, std::uint32_t> index_of_mesh_;
  grf::Box3d local_bounds_;
};

bool Compiler::has_room() {
  if (!stats_.is_too_large()) return true;
  diagnostics_.error(
      {}, fmt::format(
              "the scene is too large: the limits are {} million triangles, {} million vertices, {} million "
              "surfaces and {} million instances",
              SceneStats::MostTriangles / 1'000'000, SceneStats::MostVertices / 1'000'000,
              SceneStats::MostSurfaces / 1'000'000, SceneStats::MostInstances / 1'000'000));
  return false;
}

Matrix44d Compiler::to_scene(const Placement& placement) const {
  return placement.to_world * Matrix44d().setTranslation(-geometry_.origin);
}

void Compiler::list(const Mesh& mesh, const Placement& placement, const grf::Block& block) {
  const Vec3f axis = stats_.is_instanced(mesh) ? Vec3f(0, 1, 0) : axis_of(placement.to_world);
  placed_.push_back(
      {&mesh, nullptr, surfaces_.add(mesh, placement.scope, axis), to_scene(placement), &block});
}

void Compiler::list(const grf::Scene& scene) {
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const grf::Block& block) {
    list(mesh, placement, block);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const Placement& placement, const grf::Block& block) {
    const Mesh& mesh = *light.mesh;
    placed_.push_back(
        {&mesh, nullptr, surfaces_.add_light(mesh, placement.scope), to_scene(placement), &block});
  };
  visitor.light = [&](const AreaLight& light, const Placement& placement, const grf::Block& block) {
    const std::uint32_t surface = surfaces_.add_light(light.radiance.value_or(Colour(1)));
    placed_.push_back({nullptr, &light, surface, to_scene(placement), &block});
  };
  grf::visit(scene, visitor);
}

MeshSize Compiler::size_of_first_mesh() const {
  MeshSize size;
  for (const Placed& placed : placed_) {
    if (placed.mesh == nullptr) {
      size.vertices += 4;
      size.triangles += 2;
    } else if (!stats_.is_instanced(*placed.mesh)) {
      size.add(*placed.mesh, stats_.vertices_of(*placed.mesh),
               surfaces_.needs_uvs(*placed.mesh, placed.first_surface), effects_);
    }
  }
  return size;
}

void Compiler::build() {
  MeshBuilder builder(size_of_first_mesh());
  geometry_.meshes.emplace_back();
  geometry_.instances.emplace_back(Matrix44d());
  std::uint32_t area_lights = 0;
  std::uint32_t meshes = 0;
  for (const Placed& placed : placed_) {
    const bool is_area_light = placed.mesh == nullptr;
    const std::uint32_t number = is_area_light ? area_lights++ : meshes++;
    const auto first_emitter = static_cast<std::uint32_t>(emitters_.size());
    place(placed, builder);
    if (emitters_.size() == first_emitter) continue;
    const std::string name = is_area_light ? std::string() : placed.mesh->name;
    geometry_.lamps.push_back({first_emitter, name, is_area_light, number, placed.block->location});
  }
  for (const Vec3f& position : builder.mesh().positions) local_bounds_.extendBy(Vec3d(position));
  geometry_.meshes[0] = builder.finish();
  if (!local_bounds_.isEmpty()) {
    geometry_.bounds = {local_bounds_.min + geometry_.origin, local_bounds_.max + geometry_.origin};
  }
  placed_ = {};
}

void Compiler::place(const Placed& placed, MeshBuilder& builder) {
  if (placed.mesh == nullptr) return place_light(placed, builder);
  if (stats_.is_instanced(*placed.mesh)) return place_instance(placed);
  const std::size_t first_triangle = builder.mesh().triangles.size();
  builder.add(*placed.mesh, stats_.vertices_of(*placed.mesh), placed.to_scene,
              surfaces_.of(*placed.mesh, placed.first_surface), placed.first_surface);
  add_emitters(builder.mesh(), first_triangle, 0, 0, Matrix44d());
}

void Compiler::place_light(const Placed& placed, MeshBuilder& builder) {
  const AreaLight& light = *placed.light;
  const Matrix44d& map = placed.to_scene;
  Emitter emitter{Vec3f(Vec3d(light.corner) * map), transformed_edge(light.edge1, map),
                  transformed_edge(light.edge2, map), false, surfaces_[placed.first_surface].emission};
  if (mirrors(map)) std::swap(emitter.edge1, emitter.edge2);
  const auto first_triangle = static_cast<std::uint32_t>(builder.mesh().triangles.size());
  builder.add(emitter, placed.first_surface);
  if (reflectance::is_black(emitter.radiance)) return;
  add_emitter(emitter, {0, first_triangle});
  geometry_.emitter_table.push_back(geometry_.emitter_table.back());  // of its second triangle
}

std::uint32_t Compiler::mesh_index(const Placed& placed) {
  const Mesh& mesh = *placed.mesh;
  std::vector<bool> emits;
  for (const CompiledSurface& surface : surfaces_.of(mesh, placed.first_surface)) {
    emits.push_back(!reflectance::is_black(surface.emission));
  }
  const auto [known, is_new] = index_of_mesh_.try_emplace(
      {&mesh, std::move(emits)}, static_cast<std::uint32_t>(geometry_.meshes.size()));
  if (!is_new) return known->second;
  MeshSize size;
  // Another instance may have a texture where this one has none.
  const UsedVertices& used = stats_.vertices_of(mesh);
  size.add(mesh, used, true, effects_);
  MeshBuilder builder(size);
  builder.add(mesh, used, Matrix44d(), surfaces_.of(mesh, placed.first_surface), 0);
  geometry_.meshes.push_back(builder.finish());
  return known->second;
}

void Compiler::place_instance(const Placed& placed) {
  Instance instance(placed.to_scene);
  instance.mesh = mesh_index(placed);
  instance.first_surface = placed.first_surface;
  instance.first_emitter = static_cast<std::uint32_t>(geometry_.emitter_table.size());
  const auto index = static_cast<std::uint32_t>(geometry_.instances.size());
  geometry_.instances.push_back(instance);
  const TriangleMesh& mesh = geometry_.meshes[instance.mesh];
  if (!mesh.emitting_runs.empty()) {
    add_emitters(mesh, 0, placed.first_surface, index, placed.to_scene);
  }
  local_bounds_.extendBy(transformed(stats_.box_of(*placed.mesh), placed.to_scene));
}

void Compiler::add_emitters(const TriangleMesh& mesh, std::size_t first_triangle, std::uint32_t first_surface,
                            std::uint32_t instance, const Matrix44d& map) {
  const bool turns = mirrors(map);
  for (std::size_t i = first_triangle; i < mesh.triangles.size(); ++i) {
    const Triangle& triangle = mesh.triangles[i];
    const CompiledSurface& surface = surfaces_[first_surface + triangle.surface];
    if (reflectance::is_black(surface.emission)) continue;
    const float opacity = surface.alpha == InvalidIndex ? surface.opacity.value : 1;
    const Rgb radiance = surface.emission * opacity;
    std::array<Vec3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = Vec3d(mesh.positions[triangle.corners[k]]) * map;
    if (turns) std::swap(corners[1], corners[2]);
    const Emitter emitter{Vec3f(corners[0]), Vec3f(corners[1] - corners[0]), Vec3f(corners[2] - corners[0]),
                          true, radiance};
    add_emitter(emitter, {instance, static_cast<std::uint32_t>(i)});
  }
}

// A degenerate or absent emitter emits nothing, and cannot be hit.
void Compiler::add_emitter(const Emitter& emitter, const TriangleId& id) {
  if (!(emitter.area() > 0) || reflectance::is_black(emitter.radiance)) {
    geometry_.emitter_table.push_back(InvalidIndex);
    return;
  }
  geometry_.emitter_table.push_back(static_cast<std::uint32_t>(emitters_.size()));
  geometry_.emitter_triangles.push_back(id);
  emitters_.push_back(emitter);
}

std::optional<CompiledScene> Compiler::finish() {
  const std::size_t errors_before = diagnostics_.error_count();
  const std::span<const TextureFile> read_before =
      before_ != nullptr ? std::span(before_->textures()) : std::span<const TextureFile>();
  if (is_to_stop()) return std::nullopt;
  std::vector<TextureFile> textures = textures_.build(read_before);
  if (diagnostics_.error_count() > errors_before || is_to_stop()) return std::nullopt;
  ReflectorSet reflectors = reflectors_.build(settings_.stop);
  if (is_to_stop()) return std::nullopt;
  const auto geometry = std::make_shared<const Geometry>(std::move(geometry_));
  return CompiledScene(geometry, caster_of(geometry), surfaces_.take(), surfaces_.take_varying(),
                       std::move(reflectors), std::move(textures), std::move(emitters_));
}

RayCaster Compiler::caster_of(std::shared_ptr<const Geometry> geometry) const {
  if (before_ != nullptr && before_->caster().serves(*geometry)) return before_->caster();
  return RayCaster(std::move(geometry));
}

}  // namespace

std::size_t most_copied_triangles(const CompileSettings& settings) {
  return settings.effects.has(Effect::Instances) ? settings.most_copied_triangles
                                                 : std::numeric_limits<std::size_t>::max();
}

std::optional<CompiledScene> compile(const grf::Scene& scene, grf::Diagnostics& diagnostics,
                                     const CompileSettings& settings, const CompiledScene* before) {
  return compile(grf::Scene(scene), diagnostics, settings, before);  // meshes are shared, not copied
}

std::optional<CompiledScene> compile(grf::Scene&& scene, grf::Diagnostics& diagnostics,
                                     const CompileSettings& settings, const CompiledScene* before) {
  std::optional<CompiledScene> compiled;
  parallel::run_with_threads(settings.threads, [&] {
    const std::size_t errors_before = diagnostics.error_count();
    Compiler compiler(scene, settings, diagnostics, before);
    if (!compiler.has_room()) return;
    compiler.list(scene);
    if (diagnostics.error_count() > errors_before || settings.stop.stop_requested()) return;
    compiler.build();
    scene = {};
    compiled = compiler.finish();
  });
  return compiled;
}

}  // namespace transport
