// Walks the blocks of a scene in order, with the transform and the definitions that are in force at each.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "grf/math.h"
#include "grf/scene.h"

namespace grf {

/// The definitions in force at a place of a scene; inner ones hide outer ones.
class Scope {
 public:
  /// The definition must stay where it is until its scope is left.
  void enter(const Definition& definition);
  /// Leaves the scope of the definitions that were entered last.
  void leave(std::size_t count);
  /// The definition that the name means here, or null.
  const Definition* find(std::string_view name) const;
  /// What the name means if it is a definition of this kind, else null.
  template <class Body>
  const Body* find(std::string_view name) const {
    const Definition* definition = find(name);
    return definition == nullptr ? nullptr : std::get_if<Body>(&definition->body);
  }
  /// All names that can be used here.
  std::vector<std::string> names() const;
  /// Those that mean a definition of this kind.
  template <class Body>
  std::vector<std::string> names_of() const {
    std::vector<std::string> names;
    for (const auto& [name, meanings] : by_name_) {
      if (std::holds_alternative<Body>(meanings.back()->body)) names.emplace_back(name);
    }
    return names;
  }

 private:
  std::vector<const Definition*> definitions_;                                    // outermost first
  std::unordered_map<std::string_view, std::vector<const Definition*>> by_name_;  // the same, by their names
};

struct Placement {
  Matrix44d to_world;
  const Scope* scope = nullptr;
};

/// What to do with each kind of thing; those that are left empty are passed over.
struct SceneVisitor {
  std::function<void(const Mesh&, const Placement&, const Block&)> mesh;
  std::function<void(const AreaLight&, const Placement&, const Block&)> light;
  std::function<void(const Definition&, const Placement&)> definition;
  std::function<void(const Transform&, const Placement&, const Block&)> transform;
};

void visit(const Scene& scene, const SceneVisitor& visitor);

/// A surface with its references looked up. The pointers are into the scene; what is
/// null or absent was not given.
struct ResolvedSurface {
  Colour colour = Colour(1);
  const BrdfModel* brdf = nullptr;
  const PdfModel* pdf = nullptr;
  const Texture* texture = nullptr;
  std::optional<Colour> emission;
};

ResolvedSurface resolve(const Surface& surface, const Scope& scope);

}  // namespace grf
