#pragma once

#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/exit_code.h"
#include "renderer/command/image_description.h"
#include "renderer/transport/part_merge.h"

namespace command {

/// The command line of `bpt merge`.
struct MergeArguments {
  std::vector<std::string> parts;    ///< files
  std::vector<std::string> outputs;  ///< images, or one part file
  bool lists_missing = false;        ///< prints which samples lack instead
  bool json = false;
};

/// Merges parts of an image to the image, or to a larger part, and prints a summary. An image of which
/// samples lack is not written. Parts of a bake become its scene likewise.
grf::ExitCode merge(const MergeArguments& arguments);

/// How the summary of a merged image is printed.
enum class SummaryStyle {
  Text,
  Json,      ///< indented
  JsonLine,  ///< after the lines of the progress
};

/// Writes the image of a merge that has all samples, and prints a summary. The bias of its samples is part of
/// the stated error.
bool write_merged(const transport::PartMerge& merge, const transport::ErrorEstimate& bias,
                  const ImageDescription& description, const std::vector<std::string>& outputs,
                  SummaryStyle style, grf::Diagnostics& diagnostics);

}  // namespace command
