// The stages of a preview go from coarse to fine.
#pragma once

#include <vector>

#include "renderer/transport/render.h"

namespace job {

/// Returns the settings of a preview's successive renders, of which the last is the one asked for. Those
/// before it have an eighth, a quarter and half of its resolution and one sample per pixel; stages that would
/// be less than 12 pixels across are skipped.
std::vector<transport::RenderSettings> preview_stages(const transport::RenderSettings& whole);

/// Returns the image so far; tiles without samples are filled from `before`, an image of the same view.
transport::Image completed(const transport::Render& render, const transport::Image& before);

}  // namespace job
