#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/mesh.h"
#include "grf/visit.h"
#include "renderer/transport/effect.h"
#include "renderer/transport/scene/reflector_set.h"
#include "renderer/transport/scene/surface_point.h"
#include "renderer/transport/scene/texture_set.h"

namespace transport {

/// Flags per surface of each mesh: whether it can reflect light to the eye.
using ReflectingSurfaces = std::unordered_map<const grf::Mesh*, std::vector<bool>>;

/// A BRDF that images vary, with its textures: one per map.
struct VaryingSurface {
  std::shared_ptr<const reflectance::VaryingBrdf> brdf;
  std::vector<std::uint32_t> textures;
};

/// Resolves what the surfaces of meshes refer to in the scope of each placement. A mesh that is placed many
/// times has its surfaces once, as long as names resolve to the same there.
class SurfaceSetBuilder {
 public:
  /// Compiles only these effects; surfaces that are not in `reflecting` (null: all are) are black.
  SurfaceSetBuilder(ReflectorSetBuilder& reflectors, TextureSetBuilder& textures, const EffectSet& effects,
                    const ReflectingSurfaces* reflecting)
      : reflectors_(reflectors), textures_(textures), effects_(effects), reflecting_(reflecting) {}

  /// Returns the index of the first surface of a mesh; the others follow in the mesh's order. For `axis` see
  /// CompiledSurface.
  std::uint32_t add(const grf::Mesh& mesh, const grf::Scope& scope, const Vec3f& axis);
  /// Returns the index of the first surface of a mesh light, whose colours are its emission.
  std::uint32_t add_light(const grf::Mesh& mesh, const grf::Scope& scope);
  std::uint32_t add_light(const Rgb& radiance);

  std::span<const CompiledSurface> of(const grf::Mesh& mesh, std::uint32_t first) const {
    return std::span(surfaces_).subspan(first, mesh.surfaces.size());
  }
  const CompiledSurface& operator[](std::size_t index) const { return surfaces_[index]; }
  bool needs_uvs(const grf::Mesh& mesh, std::uint32_t first) const;
  std::vector<CompiledSurface> take() { return std::move(surfaces_); }
  std::vector<VaryingSurface> take_varying() { return std::move(varying_); }

 private:
  CompiledSurface compiled(const grf::Surface& surface, const grf::Scope& scope, const Vec3f& axis,
                           bool reflects);
  std::uint32_t varying_of(std::uint32_t reflector);
  bool reflects(const grf::Mesh& mesh, std::size_t surface) const;
  Rgb emitted(const Rgb& radiance) const { return effects_.has(Effect::AreaLights) ? radiance : Rgb(0); }
  std::uint32_t index_of(const grf::Mesh& mesh, const std::vector<CompiledSurface>& surfaces);

  ReflectorSetBuilder& reflectors_;
  TextureSetBuilder& textures_;
  EffectSet effects_;
  const ReflectingSurfaces* reflecting_;
  std::vector<CompiledSurface> surfaces_;
  std::vector<VaryingSurface> varying_;
  std::map<std::uint32_t, std::uint32_t> varying_of_reflector_;
  std::unordered_map<const grf::Mesh*, std::vector<bool>> used_;
  std::unordered_multimap<const grf::Mesh*, std::uint32_t> first_of_mesh_;
};

}  // namespace transport
