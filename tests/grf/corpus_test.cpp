// Each file of corpus/valid must be read, and each of corpus/invalid must not be; what is said about it, and
// the scene that it gives, are in the text file beside it.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "grf/lexer.h"
#include "grf/read.h"
#include "grf/write.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenes_of(const std::string& kind) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(GRANADA_SOURCE_DIR) / "tests/grf/corpus" / kind)) {
    if (entry.path().extension() == ".grf") names.push_back(kind + "/" + entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Diagnostics name files as they were asked for, so the tests work in the folder of the scene: then its name
/// alone is in the text.
class Corpus : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { fs::current_path(scene_path_.parent_path()); }
  void TearDown() override { fs::current_path(old_folder_); }

  /// What is said about the scene, and how it is written.
  std::string outcome(bool& is_read) const {
    Diagnostics diagnostics;
    const auto scene = read(scene_path_.filename().string(), diagnostics);
    is_read = scene.has_value();
    return diagnostics.to_text() + (scene ? to_text(*scene) : "");
  }

  std::string scene_text() const { return test::bytes_of(scene_path_.string()); }

  void compare(const std::string& text) const {
    const fs::path expected_path = fs::path(scene_path_).replace_extension(".txt");
    if (std::getenv("GRANADA_UPDATE_CORPUS") != nullptr) std::ofstream(expected_path) << text;
    EXPECT_EQ(fs::exists(expected_path) ? test::bytes_of(expected_path.string()) : "", text)
        << "If the new text is the better one, put it into\n  " << expected_path.string()
        << "\nor let this test do that: run it with GRANADA_UPDATE_CORPUS=1 in its environment.";
  }

 private:
  fs::path old_folder_ = fs::current_path();
  fs::path scene_path_ = fs::path(GRANADA_SOURCE_DIR) / "tests/grf/corpus" / (GetParam() + ".grf");
};

using ValidCorpus = Corpus;
using InvalidCorpus = Corpus;

TEST_P(ValidCorpus, IsReadAndWritten) {
  bool is_read = false;
  const std::string text = outcome(is_read);
  EXPECT_TRUE(is_read);
  compare(text);
}

/// The text cut before each of its words, numbers, strings and marks.
std::vector<std::string> pieces_of(const std::string& text) {
  const auto shared_text = std::make_shared<const std::string>(text);
  std::vector<std::string> pieces;
  const char* begin = shared_text->data();
  for (Lexer lexer(shared_text, nullptr); lexer.peek().kind != TokenKind::EndOfFile; lexer.next()) {
    pieces.emplace_back(begin, lexer.peek().begin);
    begin = lexer.peek().begin;
  }
  pieces.emplace_back(begin, shared_text->data() + shared_text->size());
  return pieces;
}

// One mistake may make what is behind it wrong too, but not everything.
TEST_P(ValidCorpus, HasFewErrorsWhereOneWordIsMissingOrTwice) {
  constexpr std::size_t MostErrors = 4;
  const std::vector<std::string> pieces = pieces_of(scene_text());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const std::string& changed : {std::string(), pieces[i] + pieces[i]}) {
      std::string text;
      for (std::size_t k = 0; k < pieces.size(); ++k) text += k == i ? changed : pieces[k];
      Diagnostics diagnostics;
      const auto scene = read_text(text, "changed.grf", diagnostics);
      EXPECT_EQ(scene.has_value(), !diagnostics.has_errors());
      EXPECT_LE(diagnostics.error_count(), MostErrors) << diagnostics.to_text();
    }
  }
}

TEST_P(InvalidCorpus, IsExplained) {
  bool is_read = false;
  const std::string text = outcome(is_read);
  EXPECT_FALSE(is_read);
  compare(text);
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  return info.param.substr(info.param.find('/') + 1);
}

INSTANTIATE_TEST_SUITE_P(Corpus, ValidCorpus, testing::ValuesIn(scenes_of("valid")), name_of);
INSTANTIATE_TEST_SUITE_P(Corpus, InvalidCorpus, testing::ValuesIn(scenes_of("invalid")), name_of);

}  // namespace
}  // namespace grf
