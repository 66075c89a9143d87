// bpt: the path tracer's command line.
#include <csignal>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/command/bake_command.h"
#include "renderer/command/brdf_command.h"
#include "renderer/command/compare_command.h"
#include "renderer/command/cost_command.h"
#include "renderer/command/plan_command.h"
#include "renderer/command/render_command.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/image/image_encoders.h"

namespace {

using grf::ExitCode;

/// Two numbers are one word of the command line.
std::string type_name_of(const options::OptionInfo& option) {
  if (std::holds_alternative<options::SizeOption>(option.value)) return "WxH";
  return options::word_count(option) == 2 ? "MxN" : std::string(option.values);
}

void add_progress(CLI::App& command, std::string& progress) {
  command
      .add_option(
          "--progress", progress,
          "bar: on standard error, if that is a terminal; json: up to four times a second a line on "
          "standard output, an object of done (0 to 1), seconds, seconds_left, estimated_error (null "
          "while unknown) and image (null until it is written, which the last line tells); none (bar)")
      ->type_name("bar|json|none")
      ->check(CLI::IsMember({"bar", "json", "none"}));
}

/// A flag that a render and a bake have in common.
void add_option(CLI::App& command, const options::OptionInfo& option, command::OptionFlags& flags) {
  const std::string flag(option.flag);
  command
      .add_option_function<std::string>(
          flag, [&flags, flag](const std::string& text) { flags[flag] = text; },
          fmt::format("{} ({})", option.meaning, option.default_value))
      ->type_name(type_name_of(option));
}

/// The scene, and all flags of the table but that of the image.
void add_scene_options(CLI::App& command, std::string& scene, command::OptionFlags& flags) {
  command.add_option("scene", scene, "an OP file, or a GRF scene")
      ->required()
      ->type_name("SCENE.op|SCENE.grf");
  for (const options::OptionInfo& option : options::option_table()) {
    if (option.flag.empty() || option.flag == "--output") continue;
    if (std::holds_alternative<options::BooleanOption<bool>>(option.value)) {
      // `--irradiance` alone, or `--irradiance=false` against what the file says.
      const std::string flag(option.flag);
      command.add_flag_function(
          flag, [&flags, flag](std::int64_t count) { flags[flag] = count > 0 ? "true" : "false"; },
          std::string(option.meaning));
      continue;
    }
    add_option(command, option, flags);
  }
}

void add_plan(CLI::App& app, command::PlanArguments& arguments) {
  CLI::App* plan = app.add_subcommand("plan", "Say what a render would do, what it would leave out, and why");
  add_scene_options(*plan, arguments.scene, arguments.flags);
  plan->add_flag("--json", arguments.json, "print one JSON object");
}

void add_render(CLI::App& app, command::RenderArguments& arguments) {
  CLI::App* render = app.add_subcommand("render", "Render a scene to an image");
  add_scene_options(*render, arguments.scene, arguments.flags);
  render->add_option("--output", arguments.outputs, "the image; may be given again, for another type of file")
      ->type_name("path")
      ->allow_extra_args(false);
  add_progress(*render, arguments.progress);
  render->add_flag("--json", arguments.json,
                   "print the summary as JSON; after --progress json as one more line");
}

/// Of the options for images, a bake takes those that say how light is estimated and for how long.
void add_bake(CLI::App& app, command::BakeArguments& arguments) {
  CLI::App* bake = app.add_subcommand(
      "bake", "Estimate what arrives at the vertices of a scene, and write both as an IGRF file");
  bake->add_option("scene", arguments.scene, "an OP file, or a GRF scene")
      ->required()
      ->type_name("SCENE.op|SCENE.grf");
  bake->add_option("-o,--output", arguments.output, "the file to write; included files are written into it")
      ->required()
      ->type_name("FILE.igrf");
  bake->add_option("--directions", arguments.directions,
                   "write a list of so many directions for each vertex, in place of one value: cells of "
                   "equal cosine-weighted solid angle, whose values add up to it")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  for (const options::OptionInfo& option : options::option_table()) {
    for (const char* flag : {"--samples", "--target-error", "--time", "--depth", "--seed", "--threads",
                             "--environment", "--checkpoint", "--pdf"}) {
      if (option.flag == flag) add_option(*bake, option, arguments.flags);
    }
  }
  add_progress(*bake, arguments.progress);
  bake->add_flag("--json", arguments.json,
                 "print the summary as JSON; after --progress json as one more line");
}

void add_sample(CLI::App& sample, command::BrdfArguments& arguments) {
  sample.add_option("--pdf", arguments.pdf, "the scheme, such as \"hemisphere exp=20\"")->required();
  sample.add_option("--u", arguments.view, "direction to the eye, in radians")
      ->type_name("THETA[,PHI]")
      ->required();
  sample.add_option("--count", arguments.count, "samples to draw (1000)")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000'000));
  sample.add_option("--seed", arguments.seed, "another seed draws other samples (0)")->type_name("S");
  sample.add_option("--fit", arguments.fit, "a FIT file to write the directions to, with the BRDF's values")
      ->type_name("FILE");
}

void add_brdf(CLI::App& app, command::BrdfArguments& arguments) {
  CLI::App* brdf = app.add_subcommand("brdf", "Look at a BRDF without a scene");
  brdf->require_subcommand(1);
  const auto add_command = [&](const char* name, const char* meaning, bool has_instance) {
    CLI::App* command = brdf->add_subcommand(name, meaning);
    if (has_instance) {
      command
          ->add_option("INSTANCE", arguments.instance,
                       "such as \"ward sx=0.2 ks=0.4\", or a file that holds one")
          ->required();
    }
    command->add_flag("--json", arguments.json, "print one JSON object");
    return command;
  };
  add_command("list", "All models and their parameters", false);
  CLI::App* eval = add_command("eval", "Values in 1/sr", true);
  eval->add_option("--u", arguments.view,
                   "direction to the eye; without it, lines of four angles from standard input")
      ->type_name("THETA,PHI");
  eval->add_option("--v", arguments.light, "direction to the light, in radians")->type_name("THETA,PHI");
  CLI::App* albedo = add_command("albedo", "The share of light that is reflected", true);
  albedo->add_option("--u", arguments.view, "direction, in radians")->type_name("THETA[,PHI]")->required();
  add_sample(*add_command("sample", "Directions that a sampling scheme draws", true), arguments);
  CLI::App* table = add_command("export", "A table of its values, in the format of the MERL data base", true);
  table->add_option("-o,--output", arguments.output, "file to write")->type_name("FILE.binary")->required();
  CLI::App* plot =
      add_command("plot", "A picture: lobes, albedo and a lit sphere; or how a scheme samples it", true);
  plot->add_option("-o,--output", arguments.output, "file to write")
      ->type_name("FILE.svg|FILE.png")
      ->required();
  CLI::Option* pdf = plot->add_option("--pdf", arguments.pdf,
                                      "a sampling scheme: the picture is of what it draws from the BRDF");
  plot->add_option("--u", arguments.views,
                   "direction to the eye, in radians, for --pdf; may be given again (0, 45 and 80 degrees)")
      ->type_name("THETA[,PHI]")
      ->allow_extra_args(false)
      ->needs(pdf);
}

ExitCode run_brdf(const CLI::App& brdf, const command::BrdfArguments& arguments) {
  if (brdf.got_subcommand("list")) return command::list_brdfs(arguments);
  if (brdf.got_subcommand("eval")) return command::evaluate_brdf(arguments);
  if (brdf.got_subcommand("albedo")) return command::print_albedo(arguments);
  if (brdf.got_subcommand("sample")) return command::sample_brdf(arguments);
  if (brdf.got_subcommand("export")) return command::export_brdf(arguments);
  return command::plot_brdf(arguments);
}

void add_compare(CLI::App& app, command::CompareArguments& arguments) {
  CLI::App* compare = app.add_subcommand("compare", "How far an image is from a reference");
  compare->add_option("A", arguments.image, "the image: exr, hdr, pfm, raw, png, jpg or tga")->required();
  compare->add_option("B", arguments.reference, "the reference, of the same size")->required();
  compare->add_flag("--json", arguments.json, "print one JSON object");
}

void add_decode(CLI::App& app, std::string& image) {
  CLI::App* decode =
      app.add_subcommand("decode", "Write the pixels of an image to standard output, as a raw file has them");
  decode->add_option("IMAGE", image, "exr, hdr, pfm, raw, png, jpg or tga")->required();
}

/// For programs that leave images of strangers to a process of its own: what is wrong with one is said
/// without its name.
ExitCode decode(const std::string& path) {
  const auto fail = [](const std::string& why) {
    fmt::print(stderr, "{}\n", why);
    return ExitCode::BadInput;
  };
  try {
    grf::Diagnostics diagnostics;
    const auto image = transport::read_image(path, diagnostics);
    if (!image) return fail(diagnostics.entries().front().message);
    const std::string bytes = transport::encode_raw({*image});
    const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
    return is_written && std::fflush(stdout) == 0 ? ExitCode::Done
                                                  : fail("cannot write the image to standard output");
  } catch (const std::bad_alloc&) {
    return fail("cannot read the image: it needs more memory than there is");
  }
}

/// Of the options for images, those that are neither swept nor say how much is rendered or written.
void add_cost(CLI::App& app, command::CostArguments& arguments) {
  CLI::App* cost = app.add_subcommand(
      "cost", "What accuracy costs in time: the error of growing numbers of samples, and fitted curves");
  cost->add_option("scene", arguments.scene, "an OP file, or a GRF scene")
      ->required()
      ->type_name("SCENE.op|SCENE.grf");
  cost->add_option(
          "--samples", arguments.samples,
          "numbers of samples a pixel that grow (4,16,64,256); with naive, of paths: a ray from the eye "
          "(BPT_Pixel_SampleRes, else one a pixel) has its share of them, which is NSecRaysRoot^2")
      ->type_name("N,N,...");
  for (const command::SweepAxis& axis : command::sweep_axes()) {
    const std::string flag(axis.flag);
    cost->add_option_function<std::string>(
            flag, [&arguments, flag](const std::string& list) { arguments.sweeps[flag] = list; },
            fmt::format("a line each: {}", axis.meaning))
        ->type_name(std::string(axis.values));
  }
  cost->add_option("--reference", arguments.reference, "the right image, instead of a longer render")
      ->type_name("FILE");
  cost->add_option("--reference-samples", arguments.reference_samples,
                   "samples a pixel of the render that serves as reference (16 times the most)")
      ->type_name("N")
      ->check(CLI::Range(2, std::numeric_limits<int>::max()));
  cost->add_option(
          "--rounds", arguments.rounds,
          "how often each row is rendered, with other seeds: the least time and the mean error count (2)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  cost->add_option("-o,--output", arguments.output,
                   "writes BASE.csv, BASE.md and BASE.svg (the scene's name with -cost)")
      ->type_name("BASE");
  for (const options::OptionInfo& option : options::option_table()) {
    for (const char* flag : {"--size", "--environment", "--ris", "--seed", "--threads"}) {
      if (option.flag == flag) add_option(*cost, option, arguments.flags);
    }
  }
  add_progress(*cost, arguments.progress);
  cost->add_flag("--json", arguments.json, "print one JSON object");
}

/// `bpt scene.op` renders, as the thesis' BPT did.
std::vector<std::string> with_command(int argc, char** argv, CLI::App& app) {
  std::vector<std::string> words(argv + 1, argv + argc);
  const auto is_command = [&](const std::string& word) {
    return !app.get_subcommands([&](const CLI::App* command) { return command->get_name() == word; }).empty();
  };
  const bool names_a_file = !words.empty() && !words[0].starts_with('-') && !is_command(words[0]);
  if (names_a_file) words.insert(words.begin(), "render");
  return {words.rbegin(), words.rend()};  // CLI11 takes them from the back
}

ExitCode run(int argc, char** argv) {
  CLI::App app("Granada's path tracer", "bpt");
  app.require_subcommand(1);
  command::RenderArguments arguments;
  add_render(app, arguments);
  command::BakeArguments bake_arguments;
  add_bake(app, bake_arguments);
  command::PlanArguments plan_arguments;
  add_plan(app, plan_arguments);
  command::BrdfArguments brdf_arguments;
  add_brdf(app, brdf_arguments);
  command::CompareArguments compare_arguments;
  add_compare(app, compare_arguments);
  std::string decoded_image;
  add_decode(app, decoded_image);
  command::CostArguments cost_arguments;
  add_cost(app, cost_arguments);
  app.set_version_flag("--version", "bpt " GRANADA_VERSION);
  try {
    app.parse(with_command(argc, argv, app));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitCode::Done : ExitCode::BadCommandLine;
  }
  if (app.got_subcommand("brdf")) return run_brdf(*app.get_subcommand("brdf"), brdf_arguments);
  if (app.got_subcommand("compare")) return command::compare(compare_arguments);
  if (app.got_subcommand("decode")) return decode(decoded_image);
  if (app.got_subcommand("cost")) return command::cost(cost_arguments);
  if (app.got_subcommand("plan")) return command::plan(plan_arguments);
  if (app.got_subcommand("bake")) return command::bake(bake_arguments);
  return command::render(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  // A file that grows over a limit is one that cannot be written, and not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return static_cast<int>(run(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "bpt: {}\n", error.what());
    return static_cast<int>(ExitCode::BadInput);
  }
}
