// The subcommands and options of a command line, flat, for what is made from them.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace command_line {

struct CommandOption {
  std::vector<std::string> flags;    ///< with their hyphens, short ones first; empty: a positional argument
  std::string value;                 ///< name of its value, such as `FILE`; empty for flags
  std::vector<std::string> choices;  ///< the words that it takes, if it takes only some
  std::string description;
  bool is_required = false;
};

struct Command {
  std::string path;  ///< `bpt brdf eval`
  std::string description;
  std::vector<std::string> subcommands;  ///< names
  std::vector<CommandOption> options;    ///< without hidden ones
};

/// Returns the program itself, and then each subcommand before its own subcommands.
std::vector<Command> commands_of(CLI::App& app);

}  // namespace command_line
