// Tests of editing the text of an OP file.
#include "renderer/options/op_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grf/text_file.h"
#include "renderer/options/op_file.h"
#include "renderer/options/op_line.h"

namespace {

using options::OpText;
using options::OptionInfo;
using options::RenderOptions;
using Words = std::vector<std::string>;

const OptionInfo& option(std::string_view key) { return *options::find_option(key); }

std::string with(std::string_view text, std::string_view key, const Words& words) {
  OpText edited(text);
  EXPECT_TRUE(edited.set(option(key), words));
  return edited.text();
}

TEST(OpText, ReplacesValuesInPlace) {
  EXPECT_EQ(with("# top\nbpt Depth   5\t # why\r\n\nBPT_Seed 3", "BPT_Depth", {"7"}),
            "# top\nbpt Depth   7\t # why\r\n\nBPT_Seed 3");
  EXPECT_EQ(with("Viewer  1  2   3 // eye\n", "BPT_Viewer", {"1", "2.5", "3"}),
            "Viewer  1  2.5   3 // eye\n");
  EXPECT_EQ(with("Scene a.grf\n", "BPT_Scene", {"my # scene.grf"}), "Scene \"my # scene.grf\"\n");
  EXPECT_EQ(with("Scene \"b c.grf\" # x\n", "BPT_Scene", {"b c.grf"}), "Scene \"b c.grf\" # x\n");
}

TEST(OpText, MendsLinesThatAreWrong) {
  EXPECT_EQ(with("BPT_Depth # none\n", "BPT_Depth", {"7"}), "BPT_Depth 7 # none\n");
  EXPECT_EQ(with("BPT_Depth 1 2 3 # many\n", "BPT_Depth", {"7"}), "BPT_Depth 7 # many\n");
  EXPECT_EQ(with("Scene \"a.grf\r\n", "BPT_Scene", {"a.grf"}), "Scene a.grf\r\n");
  EXPECT_EQ(with("Image_Resolution \"4\"\"5\"\n", "BPT_Image_Resolution", {"4", "6"}),
            "Image_Resolution 4 6\n");
  EXPECT_EQ(with("Depth 1\n#a\nDepth 2 #b\nDepth 3\n", "BPT_Depth", {"7"}), "Depth 7\n#a\n#b\n");
}

TEST(OpText, AddsBehindTheLastOfTheGroup) {
  const std::string text =
      "# top\nBPT_Scene    a.grf\nBPT_Exposure 1  # bright\n# times\nBPT_Chrono_Prebuild true\n";
  EXPECT_EQ(with(text, "BPT_Layers", {"albedo"}),
            "# top\nBPT_Scene    a.grf\nBPT_Exposure 1  # bright\nBPT_Layers   albedo\n# times\n"
            "BPT_Chrono_Prebuild true\n");
  EXPECT_EQ(with(text, "BPT_Depth", {"7"}),
            "# top\nBPT_Scene    a.grf\nBPT_Exposure 1  # bright\nBPT_Depth    7\n# times\n"
            "BPT_Chrono_Prebuild true\n");
  EXPECT_EQ(with("\tBPT_Depth\t7", "BPT_Seed", {"1"}), "\tBPT_Depth\t7\n\tBPT_Seed\t1");
  EXPECT_EQ(with("BPT_Depth 7\r\n", "BPT_Seed", {"1"}), "BPT_Depth 7\r\nBPT_Seed  1\r\n");
  EXPECT_EQ(with("", "BPT_Depth", {"7"}), "BPT_Depth             7\n");
  EXPECT_EQ(with("\xEF\xBB\xBF#c", "BPT_Depth", {"7"}), "\xEF\xBB\xBF#c\nBPT_Depth             7");
}

TEST(OpText, RemovesWhatComesToItsDefault) {
  EXPECT_EQ(with("#a\nBPT_Depth 7\n#b\n", "BPT_Depth", {"5"}), "#a\n#b\n");
  EXPECT_EQ(with("  BPT_Depth 7 // why\n", "BPT_Depth", {"05"}), "  // why\n");
  EXPECT_EQ(with("EM_Background a.exr\n", "BPT_EM_Background", {"none"}), "");
  EXPECT_EQ(with("QT_Precomputed 80\n", "BPT_QT_Precomputed", {"90"}), "QT_Precomputed 90\n")
      << "a parameter that is given is not one that is not";
  EXPECT_EQ(with("QT_Precomputed 80\n", "BPT_QT_Precomputed", {}), "");
}

TEST(OpText, RefusesWordsThatNoLineCanHold) {
  for (const char* word : {"a\nb", "a \"b", "\"a", "#\"", "a\r"}) {
    OpText text("Scene a.grf\n");
    EXPECT_FALSE(text.set(option("BPT_Scene"), {word})) << word;
    EXPECT_EQ(text.text(), "Scene a.grf\n");
  }
  EXPECT_EQ(with("Scene a\n", "BPT_Scene", {"a\"b"}), "Scene a\"b\n");
}

TEST(OpText, KnowsWhatLinesAreAbout) {
  const OpText text("# c\nScene a.grf\nnothing 5\nBPT Depth x\nDepth 9\nSeed 4\n");
  EXPECT_EQ(text.option_at(0), nullptr);
  EXPECT_EQ(text.option_at(2), &option("BPT_Scene"));
  EXPECT_EQ(text.option_at(3), nullptr);
  EXPECT_EQ(text.line_of(option("BPT_Depth")), 4U);
  EXPECT_EQ(text.line_of(option("BPT_Up")), 0U);
  EXPECT_EQ(text.words_of(option("BPT_Depth")), Words{"x"});
  EXPECT_EQ(text.words_of(option("BPT_Up")), std::nullopt);
  EXPECT_EQ(text.options().scene, "a.grf");
  EXPECT_EQ(text.options().seed, 4U);
}

TEST(OpText, TakesOptionsFromTheFirstLineOnAndTheFirstValueThatIsRight) {
  const RenderOptions given_twice = OpText("Seed 4\nSeed 5\nDepth 9").options();
  EXPECT_EQ(given_twice.seed, 4U);
  EXPECT_EQ(given_twice.depth, 9);
  EXPECT_EQ(OpText("Depth x\nDepth 9\nDepth 8").options().depth, 9);
}

TEST(OpText, KeepsLineEndsOfLinesThatStay) {
  OpText text("\xEF\xBB\xBF#a\r\n#b\n#c\r\n#d");
  EXPECT_EQ(text.plain_text(), "#a\n#b\n#c\n#d");
  text.set_plain_text(text.plain_text());
  EXPECT_EQ(text.text(), "\xEF\xBB\xBF#a\r\n#b\n#c\r\n#d");
  text.set_plain_text("#a\n#b\nDepth 7\n#c\n#d");
  EXPECT_EQ(text.text(), "\xEF\xBB\xBF#a\r\n#b\nDepth 7\r\n#c\r\n#d");
  text.set_plain_text("#b\n#d");
  EXPECT_EQ(text.text(), "\xEF\xBB\xBF#b\r\n#d");
  text.set_plain_text("");
  EXPECT_EQ(text.plain_text(), "");
}

TEST(OpTextOptions, KeepsCamerasALineEach) {
  const OptionInfo& cameras = option("BPT_Cameras");
  OpText text(
      "BPT_Scene a.grf\nBPT_Cameras a 1 0 3 0 0 0 0 1 0 45 0 0 # the first\nBPT_Cameras bad 1\nBPT_Depth "
      "3\n");
  ASSERT_EQ(text.options().cameras.size(), 1U);
  Words words = option_words(text.options(), cameras);
  for (const char* word : {"b", "2", "0", "3", "0", "0", "0", "0", "1", "0", "30", "0.5", "2"})
    words.push_back(word);
  ASSERT_TRUE(text.set(cameras, words));
  EXPECT_EQ(text.text(),
            "BPT_Scene a.grf\nBPT_Cameras a 1 0 3 0 0 0 0 1 0 45 0 0 # the first\n"
            "BPT_Cameras b 2 0 3 0 0 0 0 1 0 30 0.5 2\nBPT_Depth 3\n");
  ASSERT_EQ(text.options().cameras.size(), 2U);
  EXPECT_EQ(text.options().cameras[0].name, "a");
  EXPECT_EQ(text.options().cameras[1].name, "b");
  EXPECT_EQ(text.options().cameras[1].lens_radius, 0.5F);
  EXPECT_EQ(text.words_of(cameras), words);
  words.erase(words.begin(), words.begin() + 13);
  ASSERT_TRUE(text.set(cameras, words));
  EXPECT_EQ(text.options().cameras.size(), 1U);
  EXPECT_EQ(text.options().cameras[0].name, "b");
  ASSERT_TRUE(text.set(cameras, {}));
  EXPECT_EQ(text.text(), "BPT_Scene a.grf\n# the first\nBPT_Depth 3\n");
}

// Property tests with random texts and edits.

std::string any_of(const Words& words) { return *rc::gen::elementOf(words); }

/// Generates a valid value of an option, which may be its default.
Words words_for(const OptionInfo& info) {
  const auto number = [] { return any_of({"2", "3", "7", "16"}); };
  if (const auto* word = std::get_if<options::WordOption>(&info.value)) {
    return {std::string(*rc::gen::elementOf(word->words))};
  }
  if (const auto* list = std::get_if<options::ListOption>(&info.value)) {
    return {any_of({std::string(list->words[1]) + "," + std::string(list->words[0]), "all", "none"})};
  }
  if (info.values == "bool") return {any_of({"true", "false"})};
  if (info.values == "path") return {any_of({"a b.x", "#c", "/d//e", "\xC3\xA9.x", "a//b"})};
  if (info.values == "name") return {any_of({"side", "the front", "none"})};
  if (is_repeated(info)) {
    Words cameras;
    const int count = *rc::gen::inRange(1, 4);
    for (int i = 0; i < count; ++i) {
      cameras.push_back("camera " + std::to_string(i));
      for (std::size_t k = 1; k < options::word_count(info); ++k) cameras.push_back(k == 1 ? "1" : number());
    }
    return cameras;
  }
  if (info.values == "HOST:PORT") return {any_of({"[::1]:80", "none"})};
  if (std::holds_alternative<options::PairOption<std::optional<options::IntegerPair>>>(info.value)) {
    return {"8", any_of({"1", "2", "8"})};
  }
  Words words;
  for (std::size_t i = 0; i < options::word_count(info); ++i) words.push_back(number());
  return words;
}

const OptionInfo& any_option() {
  const auto& table = options::option_table();
  return table[*rc::gen::inRange<std::size_t>(0, table.size())];
}

std::string gap() { return any_of({" ", "  ", "\t", " \t "}); }

/// Generates lines of comments, blank lines and options, each option once.
std::string random_text() {
  std::string text = "BPT_Scene" + gap() + "a.grf" + gap() + "# the scene\n";
  std::vector<const OptionInfo*> given = {&option("BPT_Scene")};
  const int count = *rc::gen::inRange(0, 30);
  for (int i = 0; i < count; ++i) {
    const OptionInfo& info = any_option();
    const std::string comment = any_of({"# note ", "//note "}) + std::to_string(i);
    if (std::find(given.begin(), given.end(), &info) == given.end() && *rc::gen::arbitrary<bool>()) {
      given.push_back(&info);
      OpText line;
      const bool is_written = line.set(info, words_for(info));
      RC_ASSERT(is_written);
      if (line.text().empty()) continue;
      text += any_of({"", "  "}) + line.text().substr(0, line.text().size() - 1);
      text += any_of({"", gap() + comment});
    } else {
      text += any_of({"", " ", comment});
    }
    text += any_of({"\n", "\r\n"});
  }
  return text;
}

/// Returns the comments after the words of each line, in order.
std::string comments_of(const std::string& text) {
  std::string comments;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1);
    const std::string_view line = rest.substr(0, end);
    const auto words = options::op_words(line);
    const std::size_t begin = line.find_first_not_of(" \t\r", words.empty() ? 0 : words.back().end);
    if (begin != std::string_view::npos) comments += std::string(line.substr(begin)) + "\n";
    rest.remove_prefix(end + 1);
  }
  return comments;
}

RenderOptions read(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto read_options =
      options::read_op_text("/scenes/x.op", std::make_shared<const std::string>(text), diagnostics);
  RC_ASSERT(diagnostics.to_text() == "");
  return *read_options;
}

RC_GTEST_PROP(OpTextProperty, KeepsAllThatIsNotEdited, ()) {
  const std::string text = random_text();
  OpText edited(text);
  RC_ASSERT(edited.text() == text);
  RenderOptions expected = read(text);
  const int edits = *rc::gen::inRange(1, 12);
  for (int i = 0; i < edits; ++i) {
    const OptionInfo& info = any_option();
    Words words = words_for(info);
    RC_ASSERT(edited.set(info, words));
    const auto* path = std::get_if<options::PathOption>(&info.value);
    if (path != nullptr) words[0] = grf::path_beside("/scenes/x.op", words[0]);
    RC_ASSERT(!options::set_option(expected, info, words));
  }
  RC_ASSERT(read(edited.text()) == expected);
  RC_ASSERT(comments_of(edited.text()) == comments_of(text));
}

RC_GTEST_PROP(OpTextProperty, ChangesNoOtherLine, ()) {
  const std::string text = random_text();
  const OptionInfo& info = any_option();
  if (is_repeated(info)) RC_DISCARD("has several lines");
  OpText edited(text);
  const std::uint32_t line = edited.line_of(info);
  RC_ASSERT(edited.set(info, words_for(info)));
  const std::uint32_t now = edited.line_of(info);
  if (line == 0 || now == 0) RC_DISCARD("added or removed");
  RC_ASSERT(now == line);
  const auto without = [](const std::string& all, std::uint32_t number) {
    std::size_t begin = 0;
    for (std::uint32_t i = 1; i < number; ++i) begin = all.find('\n', begin) + 1;
    return all.substr(0, begin) + all.substr(all.find('\n', begin));
  };
  RC_ASSERT(without(edited.text(), line) == without(text, line));
}

}  // namespace
