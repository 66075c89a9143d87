// bpt: the path tracer's command line.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/command/render_command.h"
#include "renderer/options/render_options.h"

namespace {

using grf::ExitCode;

void add_render(CLI::App& app, command::RenderArguments& arguments) {
  CLI::App* render = app.add_subcommand("render", "Render a scene to an image");
  render->add_option("scene", arguments.scene, "an OP file, or a GRF scene")
      ->required()
      ->type_name("SCENE.op|SCENE.grf");
  for (const options::OptionInfo& option : options::option_table()) {
    if (option.flag.empty()) continue;
    const std::string flag(option.flag);
    if (flag == "--output") {
      render->add_option(flag, arguments.outputs, "the image; may be given again, for another type of file")
          ->type_name("path")
          ->allow_extra_args(false);
      continue;
    }
    render
        ->add_option_function<std::string>(
            flag, [&arguments, flag](const std::string& text) { arguments.flags[flag] = text; },
            fmt::format("{} ({})", option.meaning, option.default_value))
        ->type_name(std::string(option.values == "int int" ? "WxH" : option.values));
  }
  render->add_flag("--json", arguments.json, "print the summary as JSON");
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
  try {
    app.parse(with_command(argc, argv, app));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitCode::Done : ExitCode::BadCommandLine;
  }
  return command::render(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return static_cast<int>(run(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "bpt: {}\n", error.what());
    return static_cast<int>(ExitCode::BadInput);
  }
}
