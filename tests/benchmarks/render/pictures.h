#pragma once

#include <filesystem>
#include <vector>

#include "renderer/transport/image/image.h"

namespace benchmark {

/// Throws if there is none that can be read.
transport::Image read_picture(const std::filesystem::path& path);

/// Images of one height, from the left to the right. Throws if the file cannot be written.
void write_side_by_side(const std::vector<transport::Image>& images, const std::filesystem::path& path);

}  // namespace benchmark
