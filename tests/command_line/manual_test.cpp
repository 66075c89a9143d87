// Manual pages and completions of a command line.
#include "command_line/manual.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

/// A program with a command, nested ones, choices, a positional argument and a hidden option.
class Program : public testing::Test {
 protected:
  Program() : app_("A path tracer: it renders", "tracer") {
    app_.require_subcommand(1);
    CLI::App* render = app_.add_subcommand("render", "Render a scene");
    render->add_option("scene", words_[0], "the scene")->required()->type_name("SCENE.op");
    render->add_option("-o,--output", words_[1], "output image; its extension selects the type")
        ->type_name("FILE");
    render->add_option("--points", words_[2], "sampler")->check(CLI::IsMember({"sobol", "independent"}));
    render->add_option("--time", words_[4], "the local time")->type_name("HH:MM")->check(CLI::Range(0, 24));
    render->add_flag("--json", flag_, "print an object's fields [all]");
    render->add_option("--hidden", words_[3], "nobody sees it")->group("");
    CLI::App* brdf = app_.add_subcommand("brdf", "Evaluate BRDFs");
    brdf->require_subcommand(1);
    brdf->add_subcommand("list", "List them");
    brdf->add_subcommand("eval", "Evaluate one")->add_flag("--degrees", flag_, ".5 is half a degree");
    command_line::add_manual_option(app_, Text);
  }

  static constexpr command_line::ManualText Text = {
      .date = "2026-11-28",
      .version = "1.2.3",
      .description = "It renders.\n\nIt also evaluates.",
      .examples = "Render a scene\ntracer render a.op\n",
      .see_also = "grf(5)",
  };

  std::string printed(const std::string& kind) {
    try {
      app_.parse("--manual " + kind);
    } catch (const CLI::Success& success) {
      return success.what();
    }
    return {};
  }

  /// Returns what bash offers for the last of some words.
  std::vector<std::string> offered(const std::string& words) {
    const std::string script = folder_.add("completion", command_line::completion(app_, "bash"));
    const test::Outcome outcome = test::run(
        {"/bin/bash", "-c",
         "source '" + script + "'; COMP_WORDS=(" + words +
             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _tracer; printf '%s\\n' \"${COMPREPLY[@]}\""});
    EXPECT_EQ(outcome.err, "");
    std::vector<std::string> lines;
    std::istringstream text(outcome.out);
    for (std::string line; std::getline(text, line);) {
      if (!line.empty()) lines.push_back(line);
    }
    return lines;
  }

  CLI::App app_;
  test::TemporaryFolder folder_;

 private:
  std::string words_[5];
  bool flag_ = false;
};

using Words = std::vector<std::string>;

TEST_F(Program, HasAPageOfTheDocumentation) {
  EXPECT_EQ(printed("markdown"), R"(# tracer

It renders.

It also evaluates.

## Examples

Render a scene:

```console
$ tracer render a.op
```

## Options

`-h, --help`
: Print this help message and exit.

## tracer render

Render a scene.

```text
tracer render [OPTION...] scene
```

`scene`
: The scene.

`-o, --output FILE`
: Output image; its extension selects the type.

`--points TEXT`
: Sampler. One of `sobol`, `independent`.

`--time HH:MM`
: The local time.

`--json`
: Print an object's fields \[all\].

## tracer brdf

Evaluate BRDFs.

## tracer brdf list

List them.

```text
tracer brdf list [OPTION...]
```

## tracer brdf eval

Evaluate one.

```text
tracer brdf eval [OPTION...]
```

`--degrees`
: .5 is half a degree.

)");
}

TEST_F(Program, HasAManualPage) {
  EXPECT_EQ(printed("man"), R"(.TH TRACER 1 2026-11-28 "Granada 1.2.3" "User commands"
.SH NAME
tracer \- A path tracer
.SH SYNOPSIS
\fBtracer\fP [\fIOPTION\fP...]
.br
\fBtracer render\fP [\fIOPTION\fP...] \fIscene\fP
.br
\fBtracer brdf list\fP [\fIOPTION\fP...]
.br
\fBtracer brdf eval\fP [\fIOPTION\fP...]
.br
.SH DESCRIPTION
It renders.
.PP
It also evaluates.
.SH OPTIONS
.TP
\fB\-h\fP, \fB\-\-help\fP
Print this help message and exit.
.SH COMMANDS
.SS tracer render
Render a scene.
.TP
\fIscene\fP
The scene.
.TP
\fB\-o\fP, \fB\-\-output\fP \fIFILE\fP
Output image; its extension selects the type.
.TP
\fB\-\-points\fP \fITEXT\fP
Sampler.
One of sobol, independent.
.TP
\fB\-\-time\fP \fIHH:MM\fP
The local time.
.TP
\fB\-\-json\fP
Print an object's fields [all].
.SS tracer brdf
Evaluate BRDFs.
.SS tracer brdf list
List them.
.SS tracer brdf eval
Evaluate one.
.TP
\fB\-\-degrees\fP
\&.5 is half a degree.
.SH EXIT STATUS
.TP
0
All was done.
.TP
1
The input is wrong, or something could not be read or written; a message says what and where.
.TP
2
The command line is wrong.
.TP
130
A signal interrupted the program.
.SH EXAMPLES
.TP
Render a scene
\fBtracer render a.op\fP
.SH SEE ALSO
grf(5)
)");
}

TEST_F(Program, IsCompletedByBash) {
  EXPECT_EQ(offered("tracer ''"), (Words{"render", "brdf", "-h", "--help"}));
  EXPECT_EQ(offered("tracer re"), Words{"render"});
  EXPECT_EQ(offered("tracer brdf ''"), (Words{"list", "eval", "-h", "--help"}));
  EXPECT_EQ(offered("tracer render a.op --"), (Words{"--help", "--output", "--points", "--time", "--json"}));
  EXPECT_EQ(offered("tracer render --points ''"), (Words{"sobol", "independent"}));
  EXPECT_EQ(offered("tracer render --points i"), Words{"independent"});
  EXPECT_EQ(offered("tracer brdf eval -"), (Words{"-h", "--help", "--degrees"}));
  // Nothing: bash then offers names of files.
  EXPECT_EQ(offered("tracer render ''"), Words{});
  EXPECT_EQ(offered("tracer render -o ''"), Words{});
}

TEST_F(Program, IsCompletedByZshAndFish) {
  const std::string zsh = printed("zsh");
  EXPECT_TRUE(zsh.starts_with("#compdef tracer\n")) << zsh;
  EXPECT_NE(zsh.find("'--points[sampler]:value:(sobol independent)'"), std::string::npos) << zsh;
  EXPECT_NE(zsh.find("'--json[print an object'\\''s fields \\[all\\]]'"), std::string::npos) << zsh;
  const std::string fish = printed("fish");
  EXPECT_NE(
      fish.find(
          "complete -c tracer -n '__fish_seen_subcommand_from render' -l points -x -a 'sobol independent' "
          "-d 'sampler'\n"),
      std::string::npos)
      << fish;
  EXPECT_NE(
      fish.find(
          "complete -c tracer -n 'not __fish_seen_subcommand_from render brdf' -a brdf -d 'Evaluate BRDFs'"),
      std::string::npos)
      << fish;
}

TEST_F(Program, HasNoOtherManual) { EXPECT_THROW(app_.parse("--manual csh"), CLI::ValidationError); }

}  // namespace
