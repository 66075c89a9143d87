// Visitors traverse a scene graph in order, with the transform and the definitions in scope at each block.
#pragma once

#include <algorithm>
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

/// The definitions in scope at a block; inner ones hide outer ones. A cheap view, valid as long as all of
/// these definitions are in the stack that it was taken from.
class Scope {
 public:
  /// Makes an empty scope.
  Scope() = default;

  /// Finds the definition that a name refers to, or returns null.
  const Definition* find(std::string_view name) const;
  /// Finds the body of the definition that a name refers to; null if it is of another kind.
  template <class Body>
  const Body* find(std::string_view name) const {
    const Definition* definition = find(name);
    return definition == nullptr ? nullptr : std::get_if<Body>(&definition->body);
  }
  /// Returns the scope at the definition that a name refers to, in which names in its body are looked up.
  Scope around(std::string_view name) const;
  /// Returns the number of definitions that are in scope or hidden.
  std::size_t depth() const { return depth_; }
  /// Returns the scope of the outermost definitions, at most those of this one.
  Scope outermost(std::size_t depth) const {
    Scope scope = *this;
    scope.depth_ = std::min(depth, depth_);
    return scope;
  }
  /// Returns all names in scope.
  std::vector<std::string> names() const;
  /// Returns the names in scope of definitions of this kind.
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
  /// Returns the visible definition of each name.
  std::vector<const Definition*> definitions() const;
  Scope(const ScopeStack& stack, std::size_t depth) : stack_(&stack), depth_(depth) {}

  const ScopeStack* stack_ = nullptr;
  std::size_t depth_ = 0;  ///< number of the stack's definitions in scope, from the outermost
};

/// The stack of definitions in scope during a traversal.
class ScopeStack {
 public:
  ScopeStack() = default;
  /// Starts with the definitions of a scope.
  explicit ScopeStack(const Scope& outside);
  ScopeStack(const ScopeStack&) = delete;
  ScopeStack& operator=(const ScopeStack&) = delete;
  ScopeStack(ScopeStack&&) = delete;
  ScopeStack& operator=(ScopeStack&&) = delete;
  ~ScopeStack() = default;

  /// Enters the scope of a definition, whose address must be stable until the scope is left.
  void enter(const Definition& definition);
  /// Leaves the scope of the definitions that were entered last.
  void leave(std::size_t count);
  /// Returns the current scope.
  Scope scope() const { return {*this, definitions_.size()}; }

 private:
  friend class Scope;

  std::vector<const Definition*> definitions_;  // the outermost first
  /// Indices of a name's definitions in definitions_.
  std::unordered_map<std::string_view, std::vector<std::size_t>> places_of_name_;
};

/// Where in the world, and in which scope, something visited is.
struct Placement {
  Matrix44d to_world;
  Scope scope;  ///< the scope of the mesh or block: for an instance, that of the definition
  /// The definition that a `use` instances, null for a block in the scene itself.
  const Definition* instance_of = nullptr;
  /// The path of the visited block or definition: for an instance, that of the `use`. Valid until the visitor
  /// returns.
  ScenePathView path = {};
  /// The file of that block or definition, which its file names are relative to. Valid as long as `path`.
  std::string_view file = {};
};

/// Callbacks per kind of block; kinds with an empty callback are skipped. A defined mesh is visited at its
/// definition, and then as a mesh for each instance; the block is that of the `use`.
struct SceneVisitor {
  std::function<void(const Mesh&, const Placement&, const Block&)> mesh;
  std::function<void(const MeshLight&, const Placement&, const Block&)> mesh_light;
  std::function<void(const AreaLight&, const Placement&, const Block&)> light;
  std::function<void(const Definition&, const Placement&)> definition;
  std::function<void(const Transform&, const Placement&, const Block&)> transform;
  std::function<void(const Params&, const Placement&, const Block&)> params;
  std::function<void(const Use&, const Placement&, const Block&)> use;  ///< before the mesh, if there is one
};

/// Visits the blocks of a scene. `path` is the scene's own file, which its includes are relative to.
void visit(const Scene& scene, const SceneVisitor& visitor, const std::string& path = {});

/// Returns the world-space positions of the observers for whom irradiance was computed, in the order of the
/// file.
std::vector<Vec3f> observers_of(const Scene& scene);

/// A surface with its references resolved. Pointers are into the scene; null or absent attributes were not
/// given.
struct ResolvedSurface {
  Colour colour = Colour(1);
  const BrdfModel* brdf = nullptr;
  Scope brdf_scope;  ///< the scope in which the terms of a `combine` are looked up
  const PdfModel* pdf = nullptr;
  const Texture* texture = nullptr;
  std::optional<Colour> emission;
  Opacity opacity;  ///< reads alpha only if there is a texture: without one, alpha is 1
};

ResolvedSurface resolve(const Surface& surface, const Scope& scope);  ///< Looks up what a surface refers to.

/// A BRDF that is no `combine`, and its weight in a sum. The pointer is into the scene.
struct WeightedBrdf {
  const BrdfModel* model = nullptr;
  float weight = 1;
  Scope scope;  ///< in which the names of its layers are looked up
};

/// Flattens a `combine` of nested sums into BRDFs with weights; any other BRDF gives itself. Each BRDF is
/// listed once, in the order of first mention; undefined names are skipped. The scope is that in which the
/// BRDF's own names are looked up. Takes time linear in the number of terms, and no recursion, however long
/// the chain of definitions is.
std::vector<WeightedBrdf> summands_of(const BrdfModel& brdf, const Scope& scope);

/// Returns the BRDF that the i-th term of another one names, with the scope in which its own names are looked
/// up; the model is null if the name is undefined.
WeightedBrdf named_term(const BrdfModel& brdf, std::size_t term, const Scope& scope);

/// Returns copies of the definitions that these names refer to, and of those that their BRDFs name, directly
/// or through others, in the order of the scope: each precedes those that name it. Undefined names are
/// skipped.
std::vector<Definition> definitions_needed(const std::vector<std::string>& names, const Scope& scope);

}  // namespace grf
