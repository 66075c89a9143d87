// A page on a conversion: what is kept, and how far what comes back is from the original, in pictures and
// figures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converters/format.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

struct ConversionReport {
  std::string page;    ///< path: `.html`, or `.md`; the pictures are beside it
  std::string folder;  ///< for files that the second picture is made from
  std::string input;   ///< path of the input, as it was given
  std::string output;  ///< path of the written file, which file names of the scene are relative to
  const Format* format = nullptr;
  std::string op_file;              ///< with the view; may be empty
  std::vector<std::string> losses;  ///< what was reported as lost
};

/// Returns whether a page has an ending that is known.
bool is_report_page(const std::string& path);

/// Renders a scene and what comes back from the file that was written of it, compares their surfaces, and
/// writes the page and its pictures. Returns their paths; nothing after an error.
std::optional<std::vector<std::string>> write_report(const ConversionReport& report, const grf::Scene& scene,
                                                     grf::Diagnostics& diagnostics);

}  // namespace convert
