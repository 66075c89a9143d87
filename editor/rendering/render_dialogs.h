// Dialogs that ask which images to render.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/rendering/effect_renders.h"
#include "renderer/options/render_options.h"

class QWidget;

namespace editor {

/// Asks which cameras to render: names, of which an empty one is the camera without a name. Returns nothing
/// if it is cancelled.
std::optional<std::vector<std::string>> ask_for_cameras(const options::RenderOptions& render_options,
                                                        QWidget* parent);

/// Asks which of these effects to render. Returns nothing if it is cancelled.
std::optional<std::vector<EffectRender>> ask_for_effects(const std::vector<EffectRender>& effects,
                                                         QWidget* parent);

/// Asks for the frames and the camera path of an animation, and returns the options with these. Returns
/// nothing if it is cancelled.
std::optional<options::RenderOptions> ask_for_animation(const options::RenderOptions& render_options,
                                                        QWidget* parent);

}  // namespace editor
