#include "editor/document/object_edits.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "editor/document/definitions.h"
#include "editor/document/object_placement.h"
#include "editor/document/scene_places.h"

namespace editor {
namespace {

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
  if (grf::ScenePath transform = own_transform(changed, place); !transform.empty())
    place = std::move(transform);
  grf::ScenePath around = place;
  around.pop_back();
  grf::ScenePath copy = place;
  ++copy.back();
  const grf::Block block = *block_at(changed, place);
  auto& blocks = grf::find_blocks(changed, around)->blocks;
  const auto here = std::ranges::find_if(blocks, [original = grf::find(changed, place).block](
                                                     const grf::Block& each) { return &each == original; });
  blocks.insert(here + 1, block)->comments = {};
  translate_block(changed, copy, offset);
  return changed;
}

std::optional<TransformedObjects> make_single(const grf::Scene& scene,
                                              const std::vector<grf::ScenePath>& paths,
                                              grf::Diagnostics& diagnostics) {
  TransformedObjects result{scene, paths};
  for (const grf::ScenePath& path : paths) {
    const auto* block = is_in_include(scene, path) ? nullptr : block_at(scene, path);
    const auto* use = block == nullptr ? nullptr : std::get_if<grf::Use>(&block->content);
    if (use == nullptr) {
      diagnostics.error({}, "only instances outside of included files can become meshes of their own");
      return std::nullopt;
    }
    const std::vector<PlacedDefinition> in_scope = definitions_at(scene, path);
    const auto defined = std::ranges::find_if(
        in_scope, [use](const PlacedDefinition& each) { return each.definition->name == use->mesh.name; });
    if (defined == in_scope.end()) {
      report_missing(diagnostics);
      return std::nullopt;
    }
    if (!keeps_references(scene, {defined->path}, path, diagnostics)) return std::nullopt;
    grf::Shared<grf::Mesh> single = std::get<grf::Shared<grf::Mesh>>(defined->definition->body);
    single.edit().name = use->mesh.name;
    grf::find(result.scene, path).block->content = std::move(single);
  }
  return result;
}

std::optional<TransformedObjects> make_instance(const grf::Scene& scene, const grf::ScenePath& path,
                                                grf::Diagnostics& diagnostics) {
  const grf::Block* block = is_in_include(scene, path) ? nullptr : block_at(scene, path);
  if (block == nullptr || !std::holds_alternative<grf::Shared<grf::Mesh>>(block->content)) {
    diagnostics.error({}, "only meshes outside of included files can become definitions");
    return std::nullopt;
  }
  TransformedObjects result{scene, {path}};
  define_mesh(result.scene, path, result.paths.front());
  return result;
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
