#include "converters/command/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "converters/mesh_operations/scene_placement.h"

namespace convert {
namespace {

template <class Member>
CLI::IsMember is_format_with(Member Format::*member) {
  std::vector<std::string> names;
  for (const Format& format : formats()) {
    if (format.*member != nullptr) names.emplace_back(format.name);
  }
  return CLI::IsMember(names, CLI::ignore_case);
}

void add_input_options(CLI::App& command, Arguments& arguments) {
  command.add_option("--from", arguments.from, "Format of the input, whatever its content and name")
      ->check(is_format_with(&Format::read));
  command.add_option("--brdf", arguments.brdf,
                     "BRDF of faces that come without a material, such as \"ward sx=0.15 ks=0.3 kd=0.2\"");
}

void add_limit_options(CLI::App& command, Arguments& arguments) {
  command
      .add_option("--max-memory", arguments.limits.memory,
                  "Most memory that a file may take to be read and converted, such as 512MB (0: no limit)")
      ->transform(CLI::AsSizeValue(false))
      ->default_str("4GB");
  command
      .add_option("--max-time", arguments.limits.seconds, "Most seconds that a file may take (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void add_quiet_option(CLI::App& command, Arguments& arguments) {
  command.add_flag("-q,--quiet", arguments.quiet, "Print errors alone");
}

void add_json_option(CLI::App& command, Arguments& arguments) {
  command.add_flag("--json", arguments.json, "Print one JSON object");
}

void add_mesh_options(CLI::App& app, Arguments& arguments) {
  app.add_option(
      "--weld", arguments.weld,
      "Merge vertices nearer than this, in the units of the meshes as they are read (0: those at one "
      "place)");
  app.add_option(
         "--smooth", arguments.smooth,
         "Move vertices towards their neighbours in so many steps (Taubin's smoothing), so that noise "
         "goes but the size stays; boundaries are kept")
      ->check(CLI::Range(0, 10'000));
  app.add_option(
      "--decimate", arguments.decimate,
      "Leave about this share of the triangles (over 0, up to 1): holes, borders between materials and "
      "seams are kept, and the vertices that are left keep normals, colours and texture coordinates");
  app.add_option(
      "--subdivide", arguments.subdivide,
      "loop:LEVELS, each triangle becomes four; or catmull-clark:LEVELS, each face becomes as many as it has "
      "corners: so many times (1 if not given), towards a smooth surface; faces keep their materials");
  app.add_flag("--triangulate", arguments.triangulate, "Cut polygons into triangles");
  app.add_option(
      "--normals", arguments.normals,
      "keep; smooth:ANGLE, new ones with creases where faces are turned by more than so many degrees; "
      "or flat, none");
}

void add_placement_options(CLI::App& app, Arguments& arguments) {
  app.add_option("--up", arguments.up, "The input's axis that points up; it becomes y")
      ->check(CLI::IsMember({"y", "z"}, CLI::ignore_case));
  app.add_option("--scale", arguments.scale, "Factor for all lengths, after --up");
  app.add_option(
      "--transform", arguments.transform,
      "Steps in their order, after --scale, such as \"rotation 0 90 0 translation 1 0 0\"; angles in "
      "degrees about x, then y, then z; \"scale 1 2 1\" is one too");
}

void define_conversion(CLI::App& app, Arguments& arguments) {
  app.description(
      "Converts models to GRF scenes: grfconvert IN -o OUT, or grfconvert IN... -o FOLDER. Commands do other "
      "things with them.");
  app.require_subcommand(0, 1);
  app.add_option("IN", arguments.inputs, "Files to read");
  app.add_option(
      "-o,--output", arguments.output,
      "File to write, whose extension says the format; or a folder (a name that ends in / is one), and "
      "for several files always");
  app.add_option("--to", arguments.to,
                 "Format of the output, whatever its name; in a folder, grf if not given")
      ->check(is_format_with(&Format::write));
  app.add_flag("--flatten", arguments.flat, "Write included files and files of BRDFs out, into one GRF file");
  app.add_flag("--grf2008", arguments.grf2008, "Write GRF by its grammar of 2008, without extensions");
  add_input_options(app, arguments);
  add_mesh_options(app, arguments);
  add_placement_options(app, arguments);
  app.add_option("--jobs", arguments.jobs,
                 "So many files are converted at once (0: as many as there are cores)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_limit_options(app, arguments);
  app.add_flag("--dry-run", arguments.dry_run,
               "Read and convert all, and say what there is to say, but write nothing");
  app.add_flag("--progress", arguments.progress, "Show how many files are done");
  add_quiet_option(app, arguments);
  add_json_option(app, arguments);
}

void define_info(CLI::App& app, Arguments& arguments) {
  CLI::App* info = app.add_subcommand("info", "Print the figures of a file");
  info->add_option("FILE", arguments.input, "File to read")->required();
  add_json_option(*info, arguments);
  add_input_options(*info, arguments);
  add_limit_options(*info, arguments);
  add_quiet_option(*info, arguments);
}

void define_check(CLI::App& app, Arguments& arguments) {
  CLI::App* check = app.add_subcommand("check", "Say what is wrong with files");
  check->add_option("FILE", arguments.inputs, "Files to read")->required();
  add_json_option(*check, arguments);
  add_limit_options(*check, arguments);
  add_quiet_option(*check, arguments);
}

void define_tidy(CLI::App& app, Arguments& arguments) {
  CLI::App* tidy = app.add_subcommand("tidy", "Write GRF files again in the one style");
  tidy->add_option("FILE", arguments.inputs, "Files to write again")->required();
  add_quiet_option(*tidy, arguments);
}

void define_formats(CLI::App& app, Arguments& arguments) {
  CLI::App* formats = app.add_subcommand("formats", "List the formats, and what each keeps and loses");
  add_json_option(*formats, arguments);
}

/// Takes what `--normals` says; what is wrong with it, or empty.
std::string set_normals(const std::string& text, MeshOperations& operations) {
  constexpr std::string_view Smooth = "smooth:";
  if (text == "keep") return {};
  if (text == "flat") {
    operations.normals = Normals::Flat;
    return {};
  }
  const char* end = text.data() + text.size();
  double degrees = -1;
  const bool is_smooth = text.starts_with(Smooth);
  const auto number = is_smooth ? std::from_chars(text.data() + Smooth.size(), end, degrees)
                                : std::from_chars_result{text.data(), std::errc::invalid_argument};
  if (number.ec != std::errc() || number.ptr != end || !(degrees >= 0 && degrees <= 180)) {
    return fmt::format("--normals: found '{}', expected keep, flat or smooth:ANGLE, of 0 to 180 degrees",
                       text);
  }
  operations.normals = Normals::Smooth;
  operations.crease = degrees * std::numbers::pi / 180;
  return {};
}

/// Takes what `--subdivide` says; what is wrong with it, or empty.
std::string set_subdivision(const std::string& text, MeshOperations& operations) {
  constexpr int MostLevels = 10;
  if (text.empty()) return {};
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string scheme = text.substr(0, colon);
  const std::string levels = colon == text.size() ? "1" : text.substr(colon + 1);
  Subdivision subdivision;
  const auto number = std::from_chars(levels.data(), levels.data() + levels.size(), subdivision.levels);
  const bool has_levels = number.ec == std::errc() && number.ptr == levels.data() + levels.size() &&
                          subdivision.levels >= 1 && subdivision.levels <= MostLevels;
  if (!has_levels || (scheme != "loop" && scheme != "catmull-clark")) {
    return fmt::format("--subdivide: found '{}', expected loop:LEVELS or catmull-clark:LEVELS, of 1 to {}",
                       text, MostLevels);
  }
  subdivision.scheme = scheme == "loop" ? SubdivisionScheme::Loop : SubdivisionScheme::CatmullClark;
  operations.subdivide = subdivision;
  return {};
}

/// What is wrong with a number; empty if nothing is.
std::string problem_of_numbers(const Arguments& arguments) {
  constexpr double Largest = std::numeric_limits<float>::max();
  const auto wrong = [](const char* option, double value, const char* expected) {
    return fmt::format("{}: {} is out of range, expected {}", option, value, expected);
  };
  const double weld = arguments.weld.value_or(0);
  const double decimate = arguments.decimate.value_or(1);
  const auto scale = static_cast<float>(arguments.scale);
  if (!(weld >= 0 && weld <= Largest)) return wrong("--weld", weld, "a length of 0 or more");
  if (!(decimate > 0 && decimate <= 1)) return wrong("--decimate", decimate, "over 0, up to 1");
  if (!(scale > 0 && scale <= Largest)) return wrong("--scale", arguments.scale, "over 0");
  return {};
}

/// The steps of `--up`, `--scale` and `--transform`.
std::vector<grf::TransformStep> placement_of(const Arguments& arguments, std::string& problem) {
  std::vector<grf::TransformStep> steps;
  if (arguments.up == "z") steps.push_back(z_up_to_y_up());
  if (arguments.scale != 1) {
    steps.push_back({grf::TransformStep::Kind::Scale, grf::Vec3f(static_cast<float>(arguments.scale))});
  }
  if (arguments.transform.empty()) return steps;
  std::string wrong;
  const auto more = read_transform_steps(arguments.transform, wrong);
  if (!more) problem = "--transform: " + wrong;
  if (more) steps.insert(steps.end(), more->begin(), more->end());
  return steps;
}

}  // namespace

void define_command_line(CLI::App& app, Arguments& arguments) {
  define_conversion(app, arguments);
  define_info(app, arguments);
  define_check(app, arguments);
  define_tidy(app, arguments);
  define_formats(app, arguments);
}

std::optional<InputOptions> input_options(const Arguments& arguments) {
  InputOptions options{arguments.input, find_format(arguments.from), {}};
  if (arguments.brdf.empty()) return options;
  grf::Diagnostics diagnostics;
  options.reading.brdf = read_brdf_option(arguments.brdf, "--brdf", diagnostics);
  print(diagnostics, arguments.quiet);
  return options.reading.brdf ? std::optional(options) : std::nullopt;
}

std::optional<BatchOptions> batch_options(const Arguments& arguments) {
  BatchOptions options;
  std::string problem;
  if (arguments.inputs.empty()) {
    problem = "the file to read is missing";
  } else if (arguments.output.empty()) {
    problem = "the file to write is missing (-o OUT)";
  } else {
    problem = problem_of_numbers(arguments);
    if (problem.empty()) problem = set_subdivision(arguments.subdivide, options.each.operations);
    if (problem.empty()) problem = set_normals(arguments.normals, options.each.operations);
  }
  if (problem.empty()) options.each.placement = placement_of(arguments, problem);
  if (!problem.empty()) {
    bad_command_line(problem);
    return std::nullopt;
  }
  const auto input = input_options(arguments);
  if (!input) return std::nullopt;
  options.inputs = arguments.inputs;
  options.output = arguments.output;
  options.jobs = static_cast<std::size_t>(arguments.jobs);
  options.progress = arguments.progress;
  options.limits = arguments.limits;
  options.each.input = *input;
  options.each.output_format = find_format(arguments.to);
  options.each.flat = arguments.flat;
  options.each.grf2008 = arguments.grf2008;
  options.each.operations.weld = arguments.weld;
  options.each.operations.smooth = arguments.smooth;
  options.each.operations.triangulate = arguments.triangulate;
  options.each.operations.decimate = arguments.decimate;
  options.each.dry_run = arguments.dry_run;
  options.each.quiet = arguments.quiet;
  options.each.json = arguments.json;
  return options;
}

}  // namespace convert
