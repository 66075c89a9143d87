// What a render leaves behind: its image, with what is known of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/image/image_file.h"
#include "renderer/transport/render.h"

namespace command {

/// Whether images of these options can go to these files, as far as can be told: an image that cannot be kept
/// is better known before the render than after it.
bool can_write(const std::vector<std::string>& outputs, const options::RenderOptions& render_options,
               grf::Diagnostics& diagnostics);

/// The same for any file; `what` it is goes into messages.
bool can_write_file(const std::string& path, std::string_view what, grf::Diagnostics& diagnostics);

/// The image of a render that has ended, with the layers that the options ask for, and with attributes: each
/// option by its key (of the eye and the samples what they came to), the camera, the program's version, the
/// seconds, the samples a pixel and the estimated error.
transport::ImageFile image_file_of(const transport::Render& render, const transport::CompiledScene& scene,
                                   const transport::View& view, const options::RenderOptions& render_options);

}  // namespace command
