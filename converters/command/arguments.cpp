#include "converters/command/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "converters/mesh_operations/scene_placement.h"
#include "grf/keywords.h"

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
  command.add_option("--from", arguments.from, "Input format, overriding detection by content and name")
      ->check(is_format_with(&Format::read));
  command.add_option("--variant", arguments.variant, "Variant of a glTF file's materials, by its name");
  command.add_option("--brdf", arguments.brdf,
                     "BRDF for faces without a material, such as \"ward sx=0.15 ks=0.3 kd=0.2\"");
}

void add_limit_options(CLI::App& command, Arguments& arguments) {
  command
      .add_option("--max-memory", arguments.limits.memory,
                  "Memory limit per file, such as 512MB (0: no limit)")
      ->transform(CLI::AsSizeValue(false))
      ->default_str("4GB");
  command.add_option("--max-time", arguments.limits.seconds, "Time limit per file in seconds (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void add_readable_option(CLI::App& command, Arguments& arguments) {
  command
      .add_option(
          "--readable", arguments.limits.readable,
          "Folder that the input may name files in, besides its own and the one above it; may be repeated")
      ->type_name("FOLDER")
      ->check(CLI::ExistingPath)
      ->allow_extra_args(false);
}

void add_quiet_option(CLI::App& command, Arguments& arguments) {
  command.add_flag("-q,--quiet", arguments.quiet, "Print only errors");
}

void add_json_option(CLI::App& command, Arguments& arguments) {
  command.add_flag("--json", arguments.json, "Print one JSON object");
}

void add_mesh_options(CLI::App& app, Arguments& arguments) {
  app.add_option("--only", arguments.only, "Name of a mesh to keep; may be repeated; all others are left out")
      ->allow_extra_args(false);
  app.add_option(
      "--weld", arguments.weld,
      "Merge vertices closer than this distance, in the units of the input (0: only those at one position)");
  app.add_option("--smooth", arguments.smooth,
                 "Smooth meshes in this number of steps (Taubin smoothing): removes noise without shrinking; "
                 "boundaries are kept")
      ->check(CLI::Range(0, 10'000));
  app.add_option(
      "--decimate", arguments.decimate,
      "Reduce triangles to about this fraction (over 0, up to 1): holes, borders between materials and "
      "seams are kept, and the remaining vertices keep normals, colours and texture coordinates");
  app.add_option(
      "--subdivide", arguments.subdivide,
      "Subdivide meshes into a smooth surface by loop:LEVELS (each triangle becomes four) or "
      "catmull-clark:LEVELS (each face becomes a quadrilateral per corner), LEVELS times (default 1); faces "
      "keep their materials");
  app.add_flag("--triangulate", arguments.triangulate, "Triangulate polygons");
  app.add_option(
      "--normals", arguments.normals,
      "Keep normals (keep), recompute smooth normals with creases at edges over an angle in degrees "
      "(smooth:ANGLE), or remove normals (flat)");
}

void add_placement_options(CLI::App& app, Arguments& arguments) {
  app.add_option("--up", arguments.up, "Up axis of the input; it becomes y")
      ->check(CLI::IsMember({"y", "z"}, CLI::ignore_case));
  std::vector<std::string> units;
  for (const LengthUnit& unit : length_units()) units.emplace_back(unit.name);
  app.add_option("--unit", arguments.unit, "Unit of the input's lengths; they become metres")
      ->check(CLI::IsMember(units, CLI::ignore_case));
  app.add_option("--scale", arguments.scale, "Scale factor, applied after --up and --unit");
  app.add_option(
      "--transform", arguments.transform,
      "Transform steps in order, applied after --scale, such as \"rotation 0 90 0 translation 1 0 0\"; "
      "rotations are in degrees about x, then y, then z; \"scale 1 2 1\" is a step too");
}

void define_conversion(CLI::App& app, Arguments& arguments) {
  app.description(
      "Converts models between GRF and other formats: grfconvert IN -o OUT, or grfconvert IN... -o FOLDER. "
      "Subcommands inspect, check and tidy files.");
  app.require_subcommand(0, 1);
  app.add_option("IN", arguments.inputs, "Input files");
  app.add_option(
      "-o,--output", arguments.output,
      "Output file, whose extension selects the format; an OP file, which has the cameras, with a "
      "GRF file of the same name beside it; or output folder (a name that ends in /, or with several "
      "inputs)");
  app.add_option("--to", arguments.to, "Output format, overriding the extension; default in a folder: grf")
      ->check(is_format_with(&Format::write));
  app.add_option(
         "--options", arguments.op_file,
         "OP file with the camera, film, environment map, depth and samples of a USD, pbrt or "
         "Mitsuba scene, or the cameras of a glTF scene; or give the OP file as the input, which names "
         "its scene")
      ->check(CLI::ExistingFile);
  app.add_option("--report", arguments.report,
                 "Page on what is kept and lost: small pictures of the input and of what comes back from the "
                 "output, their difference, and that of each surface's BRDF")
      ->type_name("PAGE.html|PAGE.md");
  app.add_flag("--flatten", arguments.flat, "Expand included files and BRDF files into one GRF file");
  app.add_flag("--grf2008", arguments.grf2008, "Write GRF in its grammar of 2008, without extensions");
  add_input_options(app, arguments);
  add_mesh_options(app, arguments);
  add_placement_options(app, arguments);
  app.add_option("--jobs", arguments.jobs, "Number of files to convert in parallel (0: one per core)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_limit_options(app, arguments);
  add_readable_option(app, arguments);
  app.add_flag("--dry-run", arguments.dry_run, "Read, convert and report everything, but write no files");
  app.add_flag("--progress", arguments.progress, "Show progress");
  add_quiet_option(app, arguments);
  add_json_option(app, arguments);
}

void define_info(CLI::App& app, Arguments& arguments) {
  CLI::App* info = app.add_subcommand("info", "Print statistics of a file");
  info->add_option("FILE", arguments.input, "File to read")->required();
  add_json_option(*info, arguments);
  add_input_options(*info, arguments);
  add_limit_options(*info, arguments);
  add_readable_option(*info, arguments);
  add_quiet_option(*info, arguments);
}

void define_check(CLI::App& app, Arguments& arguments) {
  CLI::App* check = app.add_subcommand("check", "Validate files");
  check->add_option("FILE", arguments.inputs, "Files to read")->required();
  check->add_flag(
      "--deep", arguments.deep,
      "Also rank what can make the image of a valid scene wrong or noisy: lamps in solids, inward "
      "fronts, energy gain, duplicates, meshes far from the middle of the scene");
  add_json_option(*check, arguments);
  add_limit_options(*check, arguments);
  add_readable_option(*check, arguments);
  add_quiet_option(*check, arguments);
}

void define_tidy(CLI::App& app, Arguments& arguments) {
  CLI::App* tidy = app.add_subcommand("tidy", "Reformat GRF files in the standard style");
  tidy->add_option("FILE", arguments.inputs, "Files to reformat")->required();
  add_limit_options(*tidy, arguments);
  add_readable_option(*tidy, arguments);
  add_quiet_option(*tidy, arguments);
}

void define_formats(CLI::App& app, Arguments& arguments) {
  CLI::App* formats = app.add_subcommand("formats", "List file formats, and what each keeps and loses");
  add_json_option(*formats, arguments);
}

/// Parses `--normals`; returns an error message, or an empty string.
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

/// Parses `--subdivide`; returns an error message, or an empty string.
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

/// Validates the numbers; returns an error message, or an empty string.
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

double metres_of(const std::string& name) {
  const auto units = length_units();
  const auto unit = std::find_if(units.begin(), units.end(), [&name](const LengthUnit& each) {
    return grf::same_keyword(each.name, name);
  });
  return unit->metres;
}

/// Returns the transform steps of `--up`, `--unit`, `--scale` and `--transform`.
std::vector<grf::TransformStep> placement_of(const Arguments& arguments, std::string& problem) {
  std::vector<grf::TransformStep> steps;
  if (arguments.up == "z") steps.push_back(z_up_to_y_up());
  for (const double scale : {metres_of(arguments.unit), arguments.scale}) {
    if (scale == 1) continue;
    steps.push_back({grf::TransformStep::Kind::Scale, grf::Vec3f(static_cast<float>(scale))});
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
  options.reading.variant = arguments.variant;
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
    problem = "no input file is given";
  } else if (arguments.output.empty()) {
    problem = "no output file is given (-o OUT)";
  } else {
    problem = problem_of_numbers(arguments);
    if (problem.empty()) problem = set_subdivision(arguments.subdivide, options.each.operations);
    if (problem.empty()) problem = set_normals(arguments.normals, options.each.operations);
  }
  if (problem.empty() && !arguments.report.empty() && arguments.inputs.size() > 1)
    problem = "--report is for one input file";
  if (problem.empty() && !arguments.report.empty() && arguments.dry_run)
    problem = "--report is about the written file, and --dry-run writes none";
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
  options.each.only = arguments.only;
  options.each.writing.op_file = arguments.op_file;
  options.each.report = arguments.report;
  options.each.operations.weld = arguments.weld;
  options.each.operations.smooth = arguments.smooth;
  options.each.operations.triangulate = arguments.triangulate;
  options.each.operations.decimate = arguments.decimate;
  options.dry_run = arguments.dry_run;
  options.each.quiet = arguments.quiet;
  options.each.json = arguments.json;
  return options;
}

}  // namespace convert
