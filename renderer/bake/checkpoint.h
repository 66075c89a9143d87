// An interrupted bake resumes from its checkpoint.
#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "renderer/bake/bake.h"
#include "renderer/transport/checkpoint_frame.h"

namespace bake {

/// Replaces the file with the state of a bake, or leaves it unchanged and reports why. Workers may continue
/// meanwhile: each vertex is stored in a consistent state. A vertex takes 40 bytes, and 48 per direction.
bool write_checkpoint(const std::string& path, const transport::Fingerprint& fingerprint, const Bake& bake,
                      grf::Diagnostics& diagnostics);

/// Restores a bake that has not run yet from a checkpoint, if the file exists. A damaged file, one of another
/// bake, and one with more samples than were asked for are errors, which leave both the file and the bake
/// unchanged.
bool resume_from_checkpoint(const std::string& path, const transport::Fingerprint& fingerprint, Bake& bake,
                            grf::Diagnostics& diagnostics);

}  // namespace bake
