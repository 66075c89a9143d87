#include "renderer/command/shared_options.h"

#include <cstdint>
#include <variant>

#include <fmt/format.h>

namespace command {
namespace {

/// Names the value in `--help`. A pair of numbers is one word on the command line, such as `640x480`.
std::string type_name_of(const options::OptionInfo& option) {
  if (std::holds_alternative<options::SizeOption>(option.value)) return "WxH";
  return options::word_count(option) == 2 ? "MxN" : std::string(option.values);
}

}  // namespace

void add_progress(CLI::App& command, std::string& progress) {
  command
      .add_option(
          "--progress", progress,
          "bar: a progress bar on standard error, if that is a terminal; json: one JSON object per line on "
          "standard output, up to four times per second, with done (0 to 1), seconds, seconds_left, "
          "estimated_error (null while unknown), image (null until it is written: the last line names it) "
          "and, of a render with a target error, forecasts as by --forecast; none (bar)")
      ->type_name("bar|json|none")
      ->check(CLI::IsMember({"bar", "json", "none"}));
}

void add_option(CLI::App& command, const options::OptionInfo& option, OptionFlags& flags) {
  const std::string flag(option.flag);
  command
      .add_option_function<std::string>(
          flag, [&flags, flag](const std::string& text) { flags[flag] = text; },
          fmt::format("{} ({})", option.meaning, option.default_value))
      ->type_name(type_name_of(option));
}

void add_scene_options(CLI::App& command, std::string& scene, OptionFlags& flags) {
  command.add_option("scene", scene, "an OP file or a GRF scene")
      ->required()
      ->type_name("SCENE.op|SCENE.grf");
  for (const options::OptionInfo& option : options::option_table()) {
    if (option.flag.empty() || option.flag == "--output") continue;
    if (std::holds_alternative<options::BooleanOption<bool>>(option.value)) {
      // `--irradiance` on its own, or `--irradiance=false` to override the OP file.
      const std::string flag(option.flag);
      command.add_flag_function(
          flag, [&flags, flag](std::int64_t count) { flags[flag] = count > 0 ? "true" : "false"; },
          std::string(option.meaning));
      continue;
    }
    add_option(command, option, flags);
  }
}

}  // namespace command
