#include "command_line/commands.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>

namespace command_line {
namespace {

/// Returns the name of an option's value without what CLI11 appends to it for each validator. The name itself
/// may have a colon, as `HH:MM` has.
std::string value_name_of(CLI::Option& option) {
  std::string name = option.get_type_name();
  std::size_t appended = 0;
  try {
    for (int i = 0;; ++i) {
      const std::string text = option.get_validator(i)->get_description();
      if (!text.empty()) appended += 1 + text.size();
    }
  } catch (const CLI::OptionNotFound&) {  // CLI11 has no count of them
  }
  name.resize(name.size() - std::min(appended, name.size()));
  return name;
}

/// Returns the words of a type such as `TEXT:{obj,ply}`; none if the option takes others, too.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  std::vector<std::string> choices;
  const std::size_t open = type.find(":{");
  const std::size_t close = type.find('}', open);
  if (open == std::string::npos || close == std::string::npos) return choices;
  std::istringstream list(type.substr(open + 2, close - open - 2));
  for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice);
  return choices;
}

CommandOption option_of(CLI::Option& option) {
  CommandOption result;
  for (const std::string& name : option.get_snames()) result.flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.flags.push_back("--" + name);
  const bool is_flag = option.get_items_expected_max() == 0;
  if (!is_flag) result.value = value_name_of(option);
  if (!is_flag) result.choices = choices_of(option);
  if (result.flags.empty()) result.value = option.get_single_name();
  result.description = option.get_description();
  result.is_required = option.get_required();
  return result;
}

void add(CLI::App& app, const std::string& before, std::vector<Command>& commands) {
  Command command;
  command.path = before.empty() ? app.get_name() : before + " " + app.get_name();
  command.description = app.get_description();
  for (CLI::Option* option : app.get_options()) {
    const bool is_hidden = option->get_group().empty();
    if (!is_hidden) command.options.push_back(option_of(*option));
  }
  const std::vector<CLI::App*> subcommands = app.get_subcommands([](CLI::App*) { return true; });
  for (CLI::App* subcommand : subcommands) command.subcommands.push_back(subcommand->get_name());
  const std::string path = command.path;
  commands.push_back(std::move(command));
  for (CLI::App* subcommand : subcommands) add(*subcommand, path, commands);
}

}  // namespace

std::vector<Command> commands_of(CLI::App& app) {
  std::vector<Command> commands;
  add(app, "", commands);
  return commands;
}

}  // namespace command_line
