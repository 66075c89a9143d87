// What an interrupted bake resumes from.
#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "renderer/transport/bake.h"
#include "renderer/transport/checkpoint_frame.h"

namespace transport {

/// Replaces the file by the state of a bake, or leaves it as it was and says why. Workers may go on
/// meanwhile: each vertex is as some moment left it. A vertex takes 40 bytes and 48 for each direction.
bool write_checkpoint(const std::string& path, const Fingerprint& fingerprint, const Bake& bake,
                      grf::Diagnostics& diagnostics);

/// Gives a bake that has not run yet what the file holds, if there is such a file. One that is broken, that
/// belongs to something else, or that has more samples than were asked for is an error; it is left as it is,
/// and so is the bake.
bool resume_from_checkpoint(const std::string& path, const Fingerprint& fingerprint, Bake& bake,
                            grf::Diagnostics& diagnostics);

}  // namespace transport
