#include "renderer/transport/scene/surface_set.h"

#include <algorithm>

namespace transport {
namespace {

TextureContent content_of(grf::ImageChannel channel) {
  if (channel == grf::ImageChannel::Rgb) return TextureContent::WithAlpha;
  return channel == grf::ImageChannel::Alpha ? TextureContent::AlphaAsData : TextureContent::Data;
}

}  // namespace

CompiledSurface SurfaceSetBuilder::compiled(const grf::Surface& surface, const grf::Scope& scope,
                                            const Vec3f& axis, bool reflects) {
  grf::ResolvedSurface resolved = resolve(surface, scope);
  CompiledSurface result;
  result.colour = resolved.colour;
  result.emission = emitted(resolved.emission.value_or(Rgb(0)));
  if (effects_.has(Effect::Opacity)) {
    result.opacity = resolved.opacity;
    if (result.opacity.reads_alpha()) {
      result.alpha = textures_.index_of(*resolved.texture, TextureContent::WithAlpha);
    }
  }
  // An emitter without a BRDF reflects nothing; any other face without one is diffuse.
  if (!reflects || (resolved.brdf == nullptr && resolved.emission)) return result;
  if (!effects_.has(Effect::MeasuredData) && reflectors_.reads_data(resolved)) {
    resolved.brdf = nullptr;
    resolved.pdf = nullptr;
  }
  result.reflector = reflectors_.index_of(resolved);
  if (effects_.has(Effect::Transmission)) {
    const reflectance::Glass* glass = reflectors_.glass(result.reflector);
    result.is_glass = glass != nullptr;
    result.is_pane = glass != nullptr && glass->thin;
  }
  const bool has_texture = resolved.texture != nullptr && effects_.has(Effect::Textures);
  if (has_texture) {
    result.texture = result.alpha != InvalidIndex
                         ? result.alpha
                         : textures_.index_of(*resolved.texture, TextureContent::OverBlack);
  }
  if (effects_.has(Effect::Textures)) result.varying = varying_of(result.reflector);
  result.is_anisotropic = effects_.has(Effect::Anisotropy) && reflectors_.is_anisotropic(result.reflector);
  result.interreflects =
      effects_.has(reflectors_.is_diffuse(result.reflector) ? Effect::DiffuseInterreflection
                                                            : Effect::GlossyInterreflection);
  if (result.is_anisotropic) result.axis = axis;
  return result;
}

std::uint32_t SurfaceSetBuilder::varying_of(std::uint32_t reflector) {
  auto brdf = reflectors_.varying(reflector);
  if (brdf == nullptr) return InvalidIndex;
  const auto [known, is_new] =
      varying_of_reflector_.try_emplace(reflector, static_cast<std::uint32_t>(varying_.size()));
  if (!is_new) return known->second;
  VaryingSurface& varying = varying_.emplace_back(VaryingSurface{std::move(brdf), {}});
  for (const reflectance::VaryingBrdf::Map& map : varying.brdf->maps()) {
    varying.textures.push_back(textures_.index_of(map.path, map.location, content_of(map.channel)));
  }
  return known->second;
}

bool SurfaceSetBuilder::reflects(const grf::Mesh& mesh, std::size_t surface) const {
  if (reflecting_ == nullptr) return true;
  const auto found = reflecting_->find(&mesh);
  return found != reflecting_->end() && found->second[surface];
}

std::uint32_t SurfaceSetBuilder::add(const grf::Mesh& mesh, const grf::Scope& scope, const Vec3f& axis) {
  const auto [used, is_new] = used_.try_emplace(&mesh);
  if (is_new) used->second = used_surfaces(mesh);
  std::vector<CompiledSurface> surfaces(mesh.surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (used->second[i]) surfaces[i] = compiled(mesh.surfaces[i], scope, axis, reflects(mesh, i));
  }
  return index_of(mesh, surfaces);
}

std::uint32_t SurfaceSetBuilder::add_light(const grf::Mesh& mesh, const grf::Scope& scope) {
  std::vector<CompiledSurface> surfaces(mesh.surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    surfaces[i].emission = emitted(resolve(mesh.surfaces[i], scope).colour);
  }
  return index_of(mesh, surfaces);
}

std::uint32_t SurfaceSetBuilder::add_light(const Rgb& radiance) {
  CompiledSurface surface;
  surface.emission = emitted(radiance);
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
    return surface.texture != InvalidIndex || surface.alpha != InvalidIndex ||
           surface.varying != InvalidIndex || surface.is_anisotropic;
  });
}

}  // namespace transport
