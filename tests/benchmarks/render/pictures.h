#pragma once

#include <filesystem>
#include <vector>

#include "renderer/transport/image/image.h"

namespace benchmark {

/// Reads an image; throws if it cannot be read.
transport::Image read_picture(const std::filesystem::path& path);

/// Writes images of equal height side by side. Throws if the file cannot be written.
void write_side_by_side(const std::vector<transport::Image>& images, const std::filesystem::path& path);

}  // namespace benchmark
