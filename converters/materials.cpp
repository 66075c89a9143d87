#include "converters/materials.h"

#include <utility>

#include <fmt/format.h>

#include "converters/wording.h"
#include "grf/keywords.h"

namespace convert {

std::size_t Materials::add(MappedMaterial material) {
  material.definition.name = names_.take(grf::from_identifier(material.definition.name));
  materials_.push_back(std::move(material));
  return materials_.size() - 1;
}

grf::Surface Materials::surface(std::size_t material, std::size_t faces, Losses& losses) const {
  const MappedMaterial& mapped = materials_[material];
  for (const Loss loss : mapped.losses) losses.add(loss, faces);
  grf::Surface surface;
  surface.brdf = grf::Reference{mapped.definition.name, {}};
  if (mapped.colour) surface.colour = *mapped.colour;
  surface.emission = mapped.emission;
  surface.opacity = mapped.opacity;
  if (mapped.texture) surface.texture = *mapped.texture;
  return surface;
}

void Materials::report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const {
  std::vector<std::string> clamped;
  for (const MappedMaterial& material : materials_) {
    if (material.clamped) clamped.push_back(grf::from_identifier(material.definition.name));
  }
  if (clamped.empty()) return;
  diagnostics.warning(
      location, fmt::format("values of materials are out of range, and were clamped ({})", listed(clamped)));
}

std::vector<grf::Definition> Materials::definitions() const {
  std::vector<grf::Definition> definitions;
  for (const MappedMaterial& material : materials_) definitions.push_back(material.definition);
  return definitions;
}

}  // namespace convert
