// The materials of a scene are decided here for both renderers: which BRDFs they have themselves, and which
// are tabulated.
#pragma once

#include <optional>
#include <string>

#include "converters/losses.h"
#include "converters/renderers/render_scene.h"
#include "converters/renderers/scene_folder.h"
#include "renderer/reflectance/rgl_writer.h"

namespace convert {

/// GGX facets without light between them, as pbrt's `conductor` has them.
struct ConductorFacets {
  double alpha = 0;
  double real_index = 1;
  double imaginary_index = 0;
};

/// A material as a renderer has it: (1 - share) base + share mirror.
struct WrittenMaterial {
  enum class Base { Black, Diffuse, Conductor, Measured, Glass };

  Base base = Base::Black;
  grf::Colour reflectance = grf::Colour(0);  ///< of a diffuse base, without image and colours of vertices
  std::string image;                         ///< of a diffuse base, instead of its reflectance; may be empty
  bool has_vertex_colours = false;           ///< of a diffuse base: they contain its reflectance
  ConductorFacets facets;
  double index = 1.5;                        ///< of glass
  bool is_pane = false;                      ///< of glass: it does not bend light
  grf::Colour pane_colour = grf::Colour(1);  ///< what is left of light that crosses a pane along its normal
  std::string table;                         ///< of a measured base: the name of the file for the scene
  double table_error = 0;  ///< mean error of its interpolation, as a fraction of the mean value
  bool is_anisotropic = false;
  double mirror_share = 0;              ///< 0 to 1
  grf::Colour mirror = grf::Colour(0);  ///< the reflectance of the mirror, 0 to 1
};

/// The materials that a renderer has, and the tables that it reads.
struct MaterialTarget {
  reflectance::RglColours colours = reflectance::RglColours::LinearSrgb;  ///< of tables
  bool has_ggx_conductor = false;  ///< with height-correlated shadowing, as that of `ggx`
  bool has_pane_colour = false;    ///< of what a pane lets through
};

/// The share of a mirror in a material, its reflectance, and whether that depends on the angle.
struct MirrorPart {
  double share = 0;
  grf::Colour reflectance = grf::Colour(0);
  bool varies = false;
};

/// Returns the mirror that stands for the specular (delta) part of a BRDF times a colour: of the same
/// reflectance if that is the same at all angles, else of its mean over the hemisphere, weighted by the
/// cosine.
MirrorPart mirror_of(const reflectance::Brdf& brdf, const grf::Colour& colour);

/// Writes the files of a material and returns it; nothing after an error. Counts what is lost.
std::optional<WrittenMaterial> write_material(const RenderMaterial& material, const MaterialTarget& target,
                                              SceneFolder& folder, Losses& losses,
                                              grf::Diagnostics& diagnostics);

}  // namespace convert
