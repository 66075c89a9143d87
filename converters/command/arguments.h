// CLI11 parses the command line of grfconvert.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "converters/command/batch.h"

namespace convert {

/// The values of the command line.
struct Arguments {
  std::string input;
  std::vector<std::string> inputs;
  std::string output;
  std::string from;
  std::string to;
  std::string brdf;
  std::string variant;
  std::string normals = "keep";
  std::string subdivide;
  std::string transform;
  std::string op_file;
  std::string report;
  std::string up = "y";
  std::string unit = "m";
  std::vector<std::string> only;
  double scale = 1;
  std::optional<double> weld;
  std::optional<double> decimate;
  int smooth = 0;
  int jobs = 1;
  Limits limits;
  bool triangulate = false;
  bool flat = false;
  bool grf2008 = false;
  bool deep = false;
  bool dry_run = false;
  bool progress = false;
  bool quiet = false;
  bool json = false;
};

/// Defines the command line: the conversion, and the commands info, check, tidy and formats.
void define_command_line(CLI::App& app, Arguments& arguments);

/// Converts the arguments to the options of an input, or returns nothing after a message.
std::optional<InputOptions> input_options(const Arguments& arguments);

/// Converts the arguments to the options of a conversion, or returns nothing after a message.
std::optional<BatchOptions> batch_options(const Arguments& arguments);

}  // namespace convert
