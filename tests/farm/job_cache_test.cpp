#include "renderer/farm/job_cache.h"

#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using farm::JobCache;
using transport::digest_of;

class Cache : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const JobCache cache_{folder_.path("cache"), 25};

  void add(const std::string& bytes, int age_in_seconds) const {
    grf::Diagnostics diagnostics;
    const auto path = cache_.add(digest_of(bytes), bytes, diagnostics);
    ASSERT_TRUE(path) << diagnostics.to_text();
    fs::last_write_time(*path, fs::file_time_type::clock::now() - std::chrono::seconds(age_in_seconds));
  }
  bool has(const std::string& bytes) const { return cache_.find(digest_of(bytes)).has_value(); }
};

TEST_F(Cache, HasWhatWasAdded) {
  EXPECT_FALSE(has("0123456789"));
  add("0123456789", 0);
  const auto path = cache_.find(digest_of("0123456789"));
  ASSERT_TRUE(path);
  EXPECT_TRUE(path->ends_with(".grfjob"));
  EXPECT_EQ(fs::file_size(*path), 10U);
}

TEST_F(Cache, RemovesWhatWasUsedLongestAgo) {
  add("oldest byt", 300);
  add("older byte", 200);
  EXPECT_TRUE(has("oldest byt")) << "which is now used";
  add("new bytes.", 0);
  EXPECT_FALSE(has("older byte"));
  EXPECT_TRUE(has("oldest byt") && has("new bytes."));
  add(std::string(100, 'x'), 0);
  EXPECT_TRUE(has(std::string(100, 'x'))) << "although it exceeds the limit";
  EXPECT_FALSE(has("oldest byt") || has("new bytes."));
}

TEST_F(Cache, KnowsNoFileThatWasAltered) {
  add("0123456789", 0);
  folder_.add("cache/" + transport::hex(digest_of("0123456789")) + ".grfjob", "012345678x");
  EXPECT_FALSE(has("0123456789"));
}

}  // namespace
