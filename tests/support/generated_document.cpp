#include "tests/support/generated_document.h"

#include <cstdlib>
#include <fstream>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

namespace test {

void expect_generated(const std::string& document, const std::string& program, const std::string& expected) {
  constexpr std::string_view End = "<!-- end -->\n";
  const std::string mark = "<!-- generated: " + program + " -->\n";
  const std::string path = GRANADA_SOURCE_DIR "/" + document;
  const std::string text = bytes_of(path);
  const std::size_t begin = text.find(mark);
  const std::size_t end = begin == std::string::npos ? begin : text.find(End, begin);
  ASSERT_TRUE(begin != std::string::npos && end != std::string::npos) << document << " has no marks";
  const std::size_t first = begin + mark.size();
  if (std::getenv("GRANADA_UPDATE_DOCUMENTS") != nullptr) {
    std::ofstream(path) << text.substr(0, first) << expected << text.substr(end);
    return;
  }
  EXPECT_EQ(text.substr(first, end - first), expected) << document << " is not what the code says";
}

}  // namespace test
