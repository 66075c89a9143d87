#include "command_line/manual.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command_line/commands.h"

namespace command_line {
namespace {

/// Escapes text for roff: hyphens are those of commands, and a line that begins with a dot is no request.
std::string roff(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const bool begins_line = escaped.empty() || escaped.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else if (c == '`') {
      escaped += "\\(ga";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

std::string paragraphs(std::string_view text) {
  std::string out;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) out += line.empty() ? ".PP\n" : roff(line) + "\n";
  return out;
}

/// Returns `bpt render [OPTIONS] SCENE`.
std::string synopsis_of(const Command& command) {
  std::string line = fmt::format("\\fB{}\\fP", roff(command.path));
  line += " [\\fIOPTION\\fP...]";
  for (const CommandOption& option : command.options) {
    if (!option.flags.empty()) continue;
    const std::string name = fmt::format("\\fI{}\\fP", roff(option.value));
    line += option.is_required ? " " + name : " [" + name + "]";
  }
  return line + "\n";
}

std::string option_text(const CommandOption& option) {
  std::string head;
  for (const std::string& flag : option.flags) {
    head += fmt::format("{}\\fB{}\\fP", head.empty() ? "" : ", ", roff(flag));
  }
  if (!option.value.empty()) head += fmt::format("{}\\fI{}\\fP", head.empty() ? "" : " ", roff(option.value));
  std::string text = fmt::format(".TP\n{}\n{}\n", head, roff(sentence(option.description)));
  if (!option.choices.empty())
    text += fmt::format("One of {}.\n", roff(fmt::format("{}", fmt::join(option.choices, ", "))));
  return text;
}

std::string options_text(const Command& command) {
  std::string text;
  for (const CommandOption& option : command.options) text += option_text(option);
  return text;
}

bool is_help(const CommandOption& option) {
  return std::find(option.flags.begin(), option.flags.end(), "--help") != option.flags.end();
}

std::string markdown_head(const CommandOption& option) {
  std::string head = fmt::format("{}", fmt::join(option.flags, ", "));
  if (!option.value.empty()) head += (head.empty() ? "" : " ") + option.value;
  return fmt::format("`{}`", head);
}

/// Escapes what Markdown would take for markup, outside of code between backticks.
std::string markdown(std::string_view text) {
  std::string escaped;
  bool is_code = false;
  for (const char c : text) {
    is_code ^= c == '`';
    if (!is_code && std::string_view("*_<>[]|$\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string markdown_options(const Command& command) {
  std::string text;
  for (const CommandOption& option : command.options) {
    text += fmt::format("{}\n: {}", markdown_head(option), markdown(sentence(option.description)));
    if (!option.choices.empty()) text += fmt::format(" One of `{}`.", fmt::join(option.choices, "`, `"));
    text += "\n\n";
  }
  return text;
}

std::string markdown_synopsis(const Command& command) {
  std::string line = command.path + " [OPTION...]";
  for (const CommandOption& option : command.options) {
    if (!option.flags.empty()) continue;
    line += option.is_required ? " " + option.value : " [" + option.value + "]";
  }
  return fmt::format("```text\n{}\n```\n\n", line);
}

constexpr std::string_view ExitStatus =
    ".SH EXIT STATUS\n"
    ".TP\n0\nAll was done.\n"
    ".TP\n1\nThe input is wrong, or something could not be read or written; a message says what and where.\n"
    ".TP\n2\nThe command line is wrong.\n"
    ".TP\n130\nA signal interrupted the program.\n";

std::string examples_text(std::string_view examples) {
  std::string text;
  std::istringstream lines{std::string(examples)};
  std::string meaning;
  std::string command;
  while (std::getline(lines, meaning) && std::getline(lines, command)) {
    text += fmt::format(".TP\n{}\n\\fB{}\\fP\n", roff(meaning), roff(command));
  }
  return text;
}

}  // namespace

std::string manual_page(CLI::App& app, const ManualText& text) {
  std::vector<Command> commands = commands_of(app);
  const Command& program = commands.front();
  std::string upper = program.path;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string page =
      fmt::format(".TH {} 1 {} \"Granada {}\" \"User commands\"\n", upper, text.date, text.version);
  std::string title = program.description.substr(0, program.description.find_first_of(":\n"));
  if (!title.empty() && title.back() == '.') title.pop_back();
  page += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n", program.path, roff(title));
  for (const Command& command : commands) {
    // What has subcommands alone is not called itself.
    const bool is_called = command.subcommands.empty() || &command == &program;
    if (is_called) page += synopsis_of(command) + ".br\n";
  }
  page += ".SH DESCRIPTION\n" + paragraphs(text.description);
  page += ".SH OPTIONS\n" + options_text(program);
  if (commands.size() > 1) page += ".SH COMMANDS\n";
  for (auto command = std::next(commands.begin()); command != commands.end(); ++command) {
    std::erase_if(command->options, is_help);  // each has it; the program's own is enough
    page += fmt::format(".SS {}\n{}\n", roff(command->path), roff(sentence(command->description)));
    page += options_text(*command);
  }
  page += ExitStatus;
  page += ".SH EXAMPLES\n" + examples_text(text.examples);
  page += fmt::format(".SH SEE ALSO\n{}\n", roff(text.see_also));
  return page;
}

std::string reference_page(CLI::App& app, const ManualText& text) {
  std::vector<Command> commands = commands_of(app);
  const Command& program = commands.front();
  std::string page = fmt::format("# {}\n\n{}\n\n", program.path, markdown(text.description));
  page += "## Examples\n\n";
  std::istringstream lines{std::string(text.examples)};
  std::string meaning;
  std::string line;
  while (std::getline(lines, meaning) && std::getline(lines, line)) {
    page += fmt::format("{}:\n\n```console\n$ {}\n```\n\n", markdown(meaning), line);
  }
  page += "## Options\n\n" + markdown_options(program);
  for (auto command = std::next(commands.begin()); command != commands.end(); ++command) {
    std::erase_if(command->options, is_help);
    page += fmt::format("## {}\n\n{}\n\n", command->path, markdown(sentence(command->description)));
    if (command->subcommands.empty()) page += markdown_synopsis(*command) + markdown_options(*command);
  }
  return page;
}

void add_manual_option(CLI::App& app, const ManualText& text) {
  const auto print = [&app, text](const std::string& kind) {
    if (kind == "markdown") throw CLI::CallForVersion(reference_page(app, text), 0);
    throw CLI::CallForVersion(kind == "man" ? manual_page(app, text) : completion(app, kind), 0);
  };
  app.add_option_function<std::string>("--manual", print,
                                       "print the manual page, as roff or Markdown, or a shell's completion")
      ->group("")
      ->check(CLI::IsMember({"man", "markdown", "bash", "zsh", "fish"}));
}

}  // namespace command_line
