#include "grf/visit.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "grf/text_file.h"

namespace grf {
namespace {

class Walk {
 public:
  Walk(const SceneVisitor& visitor, std::string file) : visitor_(visitor), file_(std::move(file)) {}

  /// `before`: the number of definitions before the blocks, in paths.
  void blocks(const BlockList& list, const Matrix44d& to_world, std::size_t before = 0) {
    path_.push_back(static_cast<std::uint32_t>(before));
    for (const Block& block : list.blocks) {
      const Placement placement{to_world, scope_.scope(), nullptr, path_, file_};
      std::visit([&](const auto& content) { enter(content, placement, block); }, block.content);
      ++path_.back();
    }
    path_.pop_back();
  }

 private:
  void enter(const Shared<Mesh>& mesh, const Placement& placement, const Block& block) {
    if (visitor_.mesh) visitor_.mesh(*mesh, placement, block);
  }
  void enter(const MeshLight& light, const Placement& placement, const Block& block) {
    if (visitor_.mesh_light) visitor_.mesh_light(light, placement, block);
  }
  void enter(const AreaLight& light, const Placement& placement, const Block& block) {
    if (visitor_.light) visitor_.light(light, placement, block);
  }
  void enter(const Params& params, const Placement& placement, const Block& block) {
    if (visitor_.params) visitor_.params(params, placement, block);
  }
  void enter(const Use& use, const Placement& placement, const Block& block) {
    if (visitor_.use) visitor_.use(use, placement, block);
    if (!visitor_.mesh) return;
    const std::string& name = use.mesh.name;
    const Definition* definition = placement.scope.find(name);
    const auto* mesh = placement.scope.find<Shared<Mesh>>(name);
    if (mesh != nullptr) {
      visitor_.mesh(**mesh,
                    {placement.to_world, placement.scope.around(name), definition, placement.path, file_},
                    block);
    }
  }
  void enter(const Include& include, const Placement& placement, const Block&) {
    std::string outside = std::exchange(file_, path_beside(file_, include.file));
    blocks(*include.contents, placement.to_world);
    file_ = std::move(outside);
  }
  void enter(const Transform& transform, const Placement& placement, const Block& block) {
    if (visitor_.transform) visitor_.transform(transform, placement, block);
    blocks(transform.body, matrix_of(transform.steps) * placement.to_world);
  }
  void enter(const DefinitionScope& definitions, const Placement& placement, const Block&) {
    path_.push_back(0);
    for (const Definition& definition : definitions.definitions) {
      if (visitor_.definition) {
        visitor_.definition(definition, {placement.to_world, scope_.scope(), nullptr, path_, file_});
      }
      scope_.enter(definition);
      ++path_.back();
    }
    path_.pop_back();
    blocks(definitions.body, placement.to_world, definitions.definitions.size());
    scope_.leave(definitions.definitions.size());
  }

  const SceneVisitor& visitor_;
  ScopeStack scope_;
  ScenePath path_;
  std::string file_;
};

bool is_sum(const BrdfModel& brdf) { return !brdf.terms.empty() && !is_layered(brdf); }

/// Lists the BRDFs that a `combine` names, directly or through others, with the terms of each as indices into
/// the list. Within one sum a definition has one scope, and so one meaning.
class SumOfSums {
 public:
  SumOfSums(const BrdfModel& brdf, const Scope& scope) {
    add(brdf, scope);
    while (!open_.empty()) {
      Open& top = open_.back();
      const Entry& entry = entries_[top.entry];
      if (!is_sum(*entry.model) || top.next_term == entry.model->terms.size()) {
        inner_first_.push_back(top.entry);
        open_.pop_back();
        continue;
      }
      const CombineTerm& term = entry.model->terms[top.next_term++];
      const std::size_t sum = top.entry;  // `add` moves what `top` and `entry` refer to
      const auto* named = entry.scope.find<BrdfModel>(term.brdf.name);
      if (named == nullptr) continue;
      const std::size_t place = add(*named, entry.scope.around(term.brdf.name));
      entries_[sum].terms.push_back({place, term.weight});
    }
  }

  std::vector<WeightedBrdf> weighted() {
    entries_.front().weight = 1;
    for (auto sum = inner_first_.rbegin(); sum != inner_first_.rend(); ++sum) {
      for (const Term& term : entries_[*sum].terms) {
        entries_[term.entry].weight += static_cast<double>(term.weight) * entries_[*sum].weight;
      }
    }
    std::vector<WeightedBrdf> result;
    for (const Entry& entry : entries_) {
      if (is_sum(*entry.model)) continue;
      result.push_back({entry.model, static_cast<float>(entry.weight), entry.scope});
    }
    return result;
  }

 private:
  struct Term {
    std::size_t entry;
    float weight;
  };
  struct Entry {
    const BrdfModel* model;
    Scope scope;
    std::vector<Term> terms;
    double weight = 0;
  };
  /// A sum whose terms are being looked up.
  struct Open {
    std::size_t entry;
    std::size_t next_term = 0;
  };

  std::size_t add(const BrdfModel& model, const Scope& scope) {
    const auto [known, is_new] = places_.emplace(&model, entries_.size());
    if (is_new) {
      entries_.push_back({&model, scope, {}});
      open_.push_back({known->second});
    }
    return known->second;
  }

  std::vector<Entry> entries_;
  std::unordered_map<const BrdfModel*, std::size_t> places_;
  std::vector<Open> open_;                // explicit stack instead of recursion
  std::vector<std::size_t> inner_first_;  // topological order: each after all that it names
};

template <class Model>
const Model* look_up(const std::optional<std::variant<Model, Reference>>& attribute, const Scope& scope) {
  if (!attribute) return nullptr;
  if (const auto* reference = std::get_if<Reference>(&*attribute)) return scope.find<Model>(reference->name);
  return std::get_if<Model>(&*attribute);
}

}  // namespace

const Definition* Scope::find(std::string_view name) const {
  if (stack_ == nullptr) return nullptr;
  const auto places = stack_->places_of_name_.find(name);
  if (places == stack_->places_of_name_.end()) return nullptr;
  const auto first_after = std::lower_bound(places->second.begin(), places->second.end(), depth_);
  return first_after == places->second.begin() ? nullptr : stack_->definitions_[*(first_after - 1)];
}

Scope Scope::around(std::string_view name) const {
  if (find(name) == nullptr) return {};
  const std::vector<std::size_t>& places = stack_->places_of_name_.find(name)->second;
  return {*stack_, *(std::lower_bound(places.begin(), places.end(), depth_) - 1)};
}

std::vector<std::string> Scope::names() const {
  std::vector<std::string> names;
  for (const Definition* definition : definitions()) names.push_back(definition->name);
  return names;
}

std::vector<const Definition*> Scope::definitions() const {
  std::vector<const Definition*> definitions;
  if (stack_ == nullptr) return definitions;
  for (const auto& [name, places] : stack_->places_of_name_) {
    const auto first_after = std::lower_bound(places.begin(), places.end(), depth_);
    if (first_after != places.begin()) definitions.push_back(stack_->definitions_[*(first_after - 1)]);
  }
  return definitions;
}

ScopeStack::ScopeStack(const Scope& outside) {
  for (std::size_t i = 0; i < outside.depth_; ++i) enter(*outside.stack_->definitions_[i]);
}

void ScopeStack::enter(const Definition& definition) {
  places_of_name_[definition.name].push_back(definitions_.size());
  definitions_.push_back(&definition);
}

void ScopeStack::leave(std::size_t count) {
  for (; count > 0; --count) {
    const auto places = places_of_name_.find(definitions_.back()->name);
    places->second.pop_back();
    if (places->second.empty()) places_of_name_.erase(places);
    definitions_.pop_back();
  }
}

void visit(const Scene& scene, const SceneVisitor& visitor, const std::string& path) {
  Walk(visitor, path).blocks(scene.contents, Matrix44d());
}

ResolvedSurface resolve(const Surface& surface, const Scope& scope) {
  ResolvedSurface resolved;
  if (const Colour* colour = look_up(surface.colour, scope)) resolved.colour = *colour;
  resolved.brdf = look_up(surface.brdf, scope);
  const auto* brdf_reference = surface.brdf ? std::get_if<Reference>(&*surface.brdf) : nullptr;
  resolved.brdf_scope = brdf_reference != nullptr ? scope.around(brdf_reference->name) : scope;
  resolved.pdf = look_up(surface.pdf, scope);
  resolved.texture = look_up(surface.texture, scope);
  resolved.emission = surface.emission;
  resolved.opacity = surface.opacity.value_or(Opacity());
  if (resolved.opacity.reads_alpha() && resolved.texture == nullptr) {
    const bool is_mask = resolved.opacity.kind == Opacity::Kind::Mask;
    resolved.opacity = {Opacity::Kind::Number, is_mask ? 1 : resolved.opacity.value};  // alpha is 1
  }
  return resolved;
}

std::vector<WeightedBrdf> summands_of(const BrdfModel& brdf, const Scope& scope) {
  if (!is_sum(brdf)) return {{&brdf, 1, scope}};
  return SumOfSums(brdf, scope).weighted();
}

WeightedBrdf named_term(const BrdfModel& brdf, std::size_t term, const Scope& scope) {
  const std::string& name = brdf.terms[term].brdf.name;
  return {scope.find<BrdfModel>(name), brdf.terms[term].weight, scope.around(name)};
}

// A scope is the first so many definitions of a stack, so that a later definition never names an earlier
// one's namesake: going back from the last, each name is found in the order of the stack.
std::vector<Definition> definitions_needed(const std::vector<std::string>& names, const Scope& scope) {
  std::vector<const Definition*> needed;
  std::set<std::pair<std::size_t, const Definition*>> open;
  const auto add = [&open](const std::string& name, const Scope& at) {
    if (const Definition* found = at.find(name)) open.emplace(at.around(name).depth(), found);
  };
  for (const std::string& name : names) add(name, scope);
  while (!open.empty()) {
    const auto [depth, definition] = *open.rbegin();
    open.erase(std::prev(open.end()));
    needed.push_back(definition);
    const auto* brdf = std::get_if<BrdfModel>(&definition->body);
    if (brdf == nullptr) continue;
    for (const CombineTerm& term : brdf->terms) add(term.brdf.name, scope.outermost(depth));
  }
  std::vector<Definition> copies;
  for (auto one = needed.rbegin(); one != needed.rend(); ++one) copies.push_back(**one);
  return copies;
}

std::vector<Vec3f> observers_of(const Scene& scene) {
  std::vector<Vec3f> observers;
  SceneVisitor visitor;
  visitor.params = [&observers](const Params& params, const Placement& placement, const Block&) {
    for (const Vec3f& view : params.views) observers.emplace_back(Vec3d(view) * placement.to_world);
  };
  visit(scene, visitor);
  return observers;
}

}  // namespace grf
