#pragma once

#include <set>
#include <string>

#include "renderer/options/render_options.h"
#include "renderer/transport/checkpoint.h"

namespace job {

/// Computes the fingerprint of all that determines the image: the contents of the files that were read, this
/// program, and the options except those for how much is rendered, the thread count and the outputs.
transport::Fingerprint fingerprint_of(const options::RenderOptions& render_options,
                                      std::set<std::string> files);

}  // namespace job
