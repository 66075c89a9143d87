#include "editor/document/object_edits.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "editor/document/definitions.h"
#include "editor/document/scene_places.h"

namespace editor {
namespace {

using Step = grf::TransformStep;

std::optional<grf::Scene> report_missing(grf::Diagnostics& diagnostics) {
  diagnostics.error({}, "there is no object at that place");
  return std::nullopt;
}

/// Removes observers from their `params`; the paths of those that become empty are added to `gone`. Returns
/// false if an observer does not exist.
bool remove_observers(grf::Scene& scene, const std::vector<ObserverObject>& observers,
                      std::vector<grf::ScenePath>& gone) {
  std::map<grf::ScenePath, std::set<std::size_t>> numbers;
  for (const ObserverObject& observer : observers) numbers[observer.path].insert(observer.number);
  for (const auto& [path, of_params] : numbers) {
    auto* params = content_at<grf::Params>(scene, path);
    if (params == nullptr || *of_params.rbegin() >= params->views.size()) return false;
    for (auto number = of_params.rbegin(); number != of_params.rend(); ++number) {
      params->views.erase(params->views.begin() + static_cast<std::ptrdiff_t>(*number));
    }
    if (params->views.empty()) gone.push_back(path);
  }
  return true;
}

/// The transform that moves only this block: the one at the path, or its parent. Null if there is none.
grf::Transform* transform_of(grf::Scene& scene, grf::ScenePath& path) {
  if (auto* own = content_at<grf::Transform>(scene, path)) return own;
  const grf::ScenePath around(path.begin(), path.end() - 1);
  auto* outer = content_at<grf::Transform>(scene, around);
  if (outer == nullptr || outer->body.blocks.size() != 1) return nullptr;
  path = around;
  return outer;
}

grf::Block wrapped(grf::Block block, const grf::Vec3f& offset) {
  grf::Transform transform;
  transform.steps.push_back({Step::Kind::Translation, offset});
  grf::Block wrapping;
  wrapping.location = block.location;
  transform.body.blocks.push_back(std::move(block));
  wrapping.content = std::move(transform);
  return wrapping;
}

/// Converts an offset from world space to the local coordinates of the block at a path.
grf::Vec3f local_offset(const grf::Scene& scene, grf::ScenePathView path, const grf::Vec3d& offset) {
  grf::Vec3d local;
  to_world_at(scene, path).inverse().multDirMatrix(offset, local);
  return grf::Vec3f(local);
}

void move(grf::Scene& scene, grf::ScenePath path, const grf::Vec3d& offset) {
  grf::Transform* transform = transform_of(scene, path);
  const grf::Vec3f local = local_offset(scene, path, offset);
  if (transform == nullptr) {
    grf::Block& block = *grf::find(scene, path).block;
    block = wrapped(std::move(block), local);
  } else if (transform->steps.back().kind == Step::Kind::Translation) {
    transform->steps.back().value += local;
  } else {
    transform->steps.push_back({Step::Kind::Translation, local});
  }
}

/// The first mesh in a block itself, not in a file that it includes; nothing if there is none.
std::optional<grf::ScenePath> first_mesh_in(const grf::Block& block, grf::ScenePath path) {
  if (std::holds_alternative<grf::Shared<grf::Mesh>>(block.content)) return path;
  const auto* transform = std::get_if<grf::Transform>(&block.content);
  const auto* scope = std::get_if<grf::DefinitionScope>(&block.content);
  if (transform == nullptr && scope == nullptr) return std::nullopt;
  const auto& blocks = transform != nullptr ? transform->body.blocks : scope->body.blocks;
  path.push_back(scope == nullptr ? 0 : static_cast<std::uint32_t>(scope->definitions.size()));
  for (const grf::Block& each : blocks) {
    if (auto found = first_mesh_in(each, path)) return found;
    ++path.back();
  }
  return std::nullopt;
}

/// Turns the mesh at a path into a definition that is used there. The other path is updated.
void define_mesh(grf::Scene& scene, const grf::ScenePath& path, grf::ScenePath& other) {
  const DefinitionInsertion insertion = DefinitionInsertion::around(scene, path);
  grf::Block& block = *grf::find(scene, path).block;
  grf::Definition definition;
  definition.location = block.location;
  const auto& mesh = std::get<grf::Shared<grf::Mesh>>(block.content);
  definition.name = fresh_name(scene, mesh->name.empty() ? "mesh" : mesh->name);
  definition.body = mesh;
  block.content = grf::Use{grf::Reference{definition.name, block.location}};
  insertion.apply(scene, std::move(definition));
  other = insertion.shifted(other);
}

}  // namespace

std::optional<grf::Scene> move_object(const grf::Scene& scene, grf::ScenePathView path,
                                      const grf::Vec3d& offset, grf::Diagnostics& diagnostics) {
  if (block_at(scene, path) == nullptr) return report_missing(diagnostics);
  grf::Scene changed = scene;
  move(changed, {path.begin(), path.end()}, offset);
  return changed;
}

std::optional<grf::Scene> remove_objects(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths,
                                         const std::vector<ObserverObject>& observers,
                                         grf::Diagnostics& diagnostics) {
  for (const auto& [definition, uses] : count_uses(scene, paths)) {
    const bool goes = std::ranges::any_of(
        paths, [&scene, used = definition](const auto& path) { return definition_at(scene, path) == used; });
    if (!goes) continue;
    diagnostics.error(definition->location, fmt::format("'{}' is used {}", definition->name,
                                                        uses == 1 ? "once" : fmt::format("{} times", uses)));
    return std::nullopt;
  }
  grf::Scene changed = scene;
  std::vector<grf::ScenePath> gone = paths;
  if (!remove_observers(changed, observers, gone)) return report_missing(diagnostics);
  erase(changed, std::move(gone));
  return changed;
}

std::optional<grf::Scene> duplicate_object(const grf::Scene& scene, grf::ScenePathView path,
                                           const grf::Vec3d& offset, grf::Diagnostics& diagnostics) {
  if (block_at(scene, path) == nullptr) return report_missing(diagnostics);
  grf::Scene changed = scene;
  grf::ScenePath place(path.begin(), path.end());
  while (const auto mesh = first_mesh_in(*block_at(changed, place), place))
    define_mesh(changed, *mesh, place);
  // A transform with a single child is duplicated with it.
  grf::ScenePath moved = place;
  if (transform_of(changed, moved) != nullptr) place = moved;
  grf::ScenePath around = place;
  around.pop_back();
  grf::ScenePath copy = place;
  ++copy.back();
  const grf::Block block = *block_at(changed, place);
  auto& blocks = grf::find_blocks(changed, around)->blocks;
  const auto here = std::ranges::find_if(blocks, [original = grf::find(changed, place).block](
                                                     const grf::Block& each) { return &each == original; });
  blocks.insert(here + 1, block)->comments = {};
  move(changed, copy, offset);
  return changed;
}

std::optional<grf::Scene> rename_object(const grf::Scene& scene, grf::ScenePathView path,
                                        const std::string& name, grf::Diagnostics& diagnostics) {
  if (definition_at(scene, path) != nullptr) return rename_definition(scene, path, name, diagnostics);
  const grf::Block* block = block_at(scene, path);
  if (block == nullptr || !std::holds_alternative<grf::Shared<grf::Mesh>>(block->content)) {
    diagnostics.error(block == nullptr ? grf::SourceLocation() : block->location,
                      "only meshes and definitions have names");
    return std::nullopt;
  }
  if (name.find_first_of("\n\r") != std::string::npos || name.find('\0') != std::string::npos) {
    diagnostics.error(block->location, "a name is one line of text");
    return std::nullopt;
  }
  grf::Scene changed = scene;
  grf::find_mesh(changed, path)->edit().name = name;
  return changed;
}

}  // namespace editor
