// What an interrupted render resumes from.
#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "renderer/transport/checkpoint_frame.h"
#include "renderer/transport/render.h"

namespace transport {

/// Replaces the file by the state of a render, or leaves it as it was and says why. Workers may go on
/// meanwhile: each tile is as some moment left it. A pixel takes 48 bytes.
bool write_checkpoint(const std::string& path, const Fingerprint& fingerprint, const Render& render,
                      grf::Diagnostics& diagnostics);

/// Gives a render that has not run yet what the file holds, if there is such a file. One that is broken, that
/// belongs to another image, or that has more samples than were asked for is an error; it is left as it is,
/// and so is the render.
bool resume_from_checkpoint(const std::string& path, const Fingerprint& fingerprint, Render& render,
                            grf::Diagnostics& diagnostics);

}  // namespace transport
