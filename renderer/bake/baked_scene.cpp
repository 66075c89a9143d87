#include "renderer/bake/baked_scene.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "grf/unique_names.h"
#include "grf/visit.h"

namespace bake {
namespace {

using grf::Block;
using grf::BlockList;
using grf::Definition;
using grf::DefinitionScope;
using grf::Matrix44d;
using grf::Mesh;
using grf::Shared;
using grf::Vec3f;

grf::UniqueNames defined_names(const grf::Scene& scene) {
  grf::UniqueNames names;
  grf::SceneVisitor visitor;
  visitor.definition = [&](const Definition& definition, const grf::Placement&) {
    names.add(definition.name);
  };
  grf::visit(scene, visitor);
  return names;
}

grf::Irradiance value_of(const Bake& bake, std::size_t vertex, const Matrix44d& to_mesh) {
  if (bake.settings().directions == 0) return bake.irradiance(vertex);
  std::vector<grf::DirectionalIrradiance> list;
  for (const Vec3f& direction : bake.directions(vertex)) {
    grf::Vec3d in_mesh;
    to_mesh.multDirMatrix(grf::Vec3d(direction), in_mesh);
    list.push_back({Vec3f(in_mesh.normalized()), bake.irradiance(vertex, static_cast<int>(list.size()))});
  }
  return list;
}

/// Visits the blocks in the order of `grf::visit`.
class IrradianceWriter {
 public:
  IrradianceWriter(BakedScene& baked, const ArrivingIrradiance& arriving)
      : baked_(baked), arriving_(arriving), names_(defined_names(baked.scene)) {}

  void write() { write(baked_.scene.contents, Matrix44d()); }

 private:
  /// The baked copies of a definition, over the placements that use it.
  struct Used {
    Definition* definition;
    Definition::Body before = definition->body;
    std::size_t places = 0;
    std::vector<Definition> copies = {};
  };

  void write(BlockList& list, const Matrix44d& to_world) {
    for (Block& block : list.blocks) {
      std::visit([&](auto& content) { write(content, to_world); }, block.content);
    }
  }
  void write(Shared<Mesh>& mesh, const Matrix44d& to_world) { fill(mesh, to_world); }
  void write(grf::MeshLight& light, const Matrix44d&) {
    if (!light.mesh->irradiance->empty()) light.mesh.edit().irradiance = {};
  }
  void write(grf::Transform& transform, const Matrix44d& to_world) {
    write(transform.body, grf::matrix_of(transform.steps) * to_world);
  }
  void write(DefinitionScope& scope, const Matrix44d& to_world);
  void write(grf::Use& use, const Matrix44d& to_world);
  void write(grf::Include& include, const Matrix44d& to_world) {
    const Shared<BlockList> before = include.contents;
    write(include.contents.edit(), to_world);
    if (include.contents == before) include.contents = before;  // and stays shared
  }
  void write(grf::AreaLight&, const Matrix44d&) {}
  void write(grf::Params&, const Matrix44d&) {}

  void fill(Shared<Mesh>& mesh, const Matrix44d& to_world);
  std::string free_name(const std::string& name, std::size_t number);

  BakedScene& baked_;
  const ArrivingIrradiance& arriving_;
  grf::UniqueNames names_;
  /// The meaning of each name, the innermost last.
  std::map<std::string, std::vector<Used>> in_scope_;
};

void IrradianceWriter::fill(Shared<Mesh>& mesh, const Matrix44d& to_world) {
  if (auto irradiance = arriving_(*mesh, to_world)) mesh.edit().irradiance = *std::move(irradiance);
}

std::string IrradianceWriter::free_name(const std::string& name, std::size_t number) {
  return names_.take(fmt::format("{}${}", name, number));
}

void IrradianceWriter::write(grf::Use& use, const Matrix44d& to_world) {
  Used& used = in_scope_.at(use.mesh.name).back();
  auto mesh = std::get<Shared<Mesh>>(used.before);
  fill(mesh, to_world);
  auto& of_first_place = std::get<Shared<Mesh>>(used.definition->body);
  if (++used.places == 1) {
    of_first_place = std::move(mesh);
  } else if (!(mesh == of_first_place)) {
    use.mesh.name = free_name(use.mesh.name, used.places);
    used.copies.push_back({use.mesh.name, std::move(mesh), {}, used.definition->location});
  }
}

void IrradianceWriter::write(DefinitionScope& scope, const Matrix44d& to_world) {
  for (Definition& definition : scope.definitions) in_scope_[definition.name].push_back({&definition});
  write(scope.body, to_world);
  std::vector<Definition> definitions;
  for (Definition& definition : scope.definitions) {
    std::vector<Used>& meanings = in_scope_.at(definition.name);
    Used used = std::move(meanings.back());
    meanings.pop_back();
    baked_.shared_meshes += used.copies.empty() ? 0 : 1;
    baked_.copies += used.copies.size();
    definitions.push_back(std::move(definition));
    std::move(used.copies.begin(), used.copies.end(), std::back_inserter(definitions));
  }
  scope.definitions = std::move(definitions);
}

}  // namespace

BakedScene with_irradiance(grf::Scene scene, const ArrivingIrradiance& arriving) {
  BakedScene baked;
  baked.scene = std::move(scene);
  IrradianceWriter(baked, arriving).write();
  return baked;
}

BakedScene with_irradiance(grf::Scene scene, const Bake& bake) {
  std::size_t next = 0;  // vertex of the bake, in the order of the visit
  BakedScene baked = with_irradiance(std::move(scene), [&](const Mesh& mesh, const Matrix44d& to_world) {
    const Matrix44d to_mesh = to_world.inverse();
    grf::VertexIrradiance irradiance;
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i, ++next) {
      if (bake.has_value(next)) irradiance.set(i, value_of(bake, next, to_mesh));
    }
    return std::optional(std::move(irradiance));
  });
  assert(next == bake.vertex_count());
  return baked;
}

bool has_few_copies(const grf::Scene& scene, grf::Diagnostics& diagnostics, std::size_t most_vertices) {
  std::map<const Definition*, std::size_t> places;
  const Definition* largest = nullptr;
  std::size_t vertices = 0;
  std::size_t most = 0;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const grf::Placement& placement, const Block&) {
    if (placement.instance_of == nullptr || ++places[placement.instance_of] == 1) return;
    vertices += mesh.geometry->positions.size();
    const std::size_t of_mesh = (places[placement.instance_of] - 1) * mesh.geometry->positions.size();
    if (of_mesh > most) largest = placement.instance_of;
    most = std::max(most, of_mesh);
  };
  grf::visit(scene, visitor);
  if (vertices <= most_vertices) return true;
  diagnostics.error(
      largest->location,
      fmt::format(
          "each placement of a mesh has its own irradiance, so copies with {} vertices would be written, "
          "more than {}: 'use' '{}', which is placed {} times, less often",
          vertices, most_vertices, largest->name, places[largest]));
  return false;
}

}  // namespace bake
