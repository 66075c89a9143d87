// Tests of files that are truncated in their last line, which Assimp reads as complete.
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

enum class Verdict { Sound, PerhapsCut, Cut };

Verdict verdict_on(const Reading& reading) {
  const bool says_cut =
      reading.text().find("error: the file is truncated in this statement") != std::string::npos;
  if (says_cut && !reading.scene) return Verdict::Cut;
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  const bool warns =
      reading.text().find("warning: the file does not end with a line end") != std::string::npos;
  return warns ? Verdict::PerhapsCut : Verdict::Sound;
}

/// The verdict on a small sound model with one more line.
Verdict verdict_on_last_line(std::string_view last_line) {
  const std::string start =
      "v 0.25 0.00 0.00\nv 1.00 0.00 0.00\nv 0.00 1.50 0.00\nvt 0.5 0.25\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n";
  return verdict_on(read_obj_text(start + std::string(last_line)));
}

TEST(CutObj, AWholeLastLineWithoutALineEndGivesAWarning) {
  EXPECT_EQ(verdict_on_last_line("f 3/1/1 2/1/1 1/1/1\n"), Verdict::Sound);
  EXPECT_EQ(verdict_on_last_line("f 3/1/1 2/1/1 1/1/1"), Verdict::PerhapsCut);
  EXPECT_EQ(verdict_on_last_line("v 1.00 2.00 3.00"), Verdict::PerhapsCut);
  EXPECT_EQ(verdict_on_last_line("vn 1 2 3"), Verdict::PerhapsCut);
  EXPECT_EQ(verdict_on_last_line("# a comm"), Verdict::PerhapsCut);
  EXPECT_EQ(verdict_on_last_line("usemtl gol"), Verdict::PerhapsCut);
  EXPECT_EQ(verdict_on_last_line("g"), Verdict::PerhapsCut);
  EXPECT_EQ(verdict_on_last_line("   "), Verdict::PerhapsCut);
}

TEST(CutObj, TooFewNumbersAreAnError) {
  for (const char* line : {"v", "v ", "v 1.00", "v 1.00 2.00", "v 1.00 2.00 ", "vt", "vt 0.5", "vn 1 2"}) {
    EXPECT_EQ(verdict_on_last_line(line), Verdict::Cut) << line;
  }
}

TEST(CutObj, FewerNumbersThanInAllLinesBeforeAreAnError) {
  const std::string start = "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n";
  EXPECT_EQ(verdict_on(read_obj_text(start + "v 1 1 0 0")), Verdict::Cut);
  EXPECT_EQ(verdict_on(read_obj_text(start + "v 1 1 0 0 0 1")), Verdict::PerhapsCut);
}

TEST(CutObj, NoNumbersAreAnErrorEvenIfLinesBeforeHaveNone) {
  EXPECT_EQ(verdict_on(read_obj_text("v 0 0 0\nv\nv")), Verdict::Cut);
}

TEST(CutObj, NumbersThatCannotEndSoAreAnError) {
  for (const char* line :
       {"v 1.00 2.00 -", "v 1.00 2.00 +", "v 1.00 2.00 3.", "v 1.00 2.00 1e", "v 1.00 2.00 1.00e-"}) {
    EXPECT_EQ(verdict_on_last_line(line), Verdict::Cut) << line;
  }
}

TEST(CutObj, FewerDecimalsThanAllOthersHaveAreAnError) {
  EXPECT_EQ(verdict_on_last_line("v 1.00 2.00 3.0"), Verdict::Cut);
  EXPECT_EQ(verdict_on_last_line("v 1.00 2.00 3"), Verdict::Cut);
  // The texture coordinates have no common number of decimals.
  EXPECT_EQ(verdict_on_last_line("vt 0.5 0.2"), Verdict::PerhapsCut);
}

TEST(CutObj, FacesThatCannotEndSoAreAnError) {
  for (const char* line :
       {"f", "f 1/1/1", "f 1/1/1 2/1/1", "f 1/1/1 2/1/1 ", "f 1/1/1 2/1/1 3", "f 1/1/1 2/1/1 3/",
        "f 1/1/1 2/1/1 3/1", "f 1/1/1 2/1/1 3/1/", "f 1/1/1 2/1/1 -"}) {
    EXPECT_EQ(verdict_on_last_line(line), Verdict::Cut) << line;
  }
}

TEST(CutObj, OtherStatementsThatCannotEndSoAreAnError) {
  for (const char* line : {"us", "usemt", "usemtl", "mtllib ", "mt", "o", "f 1/1/1 2/1/1 \\"}) {
    EXPECT_EQ(verdict_on_last_line(line), Verdict::Cut) << line;
  }
}

TEST(CutObj, TheErrorSaysWhereAndWhy) {
  const Reading reading = read_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2");
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_THAT(reading.text(),
              HasSubstr("model.obj:5:1: error: the file is truncated in this statement: it has 2 "
                        "of at least 3 corners\n  f 3 2\n  ^\n"));
}

/// A model of glmark2's (Debian's package glmark2-data), cut at each byte of its last line.
TEST(CutObj, ARealFileIsNeverTakenForAWholeOne) {
  const std::string bytes = test::bytes_of("/usr/share/glmark2/models/bunny.obj");
  const std::size_t last_line = bytes.rfind('\n', bytes.size() - 2) + 1;
  ASSERT_EQ(bytes.substr(last_line), "f 12707 33423 34835\n");
  const test::TemporaryFolder folder;
  for (std::size_t size = last_line; size <= bytes.size(); ++size) {
    const std::string path = folder.add("bunny.obj", bytes.substr(0, size));
    const std::string_view kept = std::string_view(bytes).substr(last_line, size - last_line);
    // With its third number begun, the last face looks whole.
    const bool has_three = kept.size() > std::string_view("f 12707 33423 ").size();
    const bool has_line_end = kept.empty() || kept.back() == '\n';
    const Verdict expected = has_line_end ? Verdict::Sound : has_three ? Verdict::PerhapsCut : Verdict::Cut;
    EXPECT_EQ(verdict_on(read_path(path)), expected) << '"' << kept << '"';
  }
}

}  // namespace
}  // namespace convert
