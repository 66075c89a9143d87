// grfconvert: conversion between GRF scenes and the formats of other programs.
#include <cstdio>
#include <exception>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command_line/manual.h"
#include "confinement/confinement.h"
#include "converters/command/arguments.h"
#include "converters/command/check.h"
#include "converters/command/info.h"
#include "converters/command/list_formats.h"
#include "converters/command/tidy.h"

namespace {

using convert::Arguments;
using convert::ExitCode;

constexpr command_line::ManualText Manual = {
    .date = GRANADA_DATE,
    .version = GRANADA_VERSION,
    .description =
        "grfconvert converts models and scenes between GRF and the formats of other programs: OBJ, PLY, "
        "glTF, 3DS, "
        "STL, VRML, COLLADA, FBX and others to GRF, and GRF to OBJ, PLY, glTF, STL, USD, MaterialX, pbrt and "
        "Mitsuba. "
        "Formats are "
        "detected. What a format cannot hold is listed as lost.\n\n"
        "Each file is read in a process of its own, with limits of memory and time. It reads only files in "
        "the "
        "folder of the input and the one above it, writes only into the folder of the output, and has no "
        "network (see --readable).",
    .examples =
        "Convert a model\ngrfconvert model.obj -o model.grf\n"
        "Convert a folder, each file in a process of its own\ngrfconvert *.obj -o scenes/ --jobs 0\n"
        "List the formats, and what each keeps and loses\ngrfconvert formats\n"
        "Find out what is risky in a scene\ngrfconvert check --deep scene.grf\n",
    .see_also = "bpt(1), wannabe(1), grf(5)",
};

ExitCode run(const CLI::App& app, const Arguments& arguments) {
  if (app.got_subcommand("formats")) {
    convert::print_formats(arguments.json);
    return ExitCode::Done;
  }
  if (app.got_subcommand("check")) {
    const convert::CheckOptions options = {arguments.deep, arguments.json, arguments.quiet};
    return convert::check_files(arguments.inputs, options, arguments.limits);
  }
  if (app.got_subcommand("tidy"))
    return convert::tidy_files(arguments.inputs, arguments.quiet, arguments.limits);
  if (!app.got_subcommand("info")) {
    const auto options = convert::batch_options(arguments);
    return options ? convert::convert_files(*options) : ExitCode::BadCommandLine;
  }
  const auto input = convert::input_options(arguments);
  if (!input) return ExitCode::BadCommandLine;
  return convert::print_info(*input, arguments.json, arguments.quiet, arguments.limits);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app("", "grfconvert");
    Arguments arguments;
    convert::define_command_line(app, arguments);
    app.set_version_flag("--version", [] {
      return fmt::format("grfconvert {} (Apache-2.0)\nLibraries: {}\nReading of untrusted files: {}",
                         GRANADA_VERSION, GRANADA_LIBRARIES,
                         confinement::description(confinement::available()));
    });
    command_line::add_manual_option(app, Manual);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      const bool is_help = error.get_exit_code() == 0;
      return is_help ? app.exit(error) : static_cast<int>(convert::bad_command_line(error.what()));
    }
    return static_cast<int>(run(app, arguments));
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "grfconvert: out of memory\n");
    return static_cast<int>(ExitCode::BadInput);
  } catch (const std::exception& error) {
    fmt::print(stderr, "grfconvert: {}\n", error.what());
    return static_cast<int>(ExitCode::BadInput);
  }
}
