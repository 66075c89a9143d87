#include "converters/text_encoding.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace convert {
namespace {

using namespace std::string_view_literals;

TEST(TextEncoding, Utf8StaysAsItIsWithoutAMark) {
  EXPECT_EQ(to_utf8("v 1 2 3\n"), "v 1 2 3\n");
  EXPECT_EQ(to_utf8("\u00E6 \u20AC \U0001F600"), "\u00E6 \u20AC \U0001F600");
  EXPECT_EQ(to_utf8("\xEF\xBB\xBFo \u00E6"), "o \u00E6");
  EXPECT_EQ(to_utf8(""), "");
}

TEST(TextEncoding, Latin1IsWhatIsNoUtf8) {
  EXPECT_EQ(to_utf8("Terraind\xE6k"), "Terraind\u00E6k");
  EXPECT_EQ(to_utf8("cut \xE2\x82"), "cut \u00E2\u0082") << "a sequence that ends too early";
  EXPECT_EQ(to_utf8("\xC0\xAF"), "\u00C0\u00AF") << "an overlong form";
  EXPECT_EQ(to_utf8("\xED\xA0\x80"), "\u00ED\u00A0\u0080") << "a surrogate";
}

TEST(TextEncoding, Utf16IsToldByItsMark) {
  EXPECT_EQ(to_utf8("\xFE\xFF\0v\0 \xD8\x3D\xDE\0 \xAC"sv), "v \U0001F600\u20AC");
  EXPECT_EQ(to_utf8("\xFF\xFEv\0 \0\x3D\xD8\0\xDE\xAC\x20"sv), "v \U0001F600\u20AC");
  EXPECT_EQ(to_utf8("\xFE\xFF\xD8\x3D\0x\0"sv), "\uFFFDx") << "half a pair, and half a unit at the end";
}

RC_GTEST_PROP(TextEncoding, WhatComesOutIsUtf8, (const std::string& bytes)) {
  const std::string once = to_utf8(bytes);
  RC_ASSERT(to_utf8("x" + once) == "x" + once);
}

}  // namespace
}  // namespace convert
