#pragma once

#include <string>
#include <vector>

#include "converters/command/report.h"
#include "converters/input.h"
#include "converters/mesh_operations/mesh_operations.h"

namespace convert {

struct ConvertOptions {
  InputOptions input;
  std::string output;
  const Format* output_format = nullptr;  ///< null: detected from the output's name
  bool flat = false;                      ///< expand includes and BRDF files into one file
  bool grf2008 = false;                   ///< write only the grammar of 2008
  std::vector<std::string> only;          ///< names of the meshes to keep; empty: all
  MeshOperations operations;
  std::vector<grf::TransformStep> placement;  ///< transform of the whole scene
  WriteOptions writing;
  std::string dry_run_folder;  ///< write there, only to find problems; empty: write the output
  std::string report;          ///< path of a page on the conversion; empty: none
  std::string report_folder;   ///< an empty folder for what the page's pictures are made from
  bool quiet = false;
  bool json = false;
};

/// Returns the format of the output, or null.
const Format* output_format(const ConvertOptions& options);

/// Returns the path that is written: the output, or a file of the same name in the folder of a dry run.
std::string written_path(const ConvertOptions& options);

/// Validates the options, whatever the input is: returns an error message, or an empty string.
std::string problem_of(const ConvertOptions& options);

/// Whether a file is an OP file, by its name: the input is the scene that it names, with its view; the output
/// has the cameras of the input, and renders a GRF file of the same name beside it.
bool is_op_file(const std::string& path);

/// Runs `grfconvert IN -o OUT` with valid options: nothing is written unless all of the input could be read.
/// Prints one line, or one JSON object, on success.
ExitCode convert_file(const ConvertOptions& options);

}  // namespace convert
