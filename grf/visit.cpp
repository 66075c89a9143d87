#include "grf/visit.h"

#include <algorithm>

namespace grf {
namespace {

class Walk {
 public:
  explicit Walk(const SceneVisitor& visitor) : visitor_(visitor) {}

  void blocks(const BlockList& list, const Matrix44d& to_world) {
    for (const Block& block : list.blocks) {
      const Placement placement{to_world, &scope_};
      std::visit([&](const auto& content) { enter(content, placement, block); }, block.content);
    }
  }

 private:
  void enter(const Shared<Mesh>& mesh, const Placement& placement, const Block& block) {
    if (visitor_.mesh) visitor_.mesh(*mesh, placement, block);
  }
  void enter(const AreaLight& light, const Placement& placement, const Block& block) {
    if (visitor_.light) visitor_.light(light, placement, block);
  }
  void enter(const Include& include, const Placement& placement, const Block&) {
    blocks(*include.contents, placement.to_world);
  }
  void enter(const Transform& transform, const Placement& placement, const Block& block) {
    if (visitor_.transform) visitor_.transform(transform, placement, block);
    blocks(transform.body, matrix_of(transform.steps) * placement.to_world);
  }
  void enter(const DefinitionScope& definitions, const Placement& placement, const Block&) {
    for (const Definition& definition : definitions.definitions) {
      if (visitor_.definition) visitor_.definition(definition, placement);
      scope_.enter(definition);
    }
    blocks(definitions.body, placement.to_world);
    scope_.leave(definitions.definitions.size());
  }

  const SceneVisitor& visitor_;
  Scope scope_;
};

template <class Model>
const Model* look_up(const std::optional<std::variant<Model, Reference>>& attribute, const Scope& scope) {
  if (!attribute) return nullptr;
  if (const auto* reference = std::get_if<Reference>(&*attribute)) return scope.find<Model>(reference->name);
  return std::get_if<Model>(&*attribute);
}

}  // namespace

const Definition* Scope::find(std::string_view name) const {
  const auto found = std::find_if(definitions_.rbegin(), definitions_.rend(),
                                  [name](const Definition* definition) { return definition->name == name; });
  return found == definitions_.rend() ? nullptr : *found;
}

std::vector<std::string> Scope::names() const {
  std::vector<std::string> names;
  for (const Definition* definition : definitions_) names.push_back(definition->name);
  return names;
}

void visit(const Scene& scene, const SceneVisitor& visitor) {
  Walk(visitor).blocks(scene.contents, Matrix44d());
}

ResolvedSurface resolve(const Surface& surface, const Scope& scope) {
  ResolvedSurface resolved;
  if (const Colour* colour = look_up(surface.colour, scope)) resolved.colour = *colour;
  resolved.brdf = look_up(surface.brdf, scope);
  resolved.pdf = look_up(surface.pdf, scope);
  if (surface.emission) resolved.emission = *surface.emission;
  return resolved;
}

}  // namespace grf
