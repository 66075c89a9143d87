#include "grf/visit.h"

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

void Scope::enter(const Definition& definition) {
  definitions_.push_back(&definition);
  by_name_[definition.name].push_back(&definition);
}

void Scope::leave(std::size_t count) {
  for (; count > 0; --count) {
    const auto meanings = by_name_.find(definitions_.back()->name);
    meanings->second.pop_back();
    if (meanings->second.empty()) by_name_.erase(meanings);
    definitions_.pop_back();
  }
}

const Definition* Scope::find(std::string_view name) const {
  const auto meanings = by_name_.find(name);
  return meanings == by_name_.end() ? nullptr : meanings->second.back();
}

std::vector<std::string> Scope::names() const {
  std::vector<std::string> names;
  names.reserve(by_name_.size());
  for (const auto& entry : by_name_) names.emplace_back(entry.first);
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
  resolved.texture = look_up(surface.texture, scope);
  resolved.emission = surface.emission;
  return resolved;
}

}  // namespace grf
