// Each file of corpus/valid must be read, and each of corpus/invalid must not be; what is said about it, and
// the scene that it gives, are in the text file beside it.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/write.h"
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
