#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command_line/commands.h"
#include "command_line/manual.h"

namespace command_line {
namespace {

std::vector<std::string> flags_of(const Command& command) {
  std::vector<std::string> flags;
  for (const CommandOption& option : command.options)
    flags.insert(flags.end(), option.flags.begin(), option.flags.end());
  return flags;
}

/// Quotes text for a shell, in which no character of it is special.
std::string shell_quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Returns bash's completion: the words before the cursor lead to a command, whose options and subcommands
/// are offered; after an option with choices these are, and files otherwise.
std::string bash(const std::vector<Command>& commands) {
  const std::string& program = commands.front().path;
  std::string words;
  std::string choices;
  std::string paths;
  for (const Command& command : commands) {
    paths += command.path + ";";
    std::vector<std::string> all = command.subcommands;
    const std::vector<std::string> flags = flags_of(command);
    all.insert(all.end(), flags.begin(), flags.end());
    words += fmt::format("    {}) words={} ;;\n", shell_quoted(command.path),
                         shell_quoted(fmt::format("{}", fmt::join(all, " "))));
    for (const CommandOption& option : command.options) {
      if (option.choices.empty()) continue;
      std::vector<std::string> cases;
      for (const std::string& flag : option.flags) cases.push_back(shell_quoted(command.path + " " + flag));
      choices += fmt::format("    {}) choices={} ;;\n", fmt::join(cases, "|"),
                             shell_quoted(fmt::format("{}", fmt::join(option.choices, " "))));
    }
  }
  return fmt::format(R"(# bash completion of {0}: {0} --manual bash
_{0}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} path={0} words= choices= word
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD - 1}}"; do
    case ";{1}" in
      *";$path $word;"*) path="$path $word" ;;
    esac
  done
  case $path in
{2}  esac
  case "$path $previous" in
{3}    *) ;;
  esac
  COMPREPLY=()
  if [ -n "$choices" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$current")
  elif [[ $current == -* || $words != -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  fi
}}
complete -o default -F _{0} {0}
)",
                     program, paths, words, choices);
}

/// Returns the first sentence of a description, for a list of completions.
std::string short_description(const std::string& text) {
  return text.substr(0, std::min(text.find_first_of(";:.("), text.size()));
}

/// Escapes what zsh's `_arguments` takes for the end of a description.
std::string zsh_description(const std::string& text) {
  std::string escaped;
  for (const char c : short_description(text)) {
    if (c == '[' || c == ']') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string zsh_function(const Command& command) {
  std::string name = command.path;
  std::replace(name.begin(), name.end(), ' ', '_');
  std::string text = fmt::format("_{}() {{\n  local state line\n  _arguments -C", name);
  for (const CommandOption& option : command.options) {
    std::string value;
    if (!option.value.empty()) {
      value = option.choices.empty()
                  ? fmt::format(":{}:_files", option.value.substr(0, option.value.find(':')))
                  : fmt::format(":value:({})", fmt::join(option.choices, " "));
    }
    for (const std::string& flag : option.flags) {
      text += " \\\n    " +
              shell_quoted(fmt::format("{}[{}]{}", flag, zsh_description(option.description), value));
    }
  }
  if (command.subcommands.empty()) return text + " \\\n    '*:file:_files'\n}\n";
  text += " \\\n    '1: :->command' \\\n    '*:: :->arguments'\n  case $state in\n    command) _alternative ";
  text += shell_quoted(fmt::format("commands:command:({})", fmt::join(command.subcommands, " "))) +
          " 'files:file:_files' ;;\n    arguments)\n      case $line[1] in\n";
  for (const std::string& subcommand : command.subcommands)
    text += fmt::format("        {}) _{}_{} ;;\n", subcommand, name, subcommand);
  return text + "        *) _files ;;\n      esac ;;\n  esac\n}\n";
}

std::string zsh(const std::vector<Command>& commands) {
  const std::string& program = commands.front().path;
  std::string text = fmt::format("#compdef {0}\n# zsh completion of {0}: {0} --manual zsh\n", program);
  for (const Command& command : commands) text += zsh_function(command);
  return text + fmt::format("_{} \"$@\"\n", program);
}

/// Returns fish's condition that a command, and none of its subcommands, was typed.
std::string fish_condition(const Command& command) {
  std::string condition;
  std::size_t at = command.path.find(' ');
  while (at != std::string::npos) {
    const std::size_t next = command.path.find(' ', at + 1);
    const std::string word = command.path.substr(at + 1, next == std::string::npos ? next : next - at - 1);
    condition += fmt::format("{}__fish_seen_subcommand_from {}", condition.empty() ? "" : "; and ", word);
    at = next;
  }
  if (!command.subcommands.empty()) {
    condition += fmt::format("{}not __fish_seen_subcommand_from {}", condition.empty() ? "" : "; and ",
                             fmt::join(command.subcommands, " "));
  }
  return condition;
}

std::string fish(const std::vector<Command>& commands) {
  const std::string& program = commands.front().path;
  std::string text = fmt::format("# fish completion of {0}: {0} --manual fish\n", program);
  for (const Command& command : commands) {
    const std::string begin =
        fmt::format("complete -c {} -n {}", program, shell_quoted(fish_condition(command)));
    for (const std::string& name : command.subcommands) {
      const auto meant = std::find_if(commands.begin(), commands.end(), [&](const Command& other) {
        return other.path == command.path + " " + name;
      });
      text +=
          fmt::format("{} -a {} -d {}\n", begin, name, shell_quoted(short_description(meant->description)));
    }
    for (const CommandOption& option : command.options) {
      if (option.flags.empty()) continue;
      std::string line = begin;
      for (const std::string& flag : option.flags)
        line += flag.starts_with("--") ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
      if (!option.value.empty()) line += option.choices.empty() ? " -r" : " -x";
      if (!option.choices.empty())
        line += " -a " + shell_quoted(fmt::format("{}", fmt::join(option.choices, " ")));
      text += line + " -d " + shell_quoted(short_description(option.description)) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string completion(CLI::App& app, std::string_view shell) {
  const std::vector<Command> commands = commands_of(app);
  if (shell == "bash") return bash(commands);
  return shell == "zsh" ? zsh(commands) : fish(commands);
}

}  // namespace command_line
