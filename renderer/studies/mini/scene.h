#pragma once

#include <optional>

#include "grf/scene.h"
#include "renderer/options/render_options.h"
#include "renderer/reflectance/model.h"
#include "renderer/studies/study.h"

namespace studies {

/// The settings of the tool `minibpt`.
struct MiniRenderSettings {
  enum Shape { Sphere, Plane, Jug, Dragon, Knot, Model };
  enum Compare { Nothing, Brdfs, Schemes };

  float viewer_x = 0;
  float viewer_y = 2.1F;
  float viewer_z = 4.6F;
  float vlook_x = 0;
  float vlook_y = 0.9F;
  float vlook_z = 0;
  int shape = Sphere;
  bool replace = false;
  int compare = Nothing;
  float samples = 64;
  float width = 500;
  float depth = 5;
  float seed = 0;

  static reflectance::ModelTable<MiniRenderSettings> table();
};

/// A scene in memory with the options of its render.
struct MiniScene {
  grf::Scene scene;                ///< with absolute file names
  options::RenderOptions options;  ///< those of the opened OP file, or defaults
  bool is_opened = false;          ///< it was read from a file, and has BRDFs of its own
};

/// Reads the scene that a state names with its options and environment map, or makes a floor with a shape or
/// a model under an area light. Returns nothing after an error.
std::optional<MiniScene> mini_scene(const ToolState& state, const MiniRenderSettings& settings,
                                    const StudyContext& context, grf::Diagnostics& diagnostics);

/// Assigns a BRDF and a sampling scheme to the shape, or to all faces of an opened scene that do not emit.
/// The definitions are those that the terms of the BRDF refer to.
void assign(const grf::BrdfModel& brdf, const grf::PdfModel& pdf,
            const std::vector<grf::Definition>& definitions, MiniScene& scene);

/// Returns the model that stands on the floor; null if there is none.
const ToolState::File* model_of(const ToolState& state);

/// Shows the last opened file of each kind: a scene with its options, by default the OP file beside it, an
/// environment map, or a model as the shape. Sets the viewer, the look-at point and the size of the image
/// from the options.
void show_opened_files(ToolState& state, grf::Diagnostics& diagnostics);

}  // namespace studies
