// Walks the blocks of a scene in order, with the transform and the definitions that are in force at each.
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "grf/math.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace grf {

class ScopeStack;

/// The definitions in force at a place of a scene; inner ones hide outer ones. A light value, good as long as
/// all of these definitions are in the stack that it was taken from.
class Scope {
 public:
  /// Nothing is defined.
  Scope() = default;

  /// The definition that the name means here, or null.
  const Definition* find(std::string_view name) const;
  /// What the name means if it is a definition of this kind, else null.
  template <class Body>
  const Body* find(std::string_view name) const {
    const Definition* definition = find(name);
    return definition == nullptr ? nullptr : std::get_if<Body>(&definition->body);
  }
  /// What is in force where the definition stands that the name means here: names in its body mean those.
  Scope around(std::string_view name) const;
  /// All names that can be used here.
  std::vector<std::string> names() const;
  /// Those that mean a definition of this kind.
  template <class Body>
  std::vector<std::string> names_of() const {
    std::vector<std::string> names;
    for (const Definition* definition : definitions()) {
      if (std::holds_alternative<Body>(definition->body)) names.push_back(definition->name);
    }
    return names;
  }

 private:
  friend class ScopeStack;
  /// What each name means.
  std::vector<const Definition*> definitions() const;
  Scope(const ScopeStack& stack, std::size_t depth) : stack_(&stack), depth_(depth) {}

  const ScopeStack* stack_ = nullptr;
  std::size_t depth_ = 0;  ///< how many of the stack's definitions, from the outermost
};

/// The definitions in force while one walks through a scene.
class ScopeStack {
 public:
  ScopeStack() = default;
  /// Starts with what is in force somewhere.
  explicit ScopeStack(const Scope& outside);
  ScopeStack(const ScopeStack&) = delete;
  ScopeStack& operator=(const ScopeStack&) = delete;
  ScopeStack(ScopeStack&&) = delete;
  ScopeStack& operator=(ScopeStack&&) = delete;
  ~ScopeStack() = default;

  /// The definition must stay where it is until its scope is left.
  void enter(const Definition& definition);
  /// Leaves the scope of the definitions that were entered last.
  void leave(std::size_t count);
  /// What is in force now.
  Scope scope() const { return {*this, definitions_.size()}; }

 private:
  friend class Scope;

  std::vector<const Definition*> definitions_;  // the outermost first
  /// Where in the list of definitions those of a name are.
  std::unordered_map<std::string_view, std::vector<std::size_t>> places_of_name_;
};

struct Placement {
  Matrix44d to_world;
  Scope scope;  ///< where what is placed stands: for a mesh that is used, where it is defined
  /// The definition that a `use` places, null for what stands in the scene itself.
  const Definition* instance_of = nullptr;
  /// Where the block or the definition stands that is met: for a mesh that is used, the `use`. Good until the
  /// visitor returns.
  ScenePathView path = {};
  /// The file in which that block or definition stands, from whose folder it names others. Good as long.
  std::string_view file = {};
};

/// What to do with each kind of thing; those that are left empty are passed over. A mesh that is defined is
/// met at its definition, and then as a mesh wherever it is used; the block is that of the `use`.
struct SceneVisitor {
  std::function<void(const Mesh&, const Placement&, const Block&)> mesh;
  std::function<void(const MeshLight&, const Placement&, const Block&)> mesh_light;
  std::function<void(const AreaLight&, const Placement&, const Block&)> light;
  std::function<void(const Definition&, const Placement&)> definition;
  std::function<void(const Transform&, const Placement&, const Block&)> transform;
  std::function<void(const Params&, const Placement&, const Block&)> params;
  std::function<void(const Use&, const Placement&, const Block&)> use;  ///< before the mesh, if there is one
};

/// `path` is the scene's own file, beside which those are that it includes.
void visit(const Scene& scene, const SceneVisitor& visitor, const std::string& path = {});

/// The places in the world of the observers for whom irradiance was computed, in the order of the file.
std::vector<Vec3f> observers_of(const Scene& scene);

/// A surface with its references looked up. The pointers are into the scene; what is
/// null or absent was not given.
struct ResolvedSurface {
  Colour colour = Colour(1);
  const BrdfModel* brdf = nullptr;
  Scope brdf_scope;  ///< where the terms of a `combine` are looked up
  const PdfModel* pdf = nullptr;
  const Texture* texture = nullptr;
  std::optional<Colour> emission;
};

ResolvedSurface resolve(const Surface& surface, const Scope& scope);

/// A BRDF that is no sum, and its weight in one. The pointer is into the scene.
struct WeightedBrdf {
  const BrdfModel* model = nullptr;
  float weight = 1;

  auto operator<=>(const WeightedBrdf&) const = default;
};

/// The BRDFs that a `combine` adds up, through all sums of sums, or the BRDF itself if it is none. Each one
/// is there once, in the order in which they are named; names that mean no BRDF are left out. The scope is
/// that in which the BRDF's own names are looked up. Takes time in proportion to the terms, and no stack,
/// however long the chain of definitions is.
std::vector<WeightedBrdf> summands_of(const BrdfModel& brdf, const Scope& scope);

}  // namespace grf
