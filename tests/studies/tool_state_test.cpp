#include "renderer/studies/tool_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/text_file.h"
#include "tests/studies/study_of_text.h"

namespace {

using studies::read_state;
using studies::ToolState;
using testing::HasSubstr;

ToolState state_of(const std::string& text, const std::string& path = "folder/a.study") {
  grf::Diagnostics diagnostics;
  const auto state = read_state(text, path, diagnostics);
  if (!state) throw std::runtime_error(diagnostics.to_text());
  return *state;
}

std::string message_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(read_state(text, "a.study", diagnostics)) << text;
  return diagnostics.to_text();
}

TEST(ToolState, HasWhatEachLineSays) {
  const ToolState state = state_of(
      "\xEF\xBB\xBF// a comment\r\n  TOOL fitplot azimuth=20\r\n\n\tdistribution beta alpha=2\n"
      "brdf ward sx=0.1 // of the metal\nbrdf diffuse\npdf adaptive nQT=30\n  file a b.fit  \nfile /c.fit");
  EXPECT_EQ(state.settings.keyword, "fitplot");
  ASSERT_EQ(state.settings.arguments.size(), 1U);
  EXPECT_EQ(std::get<float>(state.settings.arguments[0].value), 20);
  EXPECT_EQ(state.distribution->keyword, "beta");
  ASSERT_EQ(state.brdfs.size(), 2U);
  EXPECT_EQ(state.brdfs[0].keyword, "ward");
  EXPECT_EQ(state.brdfs[1].keyword, "diffuse");
  EXPECT_EQ(state.pdfs.at(0).keyword, "adaptive");
  ASSERT_EQ(state.files.size(), 2U);
  EXPECT_EQ(state.files[0].path, "folder/a b.fit");
  EXPECT_EQ(state.files[1].path, "/c.fit");
}

TEST(ToolState, IsTheSameWhenItsTextIsRead) {
  const ToolState state =
      state_of("tool fitplot azimuth=-12.5 logarithmic=true\nbrdf measured \"data/a.binary\"\nfile b.fit\n");
  for (const std::string path : {"folder/b.study", "other/c.study"}) {
    const ToolState again = state_of(to_text(state, path), path);
    EXPECT_EQ(again.settings, state.settings);
    EXPECT_EQ(grf::path_beside(path, again.brdfs[0].data_file), "folder/data/a.binary");
  }
  EXPECT_THAT(to_text(state, "folder/b.study"), HasSubstr("\nfile b.fit\n"));
  EXPECT_THAT(to_text(state, "other/c.study"), HasSubstr("\nfile ../folder/b.fit\n"));
  EXPECT_THAT(to_text(state), HasSubstr("\nfile /")) << "absolute, for the clipboard";
}

TEST(ToolState, DefinesTheTermsOfSums) {
  const ToolState state = state_of(
      "tool minibpt\ndef a = brdf ward sx=0.2\n  def b = brdf measured \"m.binary\"\nbrdf combine 1 a 1 b\n");
  ASSERT_EQ(state.definitions.size(), 2U);
  EXPECT_EQ(state.definitions[1].name, "b");
  EXPECT_THAT(
      to_text(state, "other/c.study"),
      HasSubstr("def a = brdf ward sx=0.2\ndef b = brdf measured \"../folder/m.binary\"\nbrdf combine 1 a"));
  EXPECT_EQ(state_of(to_text(state, "folder/b.study")), state);
  EXPECT_THAT(message_of("tool minibpt\ndef a = pdf auto\n"),
              HasSubstr("a.study:2:1: error: expected one BRDF, and only BRDFs are defined"));
  EXPECT_THAT(message_of("tool minibpt\n  def = brdf ward\n"), HasSubstr("a.study:2:7: error"));
  EXPECT_THAT(message_of("tool minibpt\ndef a = brdf ward begin end def b = brdf ward\n"),
              HasSubstr("a.study:2:1: error"));
}

TEST(ToolState, SaysWhereATextIsWrong) {
  EXPECT_THAT(message_of(""), HasSubstr("a.study:1:1: error: found no 'tool'"));
  EXPECT_THAT(message_of("// nothing\n"), HasSubstr("error: found no 'tool'"));
  EXPECT_THAT(message_of("\n  brdf ward\n"), HasSubstr("a.study:2:3: error: found 'brdf', expected 'tool'"));
  EXPECT_THAT(message_of("tool fitplot\ntool fitplot\n"),
              HasSubstr("a.study:2:1: error: found a second 'tool'"));
  EXPECT_THAT(message_of("tool fitplot\nfoo\n"),
              HasSubstr("a.study:2:1: error: found 'foo', expected 'brdf'"));
  EXPECT_THAT(message_of("tool fitplot\nfile \n"), HasSubstr("a.study:2:"));
  EXPECT_THAT(message_of(std::string("tool minibpt\nbrdf measured \"a.b\0\"\n", 34)),
              HasSubstr("a.study:2:19: error: found a NUL character"));
  // Instances are read as in scenes, and located in the state.
  EXPECT_THAT(message_of("tool fitplot\n  brdf ward sx=\n"), HasSubstr("a.study:2:"));
  EXPECT_THAT(message_of("tool fitplot\n\npdf =\n"), HasSubstr("a.study:3:5: error"));
}

TEST(Study, ChecksTheStateAgainstItsTool) {
  const auto messages = [](const std::string& text) { return test::outcome_of(text).messages; };
  EXPECT_THAT(messages("tool fitplt\n"), HasSubstr("unknown tool 'fitplt': did you mean 'fitplot'?"));
  EXPECT_THAT(messages("tool fitplot azimut=2\n"),
              HasSubstr("a.study:1:14: error: 'fitplot' has no parameter 'azimut'"));
  EXPECT_THAT(messages("tool fitplot azimuth=1e6\n"),
              HasSubstr("a.study:1:14: error: 'azimuth' of 'fitplot': "));
  EXPECT_THAT(messages("tool fitplot\nbrdf ward\n"),
              HasSubstr("'fitplot' takes 0 BRDFs, and the state has 1"));
  EXPECT_THAT(messages("tool fitplot\npdf auto\n"),
              HasSubstr("takes 0 sampling schemes, and the state has 1"));
  EXPECT_THAT(messages("tool fitplot\ndistribution beta\n"),
              HasSubstr("takes 0 distributions, and the state has 1"));
}

// Each tool must be able to make a figure of what it shows at first, or say what it needs.
TEST(Study, OfEachToolHasAnInitialState) {
  for (const studies::StudyTool& tool : studies::study_tools()) {
    SCOPED_TRACE(tool.name());
    EXPECT_EQ(tool.initial.settings.keyword, tool.name());
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(check(tool.initial, tool, diagnostics)) << diagnostics.to_text();
    bool is_refined = false;  // the first picture is enough
    studies::StudyContext context;
    context.refined = [&](const studies::Study&) { is_refined = true; };
    context.is_stopped = [&] { return is_refined; };
    const auto study = studies::study_of(tool.initial, context, diagnostics);
    EXPECT_TRUE(study || is_refined || tool.needs_file) << diagnostics.to_text();
    for (const std::string_view name : {tool.azimuth, tool.elevation, tool.animated})
      EXPECT_TRUE(name.empty() || tool.settings.find(name) != nullptr) << name;
  }
}

}  // namespace
