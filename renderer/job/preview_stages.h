// How a preview comes to its image: from coarse to fine.
#pragma once

#include <vector>

#include "renderer/transport/render.h"

namespace job {

/// The renders that a preview makes one after the other, the last of which is the one asked for. Those before
/// it have an eighth, a quarter and half of its pixels a side and one sample each, unless they would be only
/// a few pixels wide.
std::vector<transport::RenderSettings> preview_stages(const transport::RenderSettings& whole);

/// The image so far, with what another image of the same view shows where there is no sample yet.
transport::Image completed(const transport::Render& render, const transport::Image& before);

}  // namespace job
