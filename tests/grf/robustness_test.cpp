// Tests of robustness: reading any text ends soon with a scene or with an error, and takes memory of a small
// multiple of the text.
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/write.h"
#include "tests/grf/allocation_meter.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

namespace fs = std::filesystem;

const std::string Triangle = "begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end begin faces (0, 1, 2) ";

// Times over what is measured, for slow machines and sanitizers; what takes the square of the size is far
// beyond.
constexpr double MostSeconds = 20;
constexpr std::size_t MostBytesForAByte = 60;
constexpr std::size_t MostBytesAtLeast = 1'000'000;

struct Outcome {
  bool is_read = false;
  std::string said;
};

Outcome outcome_of(const std::string& text) {
  const std::size_t bytes_before = allocated_bytes();
  restart_peak();
  const std::clock_t start = std::clock();  // of this process, whatever else the machine does
  Outcome outcome;
  {
    Diagnostics diagnostics;
    const auto scene = read_text(text, "scene.grf", diagnostics);
    outcome.is_read = scene.has_value();
    outcome.said = diagnostics.to_text();
    EXPECT_EQ(scene.has_value(), !diagnostics.has_errors());
  }
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, MostSeconds);
  EXPECT_LT(peak_bytes() - bytes_before, MostBytesForAByte * text.size() + MostBytesAtLeast);
  return outcome;
}

std::string repeated(const std::string& piece, std::size_t bytes) {
  std::string text;
  text.reserve(bytes + piece.size());
  while (text.size() < bytes) text += piece;
  return text;
}

/// Repeats a text, with the number of the repetition for each `#`.
std::string numbered(const std::string& piece, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    for (const char c : piece) {
      if (c == '#') {
        text += std::to_string(i);
      } else {
        text += c;
      }
    }
  }
  return text;
}

void expect_one_error(const std::string& text, const std::string& message) {
  const Outcome outcome = outcome_of(text);
  EXPECT_FALSE(outcome.is_read);
  EXPECT_NE(outcome.said.find("error: " + message), std::string::npos) << outcome.said;
  EXPECT_EQ(outcome.said.find("error:"), outcome.said.rfind("error:")) << outcome.said;
}

void expect_read(const std::string& text) {
  const Outcome outcome = outcome_of(text);
  EXPECT_TRUE(outcome.is_read) << outcome.said;
}

constexpr std::size_t TenMegabytes = 10'000'000;

TEST(Robustness, DeepNestingIsOneError) {
  const std::string message = "blocks are nested deeper than 1000";
  expect_one_error(repeated("transform scale (2, 2, 2) begin ", 32'000'000), message);
  expect_one_error(repeated("def a = rgb (0, 0, 0) begin\n", 28'000'000), message);
  expect_one_error(repeated("transform scale (2, 2, 2) begin ", 32'000'000) + repeated("end ", 4'000'000),
                   message);
}

TEST(Robustness, RepeatedOpenersAreErrors) {
  for (const char* piece :
       {"(", "begin ", "begin mesh ", "light ", "light begin ", "def ", "def a = ", "transform ", "include ",
        "\"", "“", "=", "brdf ", "end ", "end mesh ", "{", "1e"}) {
    EXPECT_FALSE(outcome_of(repeated(piece, 1'000'000)).is_read) << piece;
  }
}

TEST(Robustness, OneLongTokenIsOneError) {
  for (const char* piece : {"a", "1", "\x80", "\xF0\x9F\x98\x80", "-", "."}) {
    EXPECT_FALSE(outcome_of(repeated(piece, TenMegabytes)).is_read) << piece;
  }
  expect_one_error("light begin (0, 1" + std::string(TenMegabytes, '0') + ", 0) (1, 0, 0) (0, 1, 0) end",
                   "the number 1000000000");
  expect_one_error("begin mesh rgb " + std::string(TenMegabytes, 'a') + " " + Triangle + "end end",
                   "no colour called 'aaaaaaaaaa");
}

TEST(Robustness, TenMegabytesOnOneLineAreRead) {
  expect_read("begin mesh " + Triangle +
              repeated("brdf ward sx=0.1 (0, 1, 2) brdf phong n=2 (0, 2, 1) ", TenMegabytes) + "end end");
  expect_read(repeated("light begin (0, 0, 0) (1, 0, 0) (0, 1, 0) end ", TenMegabytes));
  expect_read("begin mesh begin vertexs " + repeated("normal (0, 0, 1) (0, 0, 0) ", TenMegabytes) +
              "end begin faces end end");
}

TEST(Robustness, TenMegabytesOfCommentsAreRead) {
  expect_read(repeated("//\n", TenMegabytes));
  expect_read("// " + std::string(TenMegabytes, '/'));
  const Outcome outcome = outcome_of("begin mesh " + Triangle + repeated("//\n", TenMegabytes) + "end end");
  EXPECT_TRUE(outcome.is_read);
  EXPECT_NE(outcome.said.find("3333334 comments inside lists"), std::string::npos) << outcome.said;
}

TEST(Robustness, ManyBlocksAreRead) {
  expect_read(repeated("begin mesh " + Triangle + "end end\n", TenMegabytes));
  expect_read(repeated("transform scale (2, 2, 2) begin end\n", TenMegabytes));
}

TEST(Robustness, ManyDefinitionsAreRead) {
  const std::string definitions = "def " + numbered("c# = rgb (0, 0, 0)\n", 300'000) + "begin ";
  expect_read(definitions + "begin mesh " + Triangle + numbered("rgb c# (0, 1, 2)\n", 300'000) +
              "end end end");
  expect_read(numbered("def c# = rgb (0, 0, 0) begin end\n", 300'000));
  EXPECT_FALSE(outcome_of(definitions + "begin mesh " + numbered("rgb d#\n", 300'000)).is_read);
}

TEST(Robustness, ManyWarningsAreNoTrouble) {
  const Outcome outcome = outcome_of(repeated("begin mesh " + Triangle + "end faces\n", TenMegabytes) +
                                     "begin mesh " + Triangle + "end end");
  EXPECT_TRUE(outcome.is_read) << outcome.said;
  EXPECT_NE(outcome.said.find("only the first 100 warnings are shown"), std::string::npos);
}

TEST(Robustness, ManyErrorsAreNoTrouble) {
  for (const char* piece :
       {"light\n", "light begin (1e99, 0, 0) (0, 0, 0) (0, 0, 0) end\n", "include \"nowhere\"\n",
        "transform scale (0, 0, 0) begin end\n", "begin mesh rgb a", "x\n"}) {
    EXPECT_FALSE(outcome_of(repeated(piece, 1'000'000)).is_read) << piece;
  }
  EXPECT_FALSE(outcome_of("begin mesh begin vertexs " + repeated("(1e99, 0, 0)\n", TenMegabytes)).is_read);
  EXPECT_FALSE(outcome_of("begin mesh " + Triangle + repeated("(0, 1)\n", TenMegabytes)).is_read);
  EXPECT_FALSE(outcome_of("begin mesh " + Triangle + repeated("(7, 8, 9)\n", TenMegabytes)).is_read);
  EXPECT_FALSE(outcome_of("def " + repeated("a = rgb (0, 0, 0)\n", TenMegabytes) + "begin end").is_read);
}

TEST(Robustness, CountsAreNotTrusted) {
  for (const char* count : {"1000000000", "4294967295", "99999999999999999999"}) {
    expect_one_error("begin mesh " + Triangle + count + " 0 1 2 end end", "the face says that it has");
    expect_one_error("begin mesh " + Triangle + count + " (0, 1, 2) end end", "the face says that it has");
  }
}

/// A text with something done to it that people, editors and networks do.
std::string mutated(std::string text, const std::vector<std::string>& pieces, std::mt19937& random) {
  const auto up_to = [&random](std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(0, most)(random);
  };
  const std::size_t count = 1 + up_to(3);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = up_to(text.size());
    const std::size_t length = up_to(20);
    switch (up_to(5)) {
      case 0:
        if (place < text.size()) text[place] = static_cast<char>(up_to(255));
        break;
      case 1:
        text.erase(place, length);
        break;
      case 2:
        text.insert(place, text.substr(up_to(text.size()), length));
        break;
      case 3:
        text.resize(place);
        break;
      default:
        text.insert(place, pieces[up_to(pieces.size() - 1)]);
    }
  }
  return text;
}

class MutatedCorpus : public testing::TestWithParam<std::string> {};

// What is read is written and read again, too: no text gives a scene that would be lost.
TEST_P(MutatedCorpus, GivesASceneOrAMessage) {
  const fs::path folder = fs::path(GRANADA_SOURCE_DIR) / "tests/grf/corpus" / GetParam();
  const std::vector<std::string> pieces = {
      "begin ",       "end ",       "mesh ", "faces ",   "vertexs ",  "def ",  "light ", "rgb ", "brdf ",
      "none ",        "transform ", "(",     ")",        ",",         "=",     "\"",     "“",    "//",
      "\n",           "1e39",       "-0",    "1e-46",    "0 ",        " sx=1", " a = ",  "red ", "ward ",
      "\xEF\xBB\xBF", "\xF1",       "\r\n",  "include ", "(0, 1, 2) "};
  std::mt19937 random(20080131);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".grf") continue;
    const std::string text = test::bytes_of(entry.path().string());
    for (int i = 0; i < 60; ++i) {
      const std::string mutant = mutated(text, pieces, random);
      Diagnostics diagnostics;
      const auto scene = read_text(mutant, entry.path().string(), diagnostics);
      ASSERT_EQ(scene.has_value(), !diagnostics.has_errors()) << mutant;
      if (!scene) continue;
      const auto again = read_text(to_text(*scene), entry.path().string(), diagnostics);
      ASSERT_TRUE(again) << mutant << "\n--- written as\n" << to_text(*scene) << diagnostics.to_text();
      ASSERT_EQ(*again, *scene) << mutant;
      ASSERT_EQ(to_text(*again), to_text(*scene)) << mutant;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robustness, MutatedCorpus, testing::Values("valid", "invalid"));

}  // namespace
}  // namespace grf
