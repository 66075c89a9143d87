#include "grf/diagnostics.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

/// A source file whose text is at hand.
struct Source {
  explicit Source(std::string bytes, const std::string& path = "scene.grf", SourceLocation included_at = {})
      : text(std::make_shared<const std::string>(std::move(bytes))),
        file(std::make_shared<SourceFile>(SourceFile{path, std::move(included_at), text})) {}
  SourceLocation at(std::uint32_t line, std::uint32_t column) const { return {file, line, column}; }

  std::shared_ptr<const std::string> text;
  std::shared_ptr<const SourceFile> file;
};

std::string error_at(const SourceLocation& location) {
  Diagnostics diagnostics;
  diagnostics.error(location, "wrong");
  return diagnostics.to_text();
}

TEST(Diagnostics, KeepsLossesAsWarningsAndByThemselves) {
  Diagnostics diagnostics;
  diagnostics.warning({}, "dim");
  diagnostics.loss({}, "lost");
  EXPECT_EQ(diagnostics.losses(), std::vector<std::string>{"lost"});
  EXPECT_EQ(diagnostics.warning_count(), 2U);
  EXPECT_EQ(diagnostics.to_text(), "warning: dim\nwarning: lost\n");
}

TEST(Diagnostics, NameFileLineAndColumnAndPointAtThePlace) {
  const Source source("one\ntwo three\nfour");
  EXPECT_EQ(error_at(source.at(2, 5)),
            "scene.grf:2:5: error: wrong\n"
            "  two three\n"
            "      ^\n");
}

TEST(Diagnostics, HaveThreeSeverities) {
  Diagnostics diagnostics;
  const Source source("x");
  diagnostics.warning(source.at(1, 1), "odd");
  diagnostics.note(whole_file("other.grf"), "written");
  diagnostics.error({}, "wrong");
  EXPECT_EQ(diagnostics.to_text(),
            "scene.grf:1:1: warning: odd\n  x\n  ^\n"
            "other.grf: note: written\n"
            "error: wrong\n");
  EXPECT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.warning_count(), 1U);
}

TEST(Diagnostics, IndentTheCaretAsTheLineIs) {
  EXPECT_EQ(error_at(Source("\ta\tb").at(1, 4)), "scene.grf:1:4: error: wrong\n  \ta\tb\n  \t \t^\n");
  EXPECT_EQ(error_at(Source("año ñ x").at(1, 7)), "scene.grf:1:7: error: wrong\n  año ñ x\n        ^\n");
  EXPECT_EQ(error_at(Source("ab").at(1, 3)), "scene.grf:1:3: error: wrong\n  ab\n    ^\n");
}

TEST(Diagnostics, ShowLinesWithoutTheirEndsAndMarks) {
  EXPECT_EQ(error_at(Source("a\r\nb\r\n").at(2, 1)), "scene.grf:2:1: error: wrong\n  b\n  ^\n");
  EXPECT_EQ(error_at(Source("\xEF\xBB\xBF\ta").at(1, 2)), "scene.grf:1:2: error: wrong\n  \ta\n  \t^\n");
}

TEST(Diagnostics, ShowWhatIsAroundTheColumnOfALongLine) {
  const std::string before(1000, 'a');
  const std::string after(1000, 'z');
  EXPECT_EQ(error_at(Source(before + "x" + after).at(1, 1001)),
            "scene.grf:1:1001: error: wrong\n  ..." + std::string(99, 'a') + "x" + std::string(60, 'z') +
                "...\n  " + std::string(102, ' ') + "^\n");
  EXPECT_EQ(error_at(Source("x" + after).at(1, 1)),
            "scene.grf:1:1: error: wrong\n  x" + std::string(159, 'z') + "...\n  ^\n");
  EXPECT_EQ(error_at(Source(before + "x").at(1, 1001)), "scene.grf:1:1001: error: wrong\n  ..." +
                                                            std::string(99, 'a') + "x\n  " +
                                                            std::string(102, ' ') + "^\n");
}

TEST(Diagnostics, ShowNoBytesThatATerminalMightObey) {
  EXPECT_EQ(error_at(Source("a\x1b[31mb\x7f\xf1 c").at(1, 1)),
            "scene.grf:1:1: error: wrong\n  a\uFFFD[31mb\uFFFD\uFFFD c\n  ^\n");
  Diagnostics diagnostics;
  diagnostics.error({}, "the name '\x1b\xc3'");
  EXPECT_EQ(diagnostics.to_text(), "error: the name '\uFFFD\uFFFD'\n");
}

TEST(Diagnostics, CutMessagesThatNobodyWouldRead) {
  Diagnostics diagnostics;
  diagnostics.error({}, "1" + std::string(1'000'000, 'a'));
  diagnostics.error({}, "2" + std::string(1998, 'a') + "ñ");
  diagnostics.error({}, "3" + std::string(1997, 'a') + "ñ");
  EXPECT_EQ(diagnostics.entries()[0].message, "1" + std::string(1999, 'a') + "...");
  EXPECT_EQ(diagnostics.entries()[1].message, "2" + std::string(1998, 'a') + "...") << "no half characters";
  EXPECT_EQ(diagnostics.entries()[2].message, "3" + std::string(1997, 'a') + "ñ");
}

TEST(Diagnostics, ShowTheChainOfIncludes) {
  const Source outer("include \"middle.grf\"", "outer.grf");
  const Source middle("\n include \"inner.grf\"", "middle.grf", outer.at(1, 9));
  const Source inner("x", "inner.grf", middle.at(2, 10));
  EXPECT_EQ(error_at(inner.at(1, 1)),
            "inner.grf:1:1: error: wrong\n  x\n  ^\n"
            "  included from middle.grf:2:10\n"
            "  included from outer.grf:1:9\n");
}

TEST(Diagnostics, ReadTheLineAgainWhereTheTextIsGone) {
  const test::TemporaryFolder folder;
  Source source("", folder.add("scene.grf", "one\ntwo\n"));
  source.text.reset();
  EXPECT_EQ(source_line(source.at(2, 1)), "two");
  EXPECT_EQ(source_line(source.at(4, 1)), "");
  EXPECT_EQ(source_line(source.at(0, 0)), "");
}

TEST(Diagnostics, KeepNoMoreThanTwentyErrors) {
  Diagnostics diagnostics;
  for (std::uint32_t i = 1; i <= 19; ++i) diagnostics.error({nullptr, i, 1}, "wrong");
  EXPECT_FALSE(diagnostics.is_full());
  diagnostics.error({nullptr, 20, 1}, "wrong");
  EXPECT_TRUE(diagnostics.is_full());
  diagnostics.error({nullptr, 21, 1}, "wrong");
  EXPECT_EQ(diagnostics.entries().size(), 20U);
  EXPECT_EQ(diagnostics.error_count(), 21U);
  EXPECT_NE(diagnostics.to_text().find("only the first 20 errors are shown\n"), std::string::npos);
}

TEST(Diagnostics, KeepNoMoreThanAHundredWarnings) {
  Diagnostics diagnostics;
  for (std::uint32_t i = 1; i <= 101; ++i) diagnostics.warning({nullptr, i, 1}, "odd");
  diagnostics.error({}, "wrong");
  EXPECT_EQ(diagnostics.entries().size(), 101U);
  EXPECT_EQ(diagnostics.warning_count(), 101U);
  EXPECT_NE(diagnostics.to_text().find("only the first 100 warnings are shown\n"), std::string::npos);
}

TEST(Diagnostics, SayTheSameOfOnePlaceOnce) {
  Diagnostics diagnostics;
  diagnostics.error({nullptr, 1, 2}, "wrong");
  diagnostics.error({nullptr, 1, 2}, "wrong");
  diagnostics.error({nullptr, 1, 3}, "wrong");
  diagnostics.error({nullptr, 1, 2}, "bad");
  diagnostics.warning({nullptr, 1, 2}, "wrong");
  EXPECT_EQ(diagnostics.entries().size(), 4U);
  EXPECT_EQ(diagnostics.error_count(), 4U) << "what is asked is whether something went wrong";
}

TEST(DidYouMean, SuggestsTheNearestWord) {
  EXPECT_EQ(did_you_mean("wrad", {"ward", "phong"}), "did you mean 'ward'?");
  EXPECT_EQ(did_you_mean("WARDD", {"ward", "wardly"}), "did you mean 'ward'?");
}

TEST(DidYouMean, SuggestsUpToThreeThatAreEquallyNear) {
  EXPECT_EQ(did_you_mean("pong", {"phong", "pond", "ward"}), "did you mean 'phong' or 'pond'?");
  EXPECT_EQ(did_you_mean("abcd", {"abcd4", "abcd3", "abcd2", "abcd1"}),
            "did you mean 'abcd1', 'abcd2' or 'abcd3'?");
  EXPECT_EQ(did_you_mean("abcd", {"abce", "abce"}), "did you mean 'abce'?");
}

TEST(DidYouMean, SuggestsNothingFarAway) {
  EXPECT_EQ(did_you_mean("lambert", {"ward", "phong"}), "");
  EXPECT_EQ(did_you_mean("x", {"y"}), "") << "nothing of the word would be left";
  EXPECT_EQ(did_you_mean("ward", {}), "");
  EXPECT_EQ(did_you_mean(std::string(1000, 'a'), {std::string(1000, 'a')}), "");
}

}  // namespace
}  // namespace grf
