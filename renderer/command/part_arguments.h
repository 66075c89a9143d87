// Flags of `bpt render` choose a part of an image's samples.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"
#include "renderer/transport/image_part.h"

namespace command {

/// Values of the flags that choose a part of an image's samples; empty: not given.
struct PartFlags {
  std::string part;   ///< such as 3/40: from 1 to the number of parts
  std::string tiles;  ///< such as 0..99: the first and the last one
  std::string pilot;  ///< a part file with the pilot of an adaptive image
};

/// Returns the part that flags choose; empty if they choose none. Takes a range, such as 128..255, out of the
/// flag `--samples`. Prints errors, and sets `is_right`.
std::optional<transport::ImagePart> image_part_of(const PartFlags& part_flags, OptionFlags& flags,
                                                  bool& is_right);

/// Returns the flags that choose a part.
std::string flags_text(const transport::ImagePart& part);

/// Prints parts that lack as flags, one a line, or as JSON. Returns BadInput if there are any.
grf::ExitCode print_missing(const std::vector<transport::ImagePart>& missing, bool as_json);

}  // namespace command
