// Final renders of each effect of a scene alone.
#pragma once

#include <string>
#include <vector>

#include "editor/rendering/final_render.h"
#include "grf/diagnostics.h"

namespace editor {

/// One effect of a scene, and the effects with which it is rendered.
struct EffectRender {
  std::string name;               ///< as in renderer/EFFECTS.md
  std::string why;                ///< the scene has it
  std::vector<std::string> only;  ///< the value of BPT_Only
};

/// Plans which effects a scene has, as `bpt plan` does; empty after an error. A source of light (area lights,
/// environment map, background) is rendered alone, any other effect in the light of all these sources,
/// without which it would be black. Instances are left out: without them the image is the same.
std::vector<EffectRender> effect_renders(const FinalRenderRequest& request, grf::Diagnostics& diagnostics);

/// The request that renders an effect, to its own file.
FinalRenderRequest request_of(const EffectRender& effect, const FinalRenderRequest& request,
                              const FinalRender& final_render);

}  // namespace editor
