// Tests of folders for temporary files.
#include "grf/short_lived_folder.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

namespace fs = std::filesystem;

/// Lets a folder look as if its files had been made two minutes ago.
void age(const fs::path& folder) {
  const timespec now = {std::time(nullptr) - 120, 0};
  const timespec times[] = {now, now};
  ASSERT_EQ(::utimensat(AT_FDCWD, folder.c_str(), times, 0), 0);
}

/// Makes a folder with a file in a process that is killed, and returns its path.
fs::path folder_of_a_killed_process(const fs::path& parent) {
  int ends[2];
  if (::pipe(ends) != 0) return {};
  const pid_t child = ::fork();
  if (child == 0) {
    const ShortLivedFolder folder("job");
    std::ofstream(folder.path() / "file") << "left";
    const std::string name = folder.path().filename().string();
    const bool is_written = ::write(ends[1], name.data(), name.size()) > 0;
    ::kill(::getpid(), is_written ? SIGKILL : SIGABRT);
  }
  ::close(ends[1]);
  std::string name(100, ' ');
  const ssize_t length = ::read(ends[0], name.data(), name.size());
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return length > 0 ? parent / name.substr(0, static_cast<std::size_t>(length)) : fs::path();
}

class ShortLivedFolders : public testing::Test {
 protected:
  void SetUp() override { ::setenv("TMPDIR", parent.path("").c_str(), 1); }
  void TearDown() override { ::unsetenv("TMPDIR"); }

  test::TemporaryFolder parent;
};

TEST_F(ShortLivedFolders, AreRemovedWithTheirFiles) {
  fs::path path;
  {
    const ShortLivedFolder folder("job");
    path = folder.path();
    std::ofstream(path / "file") << "text";
    EXPECT_TRUE(fs::is_directory(path));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(ShortLivedFolders, OfKilledProcessesAreRemovedByTheNext) {
  const fs::path left = folder_of_a_killed_process(parent.path(""));
  ASSERT_TRUE(fs::exists(left / "file"));
  { const ShortLivedFolder soon("job"); }
  EXPECT_TRUE(fs::exists(left)) << "its process might not have locked it yet";
  age(left);
  { const ShortLivedFolder other("convert"); }
  EXPECT_TRUE(fs::exists(left)) << "of another prefix";
  const ShortLivedFolder later("job");
  EXPECT_FALSE(fs::exists(left));
}

TEST_F(ShortLivedFolders, InUseAreLeftHoweverOldTheyAre) {
  const ShortLivedFolder used("job");
  std::ofstream(used.path() / "file") << "text";
  age(used.path());
  const fs::path link = fs::path(parent.path("")) / "job_link";
  const std::string target = parent.path("target");
  fs::create_directory(target);
  fs::create_directory_symlink(target, link);
  const ShortLivedFolder other("job");
  EXPECT_TRUE(fs::exists(used.path() / "file"));
  EXPECT_TRUE(fs::exists(target));
  EXPECT_TRUE(fs::is_symlink(link));
}

}  // namespace
}  // namespace grf
