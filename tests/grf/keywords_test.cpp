#include "grf/keywords.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace grf {
namespace {

TEST(Keywords, AreTheSameInAnyCase) {
  EXPECT_TRUE(same_keyword("cascadeCDF", "CascadeCdf"));
  EXPECT_FALSE(same_keyword("ward", "war"));
  EXPECT_FALSE(same_keyword("[", "{")) << "only letters have cases";
}

TEST(Identifiers, AreLettersUnderscoresDollarsAndThenDigits) {
  for (const char* word : {"a", "Z9", "_", "$", "$2a$", "ward", "light", "nonee"}) {
    EXPECT_TRUE(is_identifier(word)) << word;
  }
  for (const char* word : {"", "2a", "a b", "a-b", "ñ"}) EXPECT_FALSE(is_identifier(word)) << word;
}

TEST(Identifiers, AreNoReservedWordsInAnyCase) {
  for (const char* word : {"begin", "end", "def", "none", "use", "true", "false", "BEGIN", "None"}) {
    EXPECT_FALSE(is_identifier(word)) << word;
  }
}

TEST(Identifiers, StandForAnyText) {
  EXPECT_EQ(to_identifier("gold"), "gold");
  EXPECT_EQ(to_identifier(""), "$$");
  EXPECT_EQ(to_identifier("blue paint"), "blue$20$paint");
  EXPECT_EQ(to_identifier("2nd"), "$32$nd");
  EXPECT_EQ(to_identifier("$"), "$24$");
  EXPECT_EQ(to_identifier("None"), "$4e$one");
  EXPECT_EQ(to_identifier("ñ"), "$c3$$b1$");
}

TEST(Identifiers, KeepWhatOnlyLooksLikeAnEscape) {
  EXPECT_EQ(from_identifier("a$b"), "a$b");
  EXPECT_EQ(from_identifier("$zz$"), "$zz$");
  EXPECT_EQ(from_identifier("$123$"), "$123$");
}

RC_GTEST_PROP(Identifiers, GiveTheirTextBack, (const std::string& text)) {
  RC_ASSERT(from_identifier(to_identifier(text)) == text);
}

RC_GTEST_PROP(Identifiers, AreMadeOfAnyText, (const std::string& text)) {
  RC_ASSERT(is_identifier(to_identifier(text)));
}

// Letters that reserved words are made of, so that some come up, and bytes that need an escape.
RC_GTEST_PROP(Identifiers, GiveOddTextsBack, ()) {
  const auto piece =
      rc::gen::element<std::string>("$", "$$", "24", "end", "E", "use", "0", " ", "\n", "ñ", "_");
  const auto pieces = *rc::gen::container<std::vector<std::string>>(piece);
  std::string text;
  for (const std::string& each : pieces) text += each;
  RC_ASSERT(from_identifier(to_identifier(text)) == text);
  RC_ASSERT(is_identifier(to_identifier(text)));
}

}  // namespace
}  // namespace grf
