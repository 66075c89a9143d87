// Tests what a child that reads an untrusted file can do once the file has taken control of it: it tries all
// of it under the very confinement of `grfconvert`.
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include "confinement/confinement.h"
#include "converters/command/file_work.h"
#include "grf/text_file.h"
#include "tests/cli/grfconvert.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// An attempt: its name, and a system call that returns a negative number if it fails.
struct Attempt {
  std::string name;
  std::function<long()> act;
};

long try_to_open(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags, 0600);
  if (file >= 0) ::close(file);
  return file;
}

/// A home folder with a model in it, and files that are none of the model's business.
class ConfinedChild : public testing::Test {
 protected:
  ConfinedChild() { ::setenv("HOME", home_.c_str(), 1); }
  ~ConfinedChild() override { ::setenv("HOME", old_home_.c_str(), 1); }

  std::string old_home_ = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "/";
  test::TemporaryFolder folder_;
  std::string secret_ = folder_.add("home/secret", "of the user");
  std::string key_ = folder_.add("home/.ssh/key", "of the user");
  std::string outside_ = folder_.add("outside/file", "of another program");
  std::string input_ = folder_.add("home/models/car/source/car.obj", test::Triangle);
  std::string texture_ = folder_.add("home/models/car/textures/paint.png", "colours");
  std::string output_ = folder_.add("home/converted/old.grf", "old");
  std::string home_ = folder_.path("home");
  std::string source_ = folder_.path("home/models/car/source");
  std::string converted_ = folder_.path("home/converted");

  FileWork work() const {
    FileWork work;
    work.inputs = {input_};
    work.outputs = {output_};
    return work;
  }

  /// Makes the attempts in a child of the work, and returns the names of those that succeeded, or that failed
  /// for another reason than a lack of permission.
  static std::string not_refused(FileWork work, const std::vector<Attempt>& attempts) {
    work.work = [&](std::size_t) {
      for (const Attempt& attempt : attempts) {
        errno = 0;
        const long result = attempt.act();
        const bool is_refused = result < 0 && (errno == EACCES || errno == EPERM || errno == EXDEV);
        if (!is_refused) fmt::print("{} ({}, errno {})\n", attempt.name, result, errno);
        std::fflush(stdout);  // another program would lose it
      }
      return ExitCode::Done;
    };
    std::string printed = "no child has ended";
    work.done = [&](const FileWork::Result& result) { printed = result.has_ended ? result.out : "crashed"; };
    EXPECT_EQ(run(work), ExitCode::Done);
    return printed;
  }

  std::vector<Attempt> attempts_at_files() const {
    const std::string moved = converted_ + "/moved";
    return {
        {"read the home folder", [this] { return try_to_open(home_, O_RDONLY | O_DIRECTORY); }},
        {"read a file of it", [this] { return try_to_open(secret_, O_RDONLY); }},
        {"read a hidden file of it", [this] { return try_to_open(key_, O_RDONLY); }},
        {"read a file two folders above",
         [this] { return try_to_open(source_ + "/../../../secret", O_RDONLY); }},
        {"read accounts", [] { return try_to_open("/etc/passwd", O_RDONLY); }},
        {"read the processes", [] { return try_to_open("/proc", O_RDONLY); }},
        {"read a device", [] { return try_to_open("/dev/zero", O_RDONLY); }},
        {"write to the input", [this] { return try_to_open(input_, O_WRONLY); }},
        {"cut the input", [this] { return try_to_open(input_, O_RDONLY | O_TRUNC); }},
        {"cut by path", [this] { return ::truncate(input_.c_str(), 0); }},
        {"write beside the input", [this] { return try_to_open(source_ + "/new", O_WRONLY | O_CREAT); }},
        {"write to the home folder", [this] { return try_to_open(home_ + "/new", O_WRONLY | O_CREAT); }},
        {"write for all programs", [] { return try_to_open("/tmp/granada_new", O_WRONLY | O_CREAT); }},
        {"write to itself", [] { return try_to_open("/proc/self/mem", O_RDWR); }},
        {"make a folder", [this] { return ::mkdir((home_ + "/folder").c_str(), 0700); }},
        {"remove a file", [this] { return ::unlink(outside_.c_str()); }},
        {"rename a file", [this, moved] { return ::rename(outside_.c_str(), moved.c_str()); }},
        {"rename its output", [this] { return ::rename(output_.c_str(), (home_ + "/.profile").c_str()); }},
        {"link a file", [this, moved] { return ::link(secret_.c_str(), moved.c_str()); }},
        {"make a symbolic link", [this, moved] { return ::symlink(secret_.c_str(), moved.c_str()); }},
        {"make a pipe", [moved] { return ::mkfifo(moved.c_str(), 0600); }},
        {"change permissions", [this] { return ::chmod(outside_.c_str(), 0777); }},
        {"change an owner", [this] { return ::chown(outside_.c_str(), 1, 1); }},
        {"change the folder of names", [this] { return ::chdir(home_.c_str()); }},
        {"change the root", [this] { return ::chroot(source_.c_str()); }},
    };
  }

  static std::vector<Attempt> attempts_at_other_things() {
    const pid_t victim = ::getpid();  // the parent of the child that makes the attempts
    return {
        {"socket of the internet", [] { return ::socket(AF_INET, SOCK_STREAM, 0); }},
        {"datagrams", [] { return ::socket(AF_INET6, SOCK_DGRAM, 0); }},
        {"socket of this machine", [] { return ::socket(AF_UNIX, SOCK_STREAM, 0); }},
        {"socket of the kernel", [] { return ::socket(AF_NETLINK, SOCK_RAW, 0); }},
        {"pair of sockets",
         [] {
           std::array<int, 2> pair = {};
           return ::socketpair(AF_UNIX, SOCK_STREAM, 0, pair.data());
         }},
        {"connect",
         [] {
           const sockaddr_in address = {};
           return ::connect(0, reinterpret_cast<const sockaddr*>(&address), sizeof(address));
         }},
        {"another program",
         [] {
           std::array<char*, 1> none = {nullptr};
           return ::execve("/bin/true", none.data(), none.data());
         }},
        {"another process",
         [] {
           const long process = ::syscall(SYS_fork);
           if (process == 0) ::_exit(0);
           return process;
         }},
        {"another process by clone",
         [] {
           const long process = ::syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, nullptr);
           if (process == 0) ::_exit(0);
           return process;
         }},
        {"a signal to its parent", [victim] { return ::kill(victim, SIGURG); }},
        {"a signal to all", [] { return ::kill(-1, 0); }},
        {"a signal with a value", [victim] { return ::sigqueue(victim, SIGURG, sigval{.sival_int = 0}); }},
        {"tracing its parent", [victim] { return ::ptrace(PTRACE_ATTACH, victim, nullptr, nullptr); }},
        {"the memory of its parent",
         [victim] {
           char byte = 0;
           const iovec here = {&byte, 1};
           const iovec there = {&byte, 1};
           return ::process_vm_readv(victim, &here, 1, &there, 1, 0);
         }},
        {"the limits of its parent",
         [victim] {
           const rlimit limit = {0, 0};
           return ::prlimit(victim, RLIMIT_CORE, &limit, nullptr);
         }},
        {"words into a terminal", [] { return ::ioctl(0, TIOCSTI, "x"); }},
        {"signals about a file", [victim] { return ::fcntl(0, F_SETOWN, victim); }},
        {"a queue past the filter", [] { return ::syscall(SYS_io_uring_setup, 1, nullptr); }},
        {"a program of the kernel", [] { return ::syscall(SYS_bpf, 0, nullptr, 0); }},
        {"a name space", [] { return ::syscall(SYS_unshare, 0x10000000); }},
    };
  }
};

TEST_F(ConfinedChild, ReadsItsInputAndWritesItsOutput) {
  FileWork work = this->work();
  work.work = [this](std::size_t) {
    grf::Diagnostics diagnostics;
    const auto input = grf::read_file(input_, diagnostics);
    const auto texture = grf::read_file(source_ + "/../textures/paint.png", diagnostics);
    const auto old = grf::read_file(output_, diagnostics);
    bool has_thread = false;
    std::thread([&] { has_thread = true; }).join();
    const bool is_written =
        grf::replace_file(output_, "new", diagnostics) &&
        grf::create_file(converted_ + "/paint.png", "colours", diagnostics) == grf::Creation::Done;
    print(diagnostics, false);
    return input && texture && old && has_thread && is_written ? ExitCode::Done : ExitCode::BadInput;
  };
  work.done = [](const FileWork::Result& result) { EXPECT_TRUE(result.has_ended); };
  EXPECT_EQ(run(work), ExitCode::Done);
  EXPECT_EQ(test::bytes_of(output_), "new");
  EXPECT_EQ(test::bytes_of(converted_ + "/paint.png"), "colours");
}

TEST_F(ConfinedChild, HasNoNetworkAndNoOtherProcesses) {
  if (!confinement::available().has_seccomp) GTEST_SKIP();
  EXPECT_THAT(not_refused(work(), attempts_at_other_things()), IsEmpty());
}

TEST_F(ConfinedChild, UsesNoFilesButItsOwn) {
  if (confinement::available().landlock == 0) GTEST_SKIP();
  EXPECT_THAT(not_refused(work(), attempts_at_files()), IsEmpty());
  EXPECT_EQ(test::bytes_of(outside_), "of another program");
  EXPECT_EQ(test::bytes_of(input_), test::Triangle);
}

TEST_F(ConfinedChild, InheritsNoFiles) {
  const int inherited = ::open(home_.c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_GE(inherited, 0);
  FileWork work = this->work();
  work.work = [&](std::size_t) {
    return ::fcntl(inherited, F_GETFD) < 0 && errno == EBADF ? ExitCode::Done : ExitCode::BadInput;
  };
  work.done = [](const FileWork::Result&) {};
  EXPECT_EQ(run(work), ExitCode::Done);
  ::close(inherited);
}

TEST_F(ConfinedChild, OfAModelInTheHomeFolderReadsOnlyTheVisibleFilesThere) {
  if (confinement::available().landlock == 0) GTEST_SKIP();
  FileWork work = this->work();
  work.inputs = {folder_.add("home/model.obj", test::Triangle)};
  const std::string texture = folder_.add("home/texture.png", "");
  const std::string profile = folder_.add("home/.profile", "");
  EXPECT_THAT(not_refused(work, {{"read a texture", [=] { return try_to_open(texture, O_RDONLY); }}}),
              HasSubstr("read a texture ("));
  EXPECT_THAT(not_refused(work, {{"read a key", [this] { return try_to_open(key_, O_RDONLY); }},
                                 {"read a hidden file", [=] { return try_to_open(profile, O_RDONLY); }},
                                 {"read another model", [this] { return try_to_open(input_, O_RDONLY); }},
                                 {"read around it", [this] { return try_to_open(outside_, O_RDONLY); }}}),
              IsEmpty());
}

TEST_F(ConfinedChild, WithoutLandlockHasNoNetworkNonetheless) {
  if (!confinement::available().has_seccomp) GTEST_SKIP();
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    // As a kernel that does not have it.
    scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ALLOW);
    ::seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(landlock_create_ruleset), 0);
    ::seccomp_load(filter);
    const confinement::Strength strength = confinement::confine({{input_}, {}});
    const bool is_expected = strength.landlock == 0 && strength.has_seccomp &&
                             ::socket(AF_INET, SOCK_STREAM, 0) < 0 && try_to_open(secret_, O_RDONLY) >= 0;
    ::_exit(is_expected ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(
      confinement::description({0, true}),
      "files not confined, since this kernel has no Landlock; network and processes confined by seccomp");
}

TEST_F(ConfinedChild, OfGrfconvertWarnsOfFilesThatAModelMayNotName) {
  if (confinement::available().landlock == 0) GTEST_SKIP();
  const std::string model =
      folder_.add("home/models/car/source/thief.obj", "mtllib ../../../secret\n" + test::Triangle);
  const std::string output = folder_.path("home/converted/thief.grf");
  const test::Outcome outcome = test::grfconvert({model, "-o", output});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(model + ":1:1: warning: cannot read '" + secret_ +
                                     "': it is outside of the folders that are read"));
  EXPECT_THAT(outcome.out, HasSubstr("1 face"));
}

TEST_F(ConfinedChild, OfGrfconvertReadsFoldersThatAreGranted) {
  if (confinement::available().landlock == 0) GTEST_SKIP();
  const std::string included = folder_.add("home/shapes/one.grf", "begin mesh" + test::Faces);
  const std::string scene = folder_.add("home/scenes/a/b/scene.grf", "include \"../../../shapes/one.grf\"");
  const test::Outcome outcome = test::grfconvert({"check", scene});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("it is outside of the folders that are read"));
  EXPECT_EQ(test::grfconvert({"check", scene, "--readable", folder_.path("home/shapes")}).exit_code, 0);
}

}  // namespace
}  // namespace convert
