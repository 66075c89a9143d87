// C++ computes the light of shaders/brdf.frag where the graphics driver refuses a shader.
#pragma once

#include <cstddef>

#include "editor/view/g_buffer.h"
#include "editor/view/surface_tables.h"
#include "editor/view/view_camera.h"

namespace editor {

/// The light that the surfaces of one BRDF model reflect.
struct LightByCpp {
  std::size_t model = 0;  ///< its number in the tables
  int samples = 8;        ///< directions to the sky
  int first_sample = 0;
  ViewCamera camera;
  double aspect = 1;
};

/// Adds it to some rows of a G-buffer, of which all besides light is there.
void add_light_by_cpp(const LightByCpp& light, const FaceTables& faces, const SurfaceTables& surfaces,
                      GBuffer& g_buffer, int first_row, int rows);

}  // namespace editor
