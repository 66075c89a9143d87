// The image file of a render holds layers and attributes besides the image.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/command/image_description.h"
#include "renderer/image/image_file.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/render.h"

namespace command {

/// Checks before a render, as far as possible, that its images can be written to these files. Reports an
/// error and returns false if not.
bool can_write(const std::vector<std::string>& outputs, const options::RenderOptions& render_options,
               grf::Diagnostics& diagnostics);

/// Checks likewise that a file can be written; messages name its kind, `what`.
bool can_write_file(const std::string& path, std::string_view what, grf::Diagnostics& diagnostics);

/// Returns the description of a render's image: the requested features, and as attributes each option by its
/// key (for camera and samples, the values used), the camera and the program's version.
ImageDescription description_of(const transport::Render& render, const transport::CompiledScene& scene,
                                const options::RenderOptions& render_options);

/// Returns an image with the requested layers and with the attributes of its description, the render time in
/// seconds, the samples per pixel and the given error estimate.
image::ImageFile image_file_of(const transport::Film& film, ImageDescription description, double seconds,
                               const std::optional<transport::ErrorEstimate>& estimate);

}  // namespace command
