// An interrupted render resumes from its checkpoint.
#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "renderer/transport/checkpoint_frame.h"
#include "renderer/transport/render.h"

namespace transport {

/// Replaces the file with the state of a render, or leaves it unchanged and reports why. Workers may continue
/// meanwhile: each tile is stored in a consistent state. A pixel takes 96 bytes.
bool write_checkpoint(const std::string& path, const Fingerprint& fingerprint, const Render& render,
                      grf::Diagnostics& diagnostics);

/// Restores a render that has not run yet from a checkpoint, if the file exists. A damaged file, one of
/// another image, and one with more samples than were asked for are errors, which leave both the file and the
/// render unchanged.
bool resume_from_checkpoint(const std::string& path, const Fingerprint& fingerprint, Render& render,
                            grf::Diagnostics& diagnostics);

}  // namespace transport
