#include "grf/lexer.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/grf/reading.h"

namespace grf {
namespace {

/// The tokens of a text, each written as its kind's initial and its text.
std::vector<std::string> tokens_of(const std::string& text) {
  constexpr std::string_view Initials = "EWNSPI";
  Lexer lexer(std::make_shared<std::string>(text), nullptr);
  std::vector<std::string> tokens;
  while (lexer.peek().kind != TokenKind::EndOfFile) {
    const Token token = lexer.next();
    tokens.push_back(Initials[static_cast<std::size_t>(token.kind)] + std::string(":") +
                     std::string(token.text));
  }
  return tokens;
}

using Tokens = std::vector<std::string>;

TEST(Lexer, TellsKindsOfTokens) {
  EXPECT_EQ(tokens_of("begin (1, \"a b\") = _x$2"),
            (Tokens{"W:begin", "P:(", "N:1", "P:,", "S:a b", "P:)", "P:=", "W:_x$2"}));
}

TEST(Lexer, NeedsNoSpace) {
  EXPECT_EQ(tokens_of("sx=.5sy=1"), (Tokens{"W:sx", "P:=", "I:.5sy", "P:=", "N:1"}));
  EXPECT_EQ(tokens_of("(1,-2)(3)"), (Tokens{"P:(", "N:1", "P:,", "N:-2", "P:)", "P:(", "N:3", "P:)"}));
  EXPECT_EQ(tokens_of("1+2-3"), (Tokens{"N:1", "N:+2", "N:-3"}));
}

TEST(Lexer, LeavesSuffixesOutOfNumbers) {
  EXPECT_EQ(tokens_of("1f 2.5F .5d -1e-3D"), (Tokens{"N:1", "N:2.5", "N:.5", "N:-1e-3"}));
}

TEST(Lexer, FindsWhatIsNoNumber) {
  EXPECT_EQ(tokens_of("1e 2x . - 1fd 0x10 1e+"),
            (Tokens{"I:1e", "I:2x", "I:.", "I:-", "I:1fd", "I:0x10", "I:1e+"}));
}

TEST(Lexer, SkipsCommentsAndByteOrderMark) {
  EXPECT_EQ(tokens_of("\xEF\xBB\xBF// a\nx// b\r\n//"), (Tokens{"W:x"}));
  EXPECT_EQ(tokens_of(" \xEF\xBB\xBF"), (Tokens{"I:\xEF\xBB\xBF"})) << "only at the start of a file";
}

TEST(Lexer, GivesCommentsWithoutSlashesAndLineEnds) {
  Lexer lexer(std::make_shared<std::string>("// one\r\nx //two\n///three"), nullptr);
  lexer.next();
  ASSERT_EQ(lexer.comments().size(), 3U);
  EXPECT_EQ(lexer.comments()[0].text, " one");
  EXPECT_EQ(lexer.comments()[1].text, "two");
  EXPECT_EQ(lexer.comments()[1].line, 2U);
  EXPECT_EQ(lexer.comments()[2].text, "/three");
}

TEST(Lexer, TakesTypographicQuotesInAnyOrder) {
  EXPECT_EQ(tokens_of("“a” ”b” “c“ ”d“"), (Tokens{"S:a", "S:b", "S:c", "S:d"}));
  EXPECT_EQ(tokens_of("“a \"b\"”"), (Tokens{"S:a \"b\""}));
  EXPECT_EQ(tokens_of("\"a “b”\""), (Tokens{"S:a “b”"}));
}

TEST(Lexer, EndsAnUnclosedStringWithItsLine) {
  EXPECT_EQ(tokens_of("\"a b\nc"), (Tokens{"I:\"a b", "W:c"}));
  EXPECT_EQ(tokens_of("“a b\nc"), (Tokens{"I:“a b", "W:c"}));
  EXPECT_EQ(tokens_of("“a\" b”"), (Tokens{"S:a\" b"}));
}

TEST(Lexer, KeepsCharactersWhole) { EXPECT_EQ(tokens_of("ñ;"), (Tokens{"I:ñ", "I:;"})); }

TEST(Lexer, PeeksAtTheSecondTokenWithoutMoving) {
  Lexer lexer(std::make_shared<std::string>("a // one\n = // two\n b"), nullptr);
  EXPECT_EQ(lexer.peek_second().text, "=");
  EXPECT_EQ(lexer.comments().size(), 0U);
  EXPECT_EQ(lexer.next().text, "a");
  EXPECT_EQ(lexer.comments().size(), 1U);
  EXPECT_EQ(lexer.peek().line, 2U);
  EXPECT_EQ(lexer.peek_second().line, 3U);
}

TEST(Lexer, CountsLinesAndColumnsFromOneInCharacters) {
  Lexer lexer(std::make_shared<std::string>("\xEF\xBB\xBF\"ñandú\" b\r\n\tc“ñ” d"), nullptr);
  std::vector<std::pair<unsigned, unsigned>> places;
  while (lexer.peek().kind != TokenKind::EndOfFile) {
    const SourceLocation location = lexer.location(lexer.next());
    places.emplace_back(location.line, location.column);
  }
  EXPECT_EQ(places, (std::vector<std::pair<unsigned, unsigned>>{{1, 1}, {1, 9}, {2, 2}, {2, 3}, {2, 7}}));
}

TEST(Lexer, LocatesTokensInAnyOrder) {
  Lexer lexer(std::make_shared<std::string>("a bb ccc"), nullptr);
  const Token a = lexer.next();
  const Token b = lexer.next();
  const Token c = lexer.next();
  EXPECT_EQ(lexer.location(b).column, 3U);
  EXPECT_EQ(lexer.location(c).column, 6U);
  EXPECT_EQ(lexer.location(a).column, 1U);
  EXPECT_EQ(lexer.location(c).column, 6U);
}

TEST(Lexer, PutsTheEndOfTheFileBehindTheLastToken) {
  Lexer lexer(std::make_shared<std::string>("ab\n\n// c\n"), nullptr);
  lexer.next();
  EXPECT_EQ(lexer.location(lexer.peek()).line, 1U);
  EXPECT_EQ(lexer.location(lexer.peek()).column, 3U);
}

float number(const std::string& text) {
  const Scene scene = scene_of("light begin (" + text + ", 0, 0) (1, 0, 0) (0, 1, 0) end");
  return block<AreaLight>(scene.contents).corner.x;
}

TEST(Numbers, AreReadInAllNotations) {
  EXPECT_EQ(number("1"), 1.0F);
  EXPECT_EQ(number("+1"), 1.0F);
  EXPECT_EQ(number(".5"), 0.5F);
  EXPECT_EQ(number("-2."), -2.0F);
  EXPECT_EQ(number("1e-3"), 1e-3F);
  EXPECT_EQ(number("1.5E+2f"), 150.0F);
  EXPECT_EQ(number("0.25d"), 0.25F);
  EXPECT_EQ(number("007"), 7.0F);
}

TEST(Numbers, AreRoundedToTheNearestFloat) {
  EXPECT_EQ(number("16777217"), 16777216.0F);
  EXPECT_EQ(number("0.1"), 0.1F);
  EXPECT_EQ(number("0.100000001490116119384765625"), 0.1F);
  EXPECT_EQ(number("1" + std::string(400, '0') + "e-400"), 1.0F);
}

TEST(Numbers, TooNearToZeroAreZero) {
  const std::string zeros(400, '0');
  for (const std::string& text : {std::string("1e-46"), std::string("1e-400"), "0." + zeros + "1",
                                  std::string("12345e-99999999999999999999"), "0." + zeros + "1e300"}) {
    EXPECT_EQ(number(text), 0.0F) << text;
    EXPECT_FALSE(std::signbit(number(text))) << text;
    EXPECT_TRUE(std::signbit(number("-" + text))) << text;
  }
  EXPECT_EQ(number("1e-45"), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(number("0e99999999999999999999"), 0.0F);
}

TEST(Numbers, TooLargeAreErrors) {
  const std::string zeros(400, '0');
  EXPECT_EQ(number("3.4028235e38"), std::numeric_limits<float>::max());
  for (const std::string& text : {std::string("3.4028236e38"), std::string("-1e39"), "1" + zeros,
                                  std::string("0.001e99999999999999999999"), "0." + zeros + "1e500"}) {
    const std::string error = error_in("light begin (" + text + ", 0, 0) (1, 0, 0) (0, 1, 0) end");
    EXPECT_NE(error.find("is out of range"), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace grf
