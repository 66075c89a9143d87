// Untrusted images are decoded in a process of their own, `bpt decode`, which writes what is read here.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "renderer/image/image_file.h"

namespace image {

/// Parses an image as `bpt decode` writes it; without layers, there is nothing after the image. It is
/// untrusted, too: a file that exploits the decoder may have had it write anything.
std::optional<ImageFile> decoded_image(std::string_view bytes, bool has_layers);

/// Moves the layer to the image that `bpt decode --alpha` appends if an image has alpha.
Image with_alpha_of_layer(ImageFile file);

/// Returns whether a file has a format that a library decodes: OpenEXR, PNG, JPEG or WebP. Not if it cannot
/// be read.
bool is_decoded_by_library(const std::string& path);

}  // namespace image
