// The plan of a render for the editor: which effects the scene calls for, and by which faces and lamps.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"
#include "editor/rendering/final_render.h"
#include "grf/diagnostics.h"
#include "grf/scene_path.h"
#include "renderer/plan/plan.h"

namespace editor {

/// A scene with absolute file names, and the plan of its render, which points into the scene.
struct PlannedScene {
  std::unique_ptr<const grf::Scene> scene;
  plan::Plan plan;
};

/// Plans a render as `bpt plan` does, without files of measured data or textures; nothing after an error.
std::optional<PlannedScene> planned_scene(const FinalRenderRequest& request, grf::Diagnostics& diagnostics);

/// An effect of the plan.
struct EffectRow {
  transport::Effect effect = {};
  bool is_needed = false;
  bool is_on = false;                  ///< by BPT_Only and BPT_Without
  QString why;                         ///< a sentence without its full stop
  FaceSelection faces;                 ///< that call for it
  std::vector<grf::ScenePath> lights;  ///< area lights that call for it
};

struct EffectPlan {
  std::vector<EffectRow> rows;  ///< in the order of transport::EffectInfos; empty after an error
  QString problem;
};

/// Plans a render of the scene that these are the objects of.
EffectPlan effect_plan(const FinalRenderRequest& request, const SceneObjects& objects);

/// Switches an effect on or off by BPT_Only and BPT_Without. Other effects stay as they are: names of groups
/// are replaced by those of their effects where necessary.
void switch_effect(options::RenderOptions& render_options, transport::Effect effect, bool is_on);

}  // namespace editor
