#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "converters/losses.h"
#include "converters/material_mapping.h"
#include "converters/scene_parts.h"

namespace convert {

/// The materials of a file that is being read: definitions for its faces to refer to.
class Materials {
 public:
  /// Materials of one name get names of their own from `names`, which outlives this.
  explicit Materials(DefinitionNames& names) : names_(names) {}

  /// The index under which `surface` knows the material.
  std::size_t add(MappedMaterial material);

  /// The surface of so many faces with the material, whose losses are counted.
  grf::Surface surface(std::size_t material, std::size_t faces, Losses& losses) const;

  /// Warns of values that were clamped, in one line.
  void report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const;

  /// A definition for each material, whether or not a face has it, in the order in which they came.
  std::vector<grf::Definition> definitions() const;

 private:
  DefinitionNames& names_;
  std::vector<MappedMaterial> materials_;
};

}  // namespace convert
