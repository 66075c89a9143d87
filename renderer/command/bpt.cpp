// bpt: the path tracer's command line.
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command_line/manual.h"
#include "confinement/confinement.h"
#include "renderer/command/bake_command.h"
#include "renderer/command/brdf_command.h"
#include "renderer/command/brdf_fit_options.h"
#include "renderer/command/compare_command.h"
#include "renderer/command/cost_command.h"
#include "renderer/command/decode_command.h"
#include "renderer/command/farm_command_line.h"
#include "renderer/command/merge_command.h"
#include "renderer/command/noise_command.h"
#include "renderer/command/pack_command.h"
#include "renderer/command/plan_command.h"
#include "renderer/command/render_command.h"
#include "renderer/command/shared_options.h"
#include "renderer/command/sky_command.h"
#include "renderer/options/render_options.h"

namespace {

using command::add_option;
using command::add_progress;
using command::add_scene_options;
using grf::ExitCode;

void add_noise(CLI::App& app, command::NoiseArguments& arguments) {
  CLI::App* noise =
      app.add_subcommand("noise", "Show which lamps, bounces and BRDFs the noise of an image comes from");
  add_scene_options(*noise, arguments.scene, arguments.flags);
  noise->add_flag("--try", arguments.tries,
                  "also measure what other sampling schemes, split counts and so on would do");
  noise->add_option("--change", arguments.change, "measure only this change, such as BPT_Branches=4");
  noise->add_option("--progress", arguments.progress, "json: print each result as a line when it is known")
      ->check(CLI::IsMember({"json", "none"}));
  noise->add_flag("--json", arguments.json, "print one JSON object");
}

void add_plan(CLI::App& app, command::PlanArguments& arguments) {
  CLI::App* plan = app.add_subcommand("plan", "Show which effects a render would use or leave out, and why");
  add_scene_options(*plan, arguments.scene, arguments.flags);
  add_progress(*plan, arguments.progress);
  plan->add_flag("--json", arguments.json, "print one JSON object; with --progress json, on one more line");
  CLI::Option* measure = plan->add_flag(
      "--measure", arguments.measures,
      "render a small image with and without each effect, and print the share of the time that "
      "it costs and the share of the light that it contributes, with 95 % intervals");
  plan->add_option("--measure-seconds", arguments.measurement.seconds,
                   "processor time per thread for all effects (20)")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.1, 1e6))
      ->needs(measure);
  plan->add_option("--measure-images", arguments.images,
                   "write the images to this folder, as EFFECT_full.exr and EFFECT_without.exr")
      ->type_name("FOLDER")
      ->needs(measure);
}

void add_render(CLI::App& app, command::RenderArguments& arguments) {
  CLI::App* render = app.add_subcommand("render", "Render a scene, or a job file of `bpt pack`, to an image");
  add_scene_options(*render, arguments.scene, arguments.flags);
  render
      ->add_option(
          "-o,--output", arguments.outputs,
          "output image; may be repeated for other file types; or a part file, FILE.part, with a part of "
          "the image's samples, for `bpt merge`")
      ->type_name("path")
      ->allow_extra_args(false);
  add_progress(*render, arguments.progress);
  render->add_flag("--json", arguments.json,
                   "print the summary as JSON; with --progress json, on one more line");
  render
      ->add_option(
          "--part", arguments.part.part,
          "render part K of N of the samples, all of nearly equal size; of an adaptive image, of its pilot, "
          "unless that is given")
      ->type_name("K/N");
  render
      ->add_option("--tiles", arguments.part.tiles,
                   "render these tiles of 16x16 pixels alone, row by row from 0")
      ->type_name("FIRST..LAST");
  render->add_option("--pilot", arguments.part.pilot, "part file with the pilot of an adaptive image")
      ->type_name("FILE.part");
  CLI::Option* forecast =
      render->add_flag("--forecast", arguments.forecasts,
                       "render no image, but forecast the time until errors of 5, 2 and 1 % and the target "
                       "error, with the interval that contains it with 90 % probability");
  render
      ->add_option("--forecast-seconds", arguments.forecast_seconds,
                   "processor time per thread of the probe for a forecast (2)")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.1, 3600.0))
      ->needs(forecast);
}

void add_pack(CLI::App& app, command::PackArguments& arguments) {
  CLI::App* pack = app.add_subcommand(
      "pack", "Pack a scene with all files that it reads into one job file, which `bpt render` takes");
  add_scene_options(*pack, arguments.scene, arguments.flags);
  pack->add_option("-o,--output", arguments.output,
                   "job file (the scene's name with .grfjob, in the current folder)")
      ->type_name("FILE.grfjob");
  pack->add_flag("--json", arguments.json, "print one JSON object");
}

void add_merge(CLI::App& app, command::MergeArguments& arguments) {
  CLI::App* merge = app.add_subcommand(
      "merge", "Merge parts of an image or a bake, made anywhere, to what one process would make");
  merge->add_option("parts", arguments.parts, "part files, in any order")
      ->required()
      ->type_name("FILE.part...");
  merge
      ->add_option(
          "-o,--output", arguments.outputs,
          "output image, or the IGRF file of a bake; images may be repeated for other file types; or a part "
          "file with all that the parts have")
      ->type_name("path")
      ->allow_extra_args(false);
  merge->add_flag(
      "--missing", arguments.lists_missing,
      "print which samples no part has, as flags of `bpt render` or `bpt bake`; the exit code is 1 if there "
      "are any");
  merge->add_flag("--json", arguments.json, "print one JSON object");
}

/// A bake takes the render options that control light transport, sampling and termination.
void add_bake(CLI::App& app, command::BakeArguments& arguments) {
  CLI::App* bake = app.add_subcommand(
      "bake", "Bake the irradiance at the vertices of a scene, and write both as an IGRF file");
  bake->add_option("scene", arguments.scene, "an OP file or a GRF scene")
      ->required()
      ->type_name("SCENE.op|SCENE.grf");
  bake->add_option("-o,--output", arguments.output, "output file; included files are merged into it")
      ->required()
      ->type_name("FILE.igrf|FILE.part");
  bake->add_option("--part", arguments.part.part,
                   "bake each N-th vertex, from vertex K on, to a part file for `bpt merge`: its pilot of 64 "
                   "samples, unless that is given")
      ->type_name("K/N");
  bake->add_option("--pilot", arguments.part.pilot,
                   "part file with the pilot of all vertices, which places the other samples")
      ->type_name("FILE.part");
  bake->add_option("--directions", arguments.directions,
                   "number of directions per vertex: write irradiance per direction, in cells of equal "
                   "cosine-weighted solid angle that sum to the total, instead of one value per vertex")
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
                 "print the summary as JSON; with --progress json, on one more line");
}

void add_sample(CLI::App& sample, command::BrdfArguments& arguments) {
  sample.add_option("--pdf", arguments.pdf, "sampling scheme, such as \"hemisphere exp=20\"")->required();
  sample.add_option("--u", arguments.view, "view direction, in radians")
      ->type_name("THETA[,PHI]")
      ->required();
  sample.add_option("--count", arguments.count, "number of samples (1000)")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000'000));
  sample.add_option("--seed", arguments.seed, "random seed (0)")->type_name("S");
  sample.add_option("--fit", arguments.fit, "FIT file to write the directions and BRDF values to")
      ->type_name("FILE");
}

void add_export(CLI::App& table, command::BrdfArguments& arguments) {
  table.add_option("-o,--output", arguments.output, "output file, of MERL (.binary) or RGL (.bsdf)")
      ->type_name("FILE.binary|FILE.bsdf")
      ->required();
  table
      .add_option(
          "--for", arguments.reader,
          "reader of an RGL file: pbrt and mitsuba-spectral take spectra, mitsuba RGB (spectra if the BRDF "
          "has wavelengths)")
      ->check(CLI::IsMember({"pbrt", "mitsuba", "mitsuba-spectral"}));
  table
      .add_option_function<std::string>(
          "--resolution",
          [&arguments](const std::string& text) {
            arguments.resolution.reset();
            if (text != "auto") arguments.resolution = std::stod(text);
          },
          "factor of the nodes along each axis of an RGL file, or auto: as many as --error needs (1)")
      ->type_name("N|auto")
      ->check(CLI::Range(0.1, 4.0) | CLI::IsMember({"auto"}));
  table
      .add_option("--error", arguments.largest_error,
                  "largest mean error for --resolution auto, as a fraction of the mean value (0.02)")
      ->type_name("E")
      ->check(CLI::Range(1e-6, 1.0));
}

void add_brdf(CLI::App& app, command::BrdfArguments& arguments, command::BrdfFitArguments& fit_arguments) {
  CLI::App* brdf =
      app.add_subcommand("brdf", "Evaluate, sample, check, plot, export or fit a BRDF without a scene");
  brdf->require_subcommand(1);
  const auto add_command = [&](const char* name, const char* meaning, bool has_instance) {
    CLI::App* command = brdf->add_subcommand(name, meaning);
    if (has_instance) {
      command
          ->add_option(
              "INSTANCE", arguments.instance,
              "a BRDF such as \"ward sx=0.2 ks=0.4\", a file that holds one or measured data (.binary of "
              "MERL, .bsdf of RGL, Zemax or LightTools, .bin of UTIA, .astm, .csv), or the name of one "
              "that a scene defines, such as scene.grf:varnish")
          ->required();
    }
    command->add_flag("--json", arguments.json, "print one JSON object");
    return command;
  };
  add_command("list", "List all BRDF models and their parameters", false);
  CLI::App* eval = add_command("eval", "Evaluate the BRDF, in 1/sr", true);
  eval->add_option(
          "--u", arguments.view,
          "view direction, in radians; without it, lines of four angles are read from standard input")
      ->type_name("THETA,PHI");
  eval->add_option("--v", arguments.light, "light direction, in radians")->type_name("THETA,PHI");
  eval->add_option("--wavelengths", arguments.wavelengths,
                   "wavelengths in nm to evaluate he, westin, thinfilm or spectral rgl data at (their own)")
      ->type_name("NM,...")
      ->delimiter(',')
      ->check(CLI::Range(1.0, 1e6));
  CLI::App* albedo = add_command("albedo", "Compute the directional albedo", true);
  albedo->add_option("--u", arguments.view, "view direction, in radians")
      ->type_name("THETA[,PHI]")
      ->required();
  add_sample(*add_command("sample", "Sample directions by a sampling scheme", true), arguments);
  add_export(*add_command("export", "Tabulate the BRDF in the format of the MERL or the RGL data base", true),
             arguments);
  add_command("check", "Check reciprocity, energy, holes and negative values, of measured data above all",
              true)
      ->add_option("-o,--output", arguments.output, "picture of where they are not as they should be")
      ->type_name("FILE.svg|FILE.png|FILE.pdf");
  add_command("glsl",
              "Print the BRDF as a GLSL function for shaders; with --json, also its parameters' values",
              true);
  CLI::App* plot =
      add_command("plot", "Plot lobes, albedo and a lit sphere; with --pdf, a sampling scheme's pdf", true);
  plot->add_option("-o,--output", arguments.output, "output file")
      ->type_name("FILE.svg|FILE.png|FILE.pdf")
      ->required();
  CLI::Option* pdf = plot->add_option("--pdf", arguments.pdf,
                                      "sampling scheme: plot its pdf, samples and weights for the BRDF");
  plot->add_option("--u", arguments.views,
                   "view direction, in radians, for --pdf; may be repeated (0, 45 and 80 degrees)")
      ->type_name("THETA[,PHI]")
      ->allow_extra_args(false)
      ->needs(pdf);
  command::add_fit(*brdf, fit_arguments);
}

ExitCode run_brdf(const CLI::App& brdf, const command::BrdfArguments& arguments,
                  const command::BrdfFitArguments& fit_arguments) {
  if (brdf.got_subcommand("fit")) return command::fit_brdfs(fit_arguments);
  if (brdf.got_subcommand("list")) return command::list_brdfs(arguments);
  if (brdf.got_subcommand("eval")) return command::evaluate_brdf(arguments);
  if (brdf.got_subcommand("albedo")) return command::print_albedo(arguments);
  if (brdf.got_subcommand("sample")) return command::sample_brdf(arguments);
  if (brdf.got_subcommand("export")) return command::export_brdf(arguments);
  if (brdf.got_subcommand("check")) return command::check_brdf(arguments);
  if (brdf.got_subcommand("glsl")) return command::print_glsl(arguments);
  return command::plot_brdf(arguments);
}

void add_compare(CLI::App& app, command::CompareArguments& arguments) {
  CLI::App* compare = app.add_subcommand("compare", "Compute the error of an image against a reference");
  compare->add_option("A", arguments.image, "the image: exr, hdr, pfm, raw, png, jpg, tga or webp")
      ->required();
  compare->add_option("B", arguments.reference, "the reference image, of the same size")->required();
  compare->add_option("--exposure", arguments.exposure, "exposure in stops with which the images are seen");
  compare
      ->add_option("--pixels-per-degree", arguments.pixels_per_degree,
                   "pixels per degree of visual angle: 40 for a full HD screen of 24 inches from 63 cm")
      ->check(CLI::Range(1.0, 1000.0));
  compare->add_flag("--json", arguments.json, "print one JSON object");
}

void add_decode(CLI::App& app, command::DecodeArguments& arguments) {
  CLI::App* decode =
      app.add_subcommand("decode", "Decode an image and write it to standard output as a raw file");
  decode->add_option("IMAGE", arguments.image, "the image: exr, hdr, pfm, raw, png, jpg, tga or webp")
      ->required();
  decode->add_flag(
      "--layers", arguments.has_layers,
      "append the layers of an exr: for each, the lengths of its name and of its channels' letters "
      "as little-endian uint32, the name, the letters, and the values pixel by pixel");
  decode->add_flag(
      "--alpha", arguments.has_alpha,
      "append the alpha of an image that has it as such a layer, `A`; colours are multiplied by it");
}

void add_sky(CLI::App& app, command::SkyArguments& arguments) {
  CLI::App* sky = app.add_subcommand(
      "sky",
      "Make an environment map of the clear sky and the sun at a place and a time (Preetham et al. 1999)");
  sky->add_option("--latitude", arguments.latitude, "degrees, north is positive")
      ->type_name("DEG")
      ->required();
  sky->add_option("--longitude", arguments.longitude, "degrees, east is positive")
      ->type_name("DEG")
      ->required();
  sky->add_option("--date", arguments.date, "the day, from 1950 to 2050")
      ->type_name("YYYY-MM-DD")
      ->required();
  sky->add_option("--time", arguments.time, "the local time")->type_name("HH:MM")->required();
  sky->add_option("--utc-offset", arguments.utc_offset,
                  "of the local time, in hours, positive in the east (0)")
      ->type_name("H");
  sky->add_option("--turbidity", arguments.turbidity, "of the air, from clear, 2, to hazy, 6 (3)")
      ->type_name("T");
  sky->add_option("--north", arguments.north,
                  "direction of north: degrees from -z, counter-clockwise seen from above (0)")
      ->type_name("DEG");
  sky->add_option("--width", arguments.width, "of the map in texels, twice its height (1024)")
      ->type_name("N");
  sky->add_option("-o,--output", arguments.output, "output image; its luminance is in kcd/m2")
      ->type_name("FILE.exr")
      ->required();
  sky->add_flag("--json", arguments.json, "print one JSON object");
}

/// A cost study takes the render options that are neither swept nor control termination and output.
void add_cost(CLI::App& app, command::CostArguments& arguments) {
  CLI::App* cost = app.add_subcommand(
      "cost", "Measure error against render time at growing sample counts, and fit convergence curves");
  cost->add_option("scene", arguments.scene, "an OP file or a GRF scene")
      ->required()
      ->type_name("SCENE.op|SCENE.grf");
  cost->add_option(
          "--samples", arguments.samples,
          "ascending numbers of samples per pixel (4,16,64,256); for naive, paths per pixel, divided evenly "
          "among the camera rays (BPT_Pixel_SampleRes, one by default): NSecRaysRoot^2 for each")
      ->type_name("N,N,...");
  for (const command::SweepAxis& axis : command::sweep_axes()) {
    const std::string flag(axis.flag);
    cost->add_option_function<std::string>(
            flag, [&arguments, flag](const std::string& list) { arguments.sweeps[flag] = list; },
            fmt::format("one line of the chart per value: {}", axis.meaning))
        ->type_name(std::string(axis.values));
  }
  cost->add_option("--reference", arguments.reference, "reference image, instead of rendering one")
      ->type_name("FILE");
  cost->add_option("--reference-samples", arguments.reference_samples,
                   "samples per pixel of the rendered reference (16 times the most)")
      ->type_name("N")
      ->check(CLI::Range(2, std::numeric_limits<int>::max()));
  cost->add_option("--rounds", arguments.rounds,
                   "renders per row, with different seeds: the least time and the mean error count (2)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  cost->add_option("--crop", arguments.crop,
                   "measure only these pixels of the image: x and y of the upper left, width and height")
      ->type_name("X Y W H")
      ->expected(4);
  cost->add_option("--part", arguments.part,
                   "measure each N-th line of the study, from line K on, against a --reference: parts from "
                   "machines of one kind become a study by --continue")
      ->type_name("K/N");
  cost->add_option("--continue", arguments.continued,
                   "keep the rows of an earlier study, and measure only missing rows and rounds; may be "
                   "repeated for the parts of one")
      ->type_name("BASE.json")
      ->allow_extra_args(false);
  cost->add_option("-o,--output", arguments.output,
                   "write BASE.csv, BASE.md, BASE.svg and BASE.json, and the rendered reference, "
                   "BASE-reference.pfm (the scene's name with -cost)")
      ->type_name("BASE");
  for (const options::OptionInfo& option : options::option_table()) {
    for (const char* flag : {"--size", "--environment", "--ris", "--seed", "--threads"}) {
      if (option.flag == flag) add_option(*cost, option, arguments.flags);
    }
  }
  add_progress(*cost, arguments.progress);
  cost->add_flag("--json", arguments.json, "print one JSON object");
}

/// Inserts the command `render` where none is given: `bpt scene.op` renders, as the thesis' BPT did.
std::vector<std::string> with_command(int argc, char** argv, CLI::App& app) {
  std::vector<std::string> words(argv + 1, argv + argc);
  const auto is_command = [&](const std::string& word) {
    return !app.get_subcommands([&](const CLI::App* command) { return command->get_name() == word; }).empty();
  };
  const bool names_a_file = !words.empty() && !words[0].starts_with('-') && !is_command(words[0]);
  if (names_a_file) words.insert(words.begin(), "render");
  return {words.rbegin(), words.rend()};  // CLI11 parses them from the back
}

constexpr command_line::ManualText Manual = {
    .date = GRANADA_DATE,
    .version = GRANADA_VERSION,
    .description =
        "bpt renders scenes of the format GRF by path tracing: meshes whose faces have a BRDF, a sampling "
        "scheme, a "
        "colour and emitted light. It also measures what accuracy costs in time, shows which effects a scene "
        "calls "
        "for, and evaluates, samples and plots BRDFs without a scene.\n\n"
        "Without a command, bpt SCENE is bpt render SCENE. Render options are in OP files; options of the "
        "command "
        "line override them.",
    .examples =
        "Render a scene with the options of an OP file\nbpt scene.op\n"
        "Render a small preview\nbpt render scene.op --size 320x240 --samples 16 -o preview.png\n"
        "Stop at an error of 2 %\nbpt render scene.op --target-error 0.02\n"
        "Forecast how long that takes\nbpt render scene.op --forecast\n"
        "Plot a BRDF\nbpt brdf plot 'ward sx=0.2' -o ward.svg\n",
    .see_also = "grfconvert(1), wannabe(1), grf(5), op(5)",
};

ExitCode run(int argc, char** argv) {
  CLI::App app("Granada's path tracer", "bpt");
  app.require_subcommand(1);
  command::RenderArguments arguments;
  add_render(app, arguments);
  command::PackArguments pack_arguments;
  add_pack(app, pack_arguments);
  command::MergeArguments merge_arguments;
  add_merge(app, merge_arguments);
  command::FarmCommandLine farm_command_line(app);
  command::BakeArguments bake_arguments;
  add_bake(app, bake_arguments);
  command::PlanArguments plan_arguments;
  add_plan(app, plan_arguments);
  command::NoiseArguments noise_arguments;
  add_noise(app, noise_arguments);
  command::BrdfArguments brdf_arguments;
  command::BrdfFitArguments fit_arguments;
  add_brdf(app, brdf_arguments, fit_arguments);
  command::CompareArguments compare_arguments;
  add_compare(app, compare_arguments);
  command::DecodeArguments decode_arguments;
  add_decode(app, decode_arguments);
  command::CostArguments cost_arguments;
  add_cost(app, cost_arguments);
  command::SkyArguments sky_arguments;
  add_sky(app, sky_arguments);
  app.set_version_flag("--version", [] {
    return fmt::format(
        "bpt {} (GPL-3.0; its sources are under Apache-2.0)\nLibraries: {}\nDecoding of untrusted images: {}",
        GRANADA_VERSION, GRANADA_LIBRARIES, confinement::description(confinement::available()));
  });
  command_line::add_manual_option(app, Manual);
  try {
    app.parse(with_command(argc, argv, app));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitCode::Done : ExitCode::BadCommandLine;
  }
  if (app.got_subcommand("brdf")) return run_brdf(*app.get_subcommand("brdf"), brdf_arguments, fit_arguments);
  if (app.got_subcommand("compare")) return command::compare(compare_arguments);
  if (app.got_subcommand("decode")) {
    // Without exit handlers: that of LeakSanitizer would start a process, which the confinement forbids.
    std::_Exit(static_cast<int>(command::decode(decode_arguments)));
  }
  if (app.got_subcommand("cost")) return command::cost(cost_arguments);
  if (app.got_subcommand("noise")) return command::noise(noise_arguments);
  if (app.got_subcommand("sky")) return command::sky(sky_arguments);
  if (app.got_subcommand("plan")) return command::plan(plan_arguments);
  if (app.got_subcommand("pack")) return command::pack(pack_arguments);
  if (app.got_subcommand("merge")) return command::merge(merge_arguments);
  if (app.got_subcommand("farm")) return farm_command_line.run();
  if (app.got_subcommand("bake")) return command::bake(bake_arguments);
  return command::render(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit makes writing fail; it does not kill the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return static_cast<int>(run(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "bpt: {}\n", error.what());
    return static_cast<int>(ExitCode::BadInput);
  }
}
