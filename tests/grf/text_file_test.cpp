#include "grf/text_file.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

/// Somebody to whom permissions apply, while it lives: the administrator's tests would prove nothing.
class OrdinaryUser {
 public:
  OrdinaryUser() {
    if (old_ == 0) change_to(Nobody);
  }
  ~OrdinaryUser() {
    if (old_ == 0) change_to(old_);
  }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;

 private:
  static constexpr uid_t Nobody = 65534;
  static void change_to(uid_t user) { EXPECT_EQ(::seteuid(user), 0); }

  uid_t old_ = ::geteuid();
};

/// A limit on the size of files, while it lives: the next best thing to a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    rlimit limited = old_;
    limited.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_ = {};
  void (*old_handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

class TextFile : public testing::Test {
 protected:
  /// Returns the diagnostics of a file that cannot be read, without its path.
  std::string failure_to_read(const std::string& name) const {
    Diagnostics diagnostics;
    EXPECT_EQ(read_file(folder.path(name), diagnostics), nullptr);
    return message(name, diagnostics);
  }

  std::string failure_to_replace(const std::string& name, const std::string& bytes) const {
    Diagnostics diagnostics;
    EXPECT_FALSE(replace_file(folder.path(name), bytes, diagnostics));
    return message(name, diagnostics);
  }

  void replace(const std::string& name, const std::string& bytes) const {
    Diagnostics diagnostics;
    EXPECT_TRUE(replace_file(folder.path(name), bytes, diagnostics)) << diagnostics.to_text();
    EXPECT_TRUE(diagnostics.entries().empty());
  }

  fs::perms permissions(const std::string& name) const { return fs::status(folder.path(name)).permissions(); }

  test::TemporaryFolder folder;

 private:
  std::string message(const std::string& name, const Diagnostics& diagnostics) const {
    EXPECT_EQ(diagnostics.entries().size(), 1U);
    EXPECT_EQ(diagnostics.entries()[0].location.file->path, folder.path(name));
    return diagnostics.entries()[0].message;
  }
};

TEST_F(TextFile, IsReadAsItIs) {
  const std::string bytes("a\0b\r\n\xff", 6);
  folder.add("file", bytes);
  folder.add("empty", "");
  Diagnostics diagnostics;
  EXPECT_EQ(*read_file(folder.path("file"), diagnostics), bytes);
  EXPECT_EQ(*read_file(folder.path("empty"), diagnostics), "");
  EXPECT_TRUE(diagnostics.entries().empty());
}

TEST_F(TextFile, ThatCannotBeReadIsExplained) {
  fs::create_directory(folder.path("folder"));
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  folder.add("secret", "a");
  fs::permissions(folder.path("secret"), fs::perms::none);
  EXPECT_EQ(failure_to_read("nowhere"), "cannot read the file: No such file or directory");
  EXPECT_EQ(failure_to_read("folder"), "cannot read the file: it is a directory, expected a file");
  EXPECT_EQ(failure_to_read("pipe"), "cannot read the file: it is a pipe, expected a file");
  EXPECT_EQ(failure_to_read("secret/file"), "cannot read the file: Not a directory");
  const OrdinaryUser user;
  EXPECT_EQ(failure_to_read("secret"), "cannot read the file: Permission denied");
}

// Cut off and written to again by another program, over and over: reading it takes longer than that.
TEST_F(TextFile, ThatIsWrittenToMeanwhileIsNotHalfOfEach) {
  constexpr std::uintmax_t Size = 64U << 20U;
  const std::string path = folder.add("file", "");
  fs::resize_file(path, Size);
  std::jthread writer([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      fs::resize_file(path, Size / 2);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      fs::resize_file(path, Size);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  Diagnostics diagnostics;
  for (int i = 0; i < 20 && diagnostics.error_count() == 0; ++i) read_file(path, diagnostics);
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.entries()[0].message, "cannot read the file: it was changed while it was read");
  writer.request_stop();
  writer.join();
  EXPECT_EQ(read_file(path, diagnostics)->size(), Size);
}

TEST_F(TextFile, ThatIsADeviceIsNotReadForEver) {
  Diagnostics diagnostics;
  EXPECT_EQ(read_file("/dev/zero", diagnostics), nullptr);
  EXPECT_EQ(diagnostics.to_text(),
            "/dev/zero: error: cannot read the file: it is a device or socket, expected a file\n");
}

TEST_F(TextFile, IsMissedWhereItWasAskedFor) {
  Diagnostics diagnostics;
  const SourceLocation place{whole_file("scene.grf").file, 3, 9};
  EXPECT_EQ(read_file(folder.path("nowhere"), diagnostics, place), nullptr);
  EXPECT_EQ(diagnostics.to_text(), "scene.grf:3:9: error: cannot read '" + folder.path("nowhere") +
                                       "': No such file or directory\n");
}

TEST_F(TextFile, IsMadeWithThePermissionsOfAnyNewFile) {
  const mode_t old_mask = ::umask(0027);
  replace("file", "new");
  ::umask(old_mask);
  EXPECT_EQ(test::bytes_of(folder.path("file")), "new");
  EXPECT_EQ(permissions("file"), fs::perms(0640));
}

TEST_F(TextFile, IsReplacedAndKeepsItsPermissions) {
  folder.add("file", "something longer");
  fs::permissions(folder.path("file"), fs::perms(0604));
  replace("file", "new");
  EXPECT_EQ(test::bytes_of(folder.path("file")), "new");
  EXPECT_EQ(permissions("file"), fs::perms(0604));
  EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST_F(TextFile, IsAnotherFileOnceItIsReplaced) {
  folder.add("file", "old");
  fs::create_hard_link(folder.path("file"), folder.path("reader"));
  replace("file", "new");
  EXPECT_EQ(test::bytes_of(folder.path("reader")), "old")
      << "who still reads the old file gets the whole of it";
}

TEST_F(TextFile, IsReplacedBehindALink) {
  folder.add("inner/file", "old");
  fs::create_symlink("inner/file", folder.path("link"));
  replace("link", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path("link")));
  EXPECT_EQ(test::bytes_of(folder.path("inner/file")), "new");
}

TEST_F(TextFile, StaysWholeWhereTheDiskIsFull) {
  folder.add("file", "old");
  {
    const FileSizeLimit limit(1000);
    EXPECT_EQ(failure_to_replace("file", std::string(100'000, 'x')), "cannot write the file: File too large");
    EXPECT_EQ(failure_to_replace("new", std::string(1001, 'x')), "cannot write the file: File too large");
  }
  EXPECT_EQ(test::bytes_of(folder.path("file")), "old");
  EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST_F(TextFile, LeavesNothingBehindInAFolderThatCannotBeWritten) {
  folder.add("file", "old");
  fs::permissions(folder.path(), fs::perms(0555));
  {
    const OrdinaryUser user;
    EXPECT_EQ(failure_to_replace("new", "new"), "cannot create the file: Permission denied");
  }
  fs::permissions(folder.path(), fs::perms(0755));
  EXPECT_THAT(folder.names(), ElementsAre("file"));
  EXPECT_EQ(test::bytes_of(folder.path("file")), "old");
}

TEST_F(TextFile, IsNotReplacedWhereItIsReadOnly) {
  folder.add("file", "old");
  fs::permissions(folder.path("file"), fs::perms(0444));
  fs::permissions(folder.path(), fs::perms(0777));
  {
    const OrdinaryUser user;
    EXPECT_EQ(failure_to_replace("file", "new"), "cannot write the file: Permission denied");
  }
  EXPECT_EQ(test::bytes_of(folder.path("file")), "old");
  EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST_F(TextFile, IsNotWrittenWhereSomethingElseIs) {
  fs::create_directory(folder.path("folder"));
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(failure_to_replace("folder", "new"), "cannot write the file: it is a directory");
  EXPECT_EQ(failure_to_replace("pipe", "new"), "cannot write the file: it is a pipe");
  EXPECT_EQ(failure_to_replace("nowhere/file", "new"), "cannot create the file: No such file or directory");
  EXPECT_THAT(folder.names(), ElementsAre("folder", "pipe"));
}

TEST_F(TextFile, IsCreatedOnceAlone) {
  Diagnostics diagnostics;
  const std::string path = folder.path("new");
  EXPECT_EQ(create_file(path, "first", diagnostics), Creation::Done);
  EXPECT_EQ(create_file(path, "second", diagnostics), Creation::Exists);
  EXPECT_EQ(test::bytes_of(path), "first");
  EXPECT_THAT(folder.names(), ElementsAre("new"));
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(create_file(folder.path("nowhere/file"), "", diagnostics), Creation::Failed);
  EXPECT_EQ(diagnostics.entries().back().message, "cannot create the file: No such file or directory");
}

TEST_F(TextFile, LeavesNothingWhereItsProcessDied) {
  Diagnostics diagnostics;
  const pid_t child = ::fork();
  if (child == 0) {
    replace_file(
        folder.path("file"), [](const FileWriter& write) { return write("half") && ::raise(SIGKILL) == 0; },
        diagnostics);
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  ASSERT_EQ(folder.names().size(), 1U) << "the temporary file";
  folder.add("file.1-0.new", "of another process");
  folder.add("file." + std::to_string(child) + "-x.new", "of nobody");
  folder.add("file." + std::to_string(child) + "-1", "of nobody");
  remove_temporary_files(folder.path(), child);
  EXPECT_EQ(folder.names().size(), 3U);
  EXPECT_FALSE(fs::exists(folder.path("file." + std::to_string(child) + "-0.new")));
  remove_temporary_files(folder.path("nowhere"), child);
}

TEST_F(TextFile, FilesThatBelongTogetherAreAllReplacedOrNone) {
  folder.add("a", "old a");
  folder.add("b", "old b");
  const auto with = [](const std::string& bytes) {
    return [bytes](const FileWriter& write) { return write(bytes); };
  };
  Diagnostics diagnostics;
  EXPECT_TRUE(
      replace_files({{folder.path("a"), with("new a")}, {folder.path("b"), with("new b")}}, diagnostics));
  EXPECT_EQ(test::bytes_of(folder.path("a")), "new a");
  EXPECT_EQ(test::bytes_of(folder.path("b")), "new b");
  const auto fail = [](const FileWriter& write) { return write("half") && false; };
  EXPECT_FALSE(replace_files({{folder.path("a"), with("newer a")}, {folder.path("b"), fail}}, diagnostics));
  EXPECT_FALSE(
      replace_files({{folder.path("a"), with("newer a")}, {folder.path("no/b"), with("b")}}, diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 2U);
  EXPECT_EQ(test::bytes_of(folder.path("a")), "new a");
  EXPECT_EQ(test::bytes_of(folder.path("b")), "new b");
  EXPECT_THAT(folder.names(), ElementsAre("a", "b"));
}

TEST(Paths, AreBesideTheFileThatNamesThem) {
  EXPECT_EQ(path_beside("scenes/room.grf", "wall.grf"), "scenes/wall.grf");
  EXPECT_EQ(path_beside("scenes/room.grf", "..\\parts\\wall.grf"), "parts/wall.grf");
  EXPECT_EQ(path_beside("room.grf", "./wall.grf"), "wall.grf");
  EXPECT_EQ(path_beside("scenes/room.grf", "/parts/wall.grf"), "/parts/wall.grf");
}

TEST(FileName, IsWithoutFolders) {
  EXPECT_EQ(file_name("/a folder/b.c/wall.tar.gz"), "wall.tar.gz");
  EXPECT_EQ(file_name("wall"), "wall");
  EXPECT_EQ(file_name(""), "");
}

TEST_F(TextFile, HasOneCanonicalPath) {
  folder.add("inner/file", "");
  fs::create_directory_symlink("inner", folder.path("link"));
  const std::string exact = folder.path("inner/file");
  EXPECT_EQ(canonical_path(folder.path("link/../inner/./file")), exact);
  EXPECT_EQ(canonical_path(folder.path("link/file")), exact);
  const fs::path old_folder = fs::current_path();
  fs::current_path(folder.path());
  EXPECT_EQ(canonical_path("inner/file"), exact);
  EXPECT_EQ(canonical_path("link/nowhere"), folder.path("inner/nowhere"));
  EXPECT_EQ(canonical_path("nowhere/at/all"), folder.path("nowhere/at/all"));
  fs::current_path(old_folder);
}

}  // namespace
}  // namespace grf
