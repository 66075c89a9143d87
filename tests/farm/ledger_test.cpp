#include "renderer/farm/ledger.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using farm::Ledger;
using testing::HasSubstr;

class LedgerFile : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const std::string path_ = folder_.path("image.ledger");
  std::vector<std::string> records_;

  std::optional<Ledger> open(const std::string& expected_error = "") {
    records_.clear();
    grf::Diagnostics diagnostics;
    auto ledger = Ledger::open(
        path_,
        [&](std::string_view record) {
          records_.emplace_back(record);
          return true;
        },
        diagnostics);
    EXPECT_EQ(ledger.has_value(), expected_error.empty());
    EXPECT_THAT(diagnostics.to_text(), HasSubstr(expected_error));
    return ledger;
  }
};

TEST_F(LedgerFile, HasItsRecordsAgain) {
  const std::vector<std::string> all = {"first", "", std::string(100'000, 'x')};
  {
    auto ledger = open();
    ASSERT_TRUE(ledger);
    for (const std::string& record : all) EXPECT_TRUE(ledger->append(record));
    EXPECT_TRUE(ledger->sync());
    std::vector<std::string> read;
    EXPECT_TRUE(ledger->read([&](std::string_view record) {
      read.emplace_back(record);
      return true;
    }));
    EXPECT_EQ(read, all);
    open("another process has the ledger open");
  }
  auto ledger = open();
  EXPECT_EQ(records_, all);
  EXPECT_TRUE(ledger->append("last"));
  ledger.reset();
  open();
  EXPECT_EQ(records_.size(), 4U);
  EXPECT_EQ(records_.back(), "last");
}

// A process that is killed leaves any beginning of the record that it writes.
TEST_F(LedgerFile, EndsBeforeARecordThatIsNotWhole) {
  std::size_t two = 0;
  {
    auto ledger = open();
    ledger->append("first");
    ledger->append("second");
    two = fs::file_size(path_);
    ledger->append("third");
  }
  std::ifstream file(path_, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  for (std::size_t size = two; size < bytes.size(); ++size) {
    folder_.add("image.ledger", bytes.substr(0, size));
    auto ledger = open();
    EXPECT_EQ(records_, (std::vector<std::string>{"first", "second"})) << size;
    EXPECT_EQ(fs::file_size(path_), two);
    ledger->append("other");
    ledger.reset();
    open();
    EXPECT_EQ(records_, (std::vector<std::string>{"first", "second", "other"}));
  }
  std::string altered = bytes;
  altered.back() = 'X';
  folder_.add("image.ledger", altered);
  open();
  EXPECT_EQ(records_, (std::vector<std::string>{"first", "second"}));
}

TEST_F(LedgerFile, IsNoOtherFile) {
  folder_.add("image.ledger", "something of the user's");
  open("it is no ledger");
  EXPECT_EQ(fs::file_size(path_), 23U);
  fs::remove(path_);
  fs::create_directory(path_);
  open("cannot open the ledger: Is a directory");
}

}  // namespace
