// Render options name several cameras, and those of the frames of an animation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/camera.h"

namespace job {

/// Checks that the named camera exists, and that an animation has the cameras and the frame that it needs.
/// Reports an error and returns false if not.
bool check_cameras(const options::RenderOptions& render_options, grf::Diagnostics& diagnostics);

/// Returns the view of a camera.
transport::View view_of(const options::NamedCamera& camera);

/// Returns the view of the camera that the options have without a name, framed to a scene of these bounds as
/// far as they do not place it.
transport::View own_view(const options::RenderOptions& render_options, const grf::Box3d& bounds);

/// Returns the view of the camera that the options name, if it exists.
std::optional<transport::View> named_view(const options::RenderOptions& render_options);

/// Returns the view of the frame that the options name, of an animation that begins with this view; the same
/// view for a still image. A turntable has a full turn, counter-clockwise seen from above, and no frame
/// twice; a path through cameras begins at the first one and ends at the last one.
transport::View view_of_frame(const options::RenderOptions& render_options, const transport::View& view);

/// Returns the frames of an animation that the options ask for, from 1; none for a still image.
std::vector<int> frames_of(const options::RenderOptions& render_options);

/// Returns the file of a frame: `image_0001.exr` for `image.exr`.
std::string file_of_frame(const std::string& path, int frame);

}  // namespace job
