// Manual pages and shell completions are made from the tables of a command line, so that they say what it
// takes.
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace command_line {

/// These texts complete a manual page, which has the options.
struct ManualText {
  std::string_view date;  ///< of the release, as 2026-11-28
  std::string_view version;
  std::string_view description;  ///< paragraphs separated by empty lines
  std::string_view examples;     ///< lines in pairs: what it does, and the command
  std::string_view see_also;     ///< such as `grf(5), wannabe(1)`
};

/// Returns the page in section 1 of a program with all of its subcommands, in the macros of man(7).
std::string manual_page(CLI::App& app, const ManualText& text);

/// Returns the page of a program in the web documentation: Markdown with lists of definitions, as MyST has
/// them.
std::string reference_page(CLI::App& app, const ManualText& text);

/// Returns a script that completes subcommands, options and their choices in a shell: `bash`, `zsh` or
/// `fish`. Other values are completed by names of files.
std::string completion(CLI::App& app, std::string_view shell);

/// Adds the option `--manual man|markdown|bash|zsh|fish`, which `--help` does not list: it prints one of
/// these, and ends the program as `--help` does.
void add_manual_option(CLI::App& app, const ManualText& text);

}  // namespace command_line
