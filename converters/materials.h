#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "converters/losses.h"
#include "converters/material_mapping.h"
#include "converters/scene_building.h"

namespace convert {

/// The materials of a file that is being read, which become definitions that its faces refer to.
class Materials {
 public:
  /// Makes names of materials unique by `names`, which must outlive this.
  explicit Materials(DefinitionNames& names) : names_(names) {}

  /// Adds a material and returns its index for `surface`.
  std::size_t add(MappedMaterial material);

  /// Returns the surface of a material for a number of faces, and counts their losses.
  grf::Surface surface(std::size_t material, std::size_t faces, Losses& losses) const;

  /// Warns about clamped values, in one line.
  void report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const;

  /// Returns a definition per material, used or not, in the order of addition.
  std::vector<grf::Definition> definitions() const;

 private:
  DefinitionNames& names_;
  std::vector<MappedMaterial> materials_;
};

}  // namespace convert
