// Computes the light of shaders/brdf.frag on the CPU, for drivers that cannot compile its shader.
#pragma once

#include <cstddef>

#include "editor/view/g_buffer.h"
#include "editor/view/scene_environment.h"
#include "editor/view/surface_tables.h"
#include "editor/view/view_camera.h"

namespace editor {

/// Shades the surfaces of one BRDF model on the CPU.
struct CpuShading {
  std::size_t model = 0;  ///< its number in the tables
  int samples = 8;        ///< number of sky directions
  int first_sample = 0;
  ViewCamera camera;
  double aspect = 1;
  const SceneEnvironment* environment = nullptr;  ///< has a map; null: the studio
};

/// The headlight of the studio: the radiance that it adds, over the BRDF's value for u = v.
constexpr float StudioHeadlight = 1.6F;

/// Adds the light to rows of a G-buffer, whose other values are complete.
void add_cpu_shading(const CpuShading& light, const FaceTables& faces, const SurfaceTables& surfaces,
                     GBuffer& g_buffer, int first_row, int rows);

}  // namespace editor
