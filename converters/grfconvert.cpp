// grfconvert: conversion between GRF scenes and the formats of other programs.
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "converters/command/check.h"
#include "converters/command/convert.h"
#include "converters/command/info.h"
#include "converters/command/list_formats.h"
#include "converters/command/tidy.h"

namespace {

using convert::ExitCode;

/// What the command line says, as words.
struct Arguments {
  std::string input;
  std::vector<std::string> inputs;
  std::string output;
  std::string from;
  std::string to;
  std::string brdf;
  bool flat = false;
  bool grf2008 = false;
  bool quiet = false;
  bool json = false;
};

CLI::IsMember is_format() {
  std::vector<std::string> names;
  for (const convert::Format& format : convert::formats()) names.emplace_back(format.name);
  return CLI::IsMember(names, CLI::ignore_case);
}

void add_input_options(CLI::App& command, Arguments& arguments) {
  command.add_option("--from", arguments.from, "Format of the input, whatever its content and name")
      ->check(is_format());
  command.add_option("--brdf", arguments.brdf,
                     "BRDF of faces that come without a material, such as \"ward sx=0.15 ks=0.3 kd=0.2\"");
}

void add_quiet_option(CLI::App& command, Arguments& arguments) {
  command.add_flag("-q,--quiet", arguments.quiet, "Print errors alone");
}

void define_conversion(CLI::App& app, Arguments& arguments) {
  app.description("Converts models to GRF scenes: grfconvert IN -o OUT. Commands do other things with them.");
  app.require_subcommand(0, 1);
  app.add_option("IN", arguments.input, "File to read");
  app.add_option("-o,--output", arguments.output, "File to write; its extension says the format");
  app.add_option("--to", arguments.to, "Format of the output, whatever its name")->check(is_format());
  app.add_flag("--flatten", arguments.flat, "Write included files and files of BRDFs out, into one GRF file");
  app.add_flag("--grf2008", arguments.grf2008, "Write GRF by its grammar of 2008, without extensions");
  add_input_options(app, arguments);
  add_quiet_option(app, arguments);
}

void define_info(CLI::App& app, Arguments& arguments) {
  CLI::App* info = app.add_subcommand("info", "Print the figures of a file");
  info->add_option("FILE", arguments.input, "File to read")->required();
  info->add_flag("--json", arguments.json, "Print one JSON object");
  add_input_options(*info, arguments);
  add_quiet_option(*info, arguments);
}

void define_check(CLI::App& app, Arguments& arguments) {
  CLI::App* check = app.add_subcommand("check", "Say what is wrong with files");
  check->add_option("FILE", arguments.inputs, "Files to read")->required();
  check->add_flag("--json", arguments.json, "Print one JSON object");
  add_quiet_option(*check, arguments);
}

void define_tidy(CLI::App& app, Arguments& arguments) {
  CLI::App* tidy = app.add_subcommand("tidy", "Write GRF files again in the one style");
  tidy->add_option("FILE", arguments.inputs, "Files to write again")->required();
  add_quiet_option(*tidy, arguments);
}

void define_formats(CLI::App& app, Arguments& arguments) {
  CLI::App* formats = app.add_subcommand("formats", "List the formats, and what each keeps and loses");
  formats->add_flag("--json", arguments.json, "Print one JSON object");
}

/// What the options say of an input, or nothing after a message.
std::optional<convert::InputOptions> input_options(const Arguments& arguments) {
  convert::InputOptions options{arguments.input, convert::find_format(arguments.from), {}};
  if (arguments.brdf.empty()) return options;
  grf::Diagnostics diagnostics;
  options.reading.brdf = convert::read_brdf_option(arguments.brdf, "--brdf", diagnostics);
  convert::print(diagnostics, arguments.quiet);
  return options.reading.brdf ? std::optional(options) : std::nullopt;
}

ExitCode run_conversion(const Arguments& arguments) {
  if (arguments.input.empty()) return convert::bad_command_line("the file to read is missing");
  if (arguments.output.empty()) return convert::bad_command_line("the file to write is missing (-o OUT)");
  const auto input = input_options(arguments);
  if (!input) return ExitCode::BadCommandLine;
  return convert::convert_file({*input, arguments.output, convert::find_format(arguments.to), arguments.flat,
                                arguments.grf2008, arguments.quiet});
}

ExitCode run(const CLI::App& app, const Arguments& arguments) {
  if (app.got_subcommand("formats")) {
    convert::print_formats(arguments.json);
    return ExitCode::Done;
  }
  if (app.got_subcommand("check")) {
    return convert::check_files(arguments.inputs, arguments.json, arguments.quiet);
  }
  if (app.got_subcommand("tidy")) return convert::tidy_files(arguments.inputs, arguments.quiet);
  if (!app.got_subcommand("info")) return run_conversion(arguments);
  const auto input = input_options(arguments);
  return input ? convert::print_info(*input, arguments.json, arguments.quiet) : ExitCode::BadCommandLine;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app("", "grfconvert");
    Arguments arguments;
    define_conversion(app, arguments);
    define_info(app, arguments);
    define_check(app, arguments);
    define_tidy(app, arguments);
    define_formats(app, arguments);
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
