// grfconvert: conversion between GRF scenes and the formats of other programs.
#include <cstdio>
#include <exception>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "converters/command/arguments.h"
#include "converters/command/check.h"
#include "converters/command/info.h"
#include "converters/command/list_formats.h"
#include "converters/command/tidy.h"

namespace {

using convert::Arguments;
using convert::ExitCode;

ExitCode run(const CLI::App& app, const Arguments& arguments) {
  if (app.got_subcommand("formats")) {
    convert::print_formats(arguments.json);
    return ExitCode::Done;
  }
  if (app.got_subcommand("check")) {
    const convert::CheckOptions options = {arguments.deep, arguments.json, arguments.quiet};
    return convert::check_files(arguments.inputs, options, arguments.limits);
  }
  if (app.got_subcommand("tidy")) return convert::tidy_files(arguments.inputs, arguments.quiet);
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
