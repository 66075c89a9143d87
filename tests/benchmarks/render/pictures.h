#pragma once

#include <filesystem>
#include <vector>

#include "renderer/image/image.h"

namespace benchmark {

/// Reads an image; throws if it cannot be read.
image::Image read_picture(const std::filesystem::path& path);

/// Writes images of equal height side by side. Throws if the file cannot be written.
void write_side_by_side(const std::vector<image::Image>& images, const std::filesystem::path& path);

/// Writes rows of images of equal size below each other. Throws if the file cannot be written.
void write_grid(const std::vector<std::vector<image::Image>>& rows, const std::filesystem::path& path);

}  // namespace benchmark
