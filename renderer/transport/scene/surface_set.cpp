#include "renderer/transport/scene/surface_set.h"

#include <algorithm>

namespace transport {

CompiledSurface SurfaceSetBuilder::compiled(const grf::Surface& surface, const grf::Scope& scope,
                                            const Vec3f& axis) {
  const grf::ResolvedSurface resolved = resolve(surface, scope);
  CompiledSurface result;
  result.colour = resolved.colour;
  result.emission = resolved.emission.value_or(Rgb(0));
  // An emitter without a BRDF reflects nothing; any other face without one is diffuse.
  if (resolved.brdf == nullptr && resolved.emission) return result;
  result.reflector = reflectors_.index_of(resolved);
  if (resolved.texture != nullptr) result.texture = textures_.index_of(*resolved.texture);
  result.is_anisotropic = reflectors_.is_anisotropic(result.reflector);
  if (result.is_anisotropic) result.axis = axis;
  return result;
}

std::uint32_t SurfaceSetBuilder::add(const grf::Mesh& mesh, const grf::Scope& scope, const Vec3f& axis) {
  const auto [used, is_new] = used_.try_emplace(&mesh);
  if (is_new) used->second = used_surfaces(mesh);
  std::vector<CompiledSurface> surfaces(mesh.surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (used->second[i]) surfaces[i] = compiled(mesh.surfaces[i], scope, axis);
  }
  return index_of(mesh, surfaces);
}

std::uint32_t SurfaceSetBuilder::add_light(const grf::Mesh& mesh, const grf::Scope& scope) {
  std::vector<CompiledSurface> surfaces(mesh.surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    surfaces[i].emission = resolve(mesh.surfaces[i], scope).colour;
  }
  return index_of(mesh, surfaces);
}

std::uint32_t SurfaceSetBuilder::add_light(const Rgb& radiance) {
  CompiledSurface surface;
  surface.emission = radiance;
  surfaces_.push_back(surface);
  return static_cast<std::uint32_t>(surfaces_.size() - 1);
}

std::uint32_t SurfaceSetBuilder::index_of(const grf::Mesh& mesh,
                                          const std::vector<CompiledSurface>& surfaces) {
  const auto [begin, end] = first_of_mesh_.equal_range(&mesh);
  for (auto known = begin; known != end; ++known) {
    if (std::ranges::equal(of(mesh, known->second), surfaces)) return known->second;
  }
  const auto first = static_cast<std::uint32_t>(surfaces_.size());
  surfaces_.insert(surfaces_.end(), surfaces.begin(), surfaces.end());
  first_of_mesh_.emplace(&mesh, first);
  return first;
}

bool SurfaceSetBuilder::needs_uvs(const grf::Mesh& mesh, std::uint32_t first) const {
  const auto surfaces = of(mesh, first);
  return std::any_of(surfaces.begin(), surfaces.end(), [](const CompiledSurface& surface) {
    return surface.texture != None || surface.is_anisotropic;
  });
}

}  // namespace transport
