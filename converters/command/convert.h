#pragma once

#include <string>
#include <vector>

#include "converters/command/input.h"
#include "converters/command/report.h"
#include "converters/mesh_operations/mesh_operations.h"

namespace convert {

struct ConvertOptions {
  InputOptions input;
  std::string output;
  const Format* output_format = nullptr;  ///< null: told by the output's name
  bool flat = false;                      ///< includes and BRDF files are written out in the one file
  bool grf2008 = false;                   ///< the grammar of 2008 alone
  MeshOperations operations;
  std::vector<grf::TransformStep> placement;  ///< of the scene as a whole
  bool dry_run = false;                       ///< nothing is written
  bool quiet = false;
  bool json = false;
};

/// The format of the output, or null.
const Format* output_format(const ConvertOptions& options);

/// What is wrong with the options, whatever the input is; empty if nothing is.
std::string problem_of(const ConvertOptions& options);

/// `grfconvert IN -o OUT`, with options that are sound: nothing is written unless all of the input could be
/// read. Prints one line, or one JSON object, where it was done.
ExitCode convert_file(const ConvertOptions& options);

}  // namespace convert
