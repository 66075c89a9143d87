// The words of grfconvert's command line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "converters/command/batch.h"

namespace convert {

/// What the command line says.
struct Arguments {
  std::string input;
  std::vector<std::string> inputs;
  std::string output;
  std::string from;
  std::string to;
  std::string brdf;
  std::string normals = "keep";
  std::string subdivide;
  std::string transform;
  std::string up = "y";
  double scale = 1;
  std::optional<double> weld;
  std::optional<double> decimate;
  int smooth = 0;
  int jobs = 1;
  Limits limits;
  bool triangulate = false;
  bool flat = false;
  bool grf2008 = false;
  bool dry_run = false;
  bool progress = false;
  bool quiet = false;
  bool json = false;
};

/// Makes the command line: the conversion, and the commands info, check, tidy and formats.
void define_command_line(CLI::App& app, Arguments& arguments);

/// What the arguments say of an input, or nothing after a message.
std::optional<InputOptions> input_options(const Arguments& arguments);

/// What they say of a conversion, or nothing after a message.
std::optional<BatchOptions> batch_options(const Arguments& arguments);

}  // namespace convert
