// Visits the names by which BRDFs and surfaces refer to definitions.
#pragma once

#include <variant>

#include "grf/surface.h"

namespace editor {

/// Calls an action for the name in each term of a BRDF; that of a mutable one may be changed.
template <class Brdf, class Action>
void for_each_term(Brdf& brdf, const Action& action) {
  for (auto& term : brdf.terms) action(term.brdf);
}

/// Calls an action for each name by which a surface refers to a definition, also in terms of its BRDF.
template <class Surface, class Action>
void for_each_reference_of_surface(Surface& surface, const Action& action) {
  const auto of = [&action](auto& attribute) {
    if (!attribute) return;
    if (auto* reference = std::get_if<grf::Reference>(&*attribute)) action(*reference);
  };
  of(surface.colour);
  of(surface.brdf);
  of(surface.pdf);
  of(surface.texture);
  if (!surface.brdf) return;
  if (auto* brdf = std::get_if<grf::BrdfModel>(&*surface.brdf)) for_each_term(*brdf, action);
}

}  // namespace editor
