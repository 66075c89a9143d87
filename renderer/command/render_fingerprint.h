#pragma once

#include <set>
#include <string>

#include "renderer/options/render_options.h"
#include "renderer/transport/checkpoint.h"

namespace command {

/// Of all that the image depends on: the options but those that only say how much is rendered, on how many
/// threads and what is written; what is in the files that were read; and this program.
transport::Fingerprint fingerprint_of(const options::RenderOptions& render_options,
                                      std::set<std::string> files);

}  // namespace command
