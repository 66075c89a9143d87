#include "command_line/commands.h"

#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>

namespace command_line {
namespace {

/// Splits a type such as `TEXT:{obj,ply}` into the name of the value and its choices. Other validators, such
/// as ranges, are left out.
std::pair<std::string, std::vector<std::string>> value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  std::string type = option.get_type_name();
  std::vector<std::string> choices;
  const std::size_t open = type.find(":{");
  const std::size_t close = type.find('}', open);
  if (open != std::string::npos && close != std::string::npos) {
    std::istringstream list(type.substr(open + 2, close - open - 2));
    for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice);
  }
  // A value's name has no blank before a validator's text, but `X Y W H` is one name.
  const std::size_t end = type.find(':');
  if (end != std::string::npos && type.find("HOST:PORT") == std::string::npos) type.resize(end);
  return {type, choices};
}

CommandOption option_of(const CLI::Option& option) {
  CommandOption result;
  for (const std::string& name : option.get_snames()) result.flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.flags.push_back("--" + name);
  std::tie(result.value, result.choices) = value_of(option);
  if (result.flags.empty()) result.value = option.get_single_name();
  result.description = option.get_description();
  result.is_required = option.get_required();
  return result;
}

void add(const CLI::App& app, const std::string& before, std::vector<Command>& commands) {
  Command command;
  command.path = before.empty() ? app.get_name() : before + " " + app.get_name();
  command.description = app.get_description();
  for (const CLI::Option* option : app.get_options()) {
    const bool is_hidden = option->get_group().empty();
    if (!is_hidden) command.options.push_back(option_of(*option));
  }
  const std::vector<const CLI::App*> subcommands = app.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* subcommand : subcommands) command.subcommands.push_back(subcommand->get_name());
  const std::string path = command.path;
  commands.push_back(std::move(command));
  for (const CLI::App* subcommand : subcommands) add(*subcommand, path, commands);
}

}  // namespace

std::vector<Command> commands_of(const CLI::App& app) {
  std::vector<Command> commands;
  add(app, "", commands);
  return commands;
}

}  // namespace command_line
