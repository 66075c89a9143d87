// What an interrupted render resumes from.
#pragma once

#include <cstdint>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/transport/render.h"

namespace transport {

/// What an image depends on besides its samples: check sums that whoever asks for the render makes. Two
/// renders of which all three agree are parts of one.
struct Fingerprint {
  std::uint32_t options = 0;
  std::uint32_t files = 0;    ///< what the scene's files hold
  std::uint32_t program = 0;  ///< another build may round differently

  bool operator==(const Fingerprint&) const = default;
};

/// Replaces the file by the state of a render, or leaves it as it was and says why. Workers may go on
/// meanwhile: each tile is as some moment left it. A pixel takes 48 bytes.
bool write_checkpoint(const std::string& path, const Fingerprint& fingerprint, const Render& render,
                      grf::Diagnostics& diagnostics);

/// Gives a render that has not run yet what the file holds, if there is such a file. One that is broken, that
/// belongs to another image, or that has more samples than were asked for is an error; it is left as it is,
/// and so is the render.
bool resume_from_checkpoint(const std::string& path, const Fingerprint& fingerprint, Render& render,
                            grf::Diagnostics& diagnostics);

/// Adds bytes to a check sum that started as 0.
std::uint32_t check_sum(std::uint32_t before, std::string_view bytes);

}  // namespace transport
