// Tests of the supervisor with child processes that crash, hang or run out of memory.
#include "converters/command/supervisor.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <new>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "converters/command/file_work.h"
#include "grf/text_file.h"
#include "tests/cli/grfconvert.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

using testing::ElementsAre;

[[noreturn]] void hang() {
  for (;;) ::pause();
}

/// Runs jobs in child processes and returns how each exited.
std::map<std::size_t, ChildExit> child_exits_of(const std::vector<std::function<ExitCode()>>& work,
                                                const Limits& limits = {}, std::size_t at_once = 1) {
  std::map<std::size_t, ChildExit> child_exits;
  Jobs jobs;
  jobs.count = work.size();
  jobs.at_once = at_once;
  jobs.work = [&](std::size_t job) { return work[job](); };
  jobs.ended = [&](std::size_t job, const ChildExit& child_exit) {
    EXPECT_TRUE(child_exits.emplace(job, child_exit).second);
  };
  std::vector<pid_t> left;
  EXPECT_TRUE(run_supervised(jobs, limits, left));
  EXPECT_TRUE(left.empty());
  return child_exits;
}

ChildExit child_exit_of(const std::function<ExitCode()>& work, const Limits& limits = {}) {
  return child_exits_of({work}, limits).at(0);
}

TEST(Supervisor, HandsOverWhatTheChildReturnsAndPrints) {
  const ChildExit child_exit = child_exit_of([] {
    std::printf("out\n");
    std::fprintf(stderr, "%s", std::string(1'000'000, 'e').c_str());
    return ExitCode::BadCommandLine;
  });
  EXPECT_EQ(child_exit.cause, ChildExit::Cause::Returned);
  EXPECT_EQ(child_exit.code, ExitCode::BadCommandLine);
  EXPECT_EQ(child_exit.out, "out\n");
  EXPECT_EQ(child_exit.err.size(), 1'000'000U);
  EXPECT_NE(child_exit.process, ::getpid());
}

TEST(Supervisor, SurvivesCrashes) {
  for (const int signal : {SIGABRT, SIGKILL, SIGFPE}) {
    const ChildExit child_exit = child_exit_of([signal] {
      std::printf("before");
      std::fflush(stdout);
      std::signal(signal, SIG_DFL);
      ::raise(signal);
      return ExitCode::Done;
    });
    EXPECT_EQ(child_exit.cause, ChildExit::Cause::Crashed);
    EXPECT_EQ(child_exit.signal, signal);
    EXPECT_EQ(child_exit.out, "before");
  }
}

TEST(Supervisor, TellsExceptionsApart) {
  const ChildExit memory = child_exit_of([]() -> ExitCode { throw std::bad_alloc(); });
  EXPECT_EQ(memory.cause, ChildExit::Cause::OutOfMemory);
  const ChildExit other = child_exit_of([]() -> ExitCode { throw std::runtime_error("what it was"); });
  EXPECT_EQ(other.cause, ChildExit::Cause::Returned);
  EXPECT_EQ(other.code, ExitCode::BadInput);
  EXPECT_EQ(other.err, "error: what it was\n");
}

TEST(Supervisor, EndsWhatHangs) {
  const auto start = std::chrono::steady_clock::now();
  Limits limits;
  limits.seconds = 0.2;
  const auto child_exits =
      child_exits_of({[]() -> ExitCode { hang(); }, [] { return ExitCode::Done; }}, limits);
  EXPECT_EQ(child_exits.at(0).cause, ChildExit::Cause::OutOfTime);
  EXPECT_EQ(child_exits.at(1).cause, ChildExit::Cause::Returned) << "the others are done all the same";
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Supervisor, LimitsMemory) {
  if (!test::LimitsMemory) GTEST_SKIP();
  const auto eat = [] {
    std::vector<std::string> eaten;
    for (int i = 0; i < 100; ++i) eaten.emplace_back(10U << 20U, 'x');
    return eaten.size() == 100 ? ExitCode::Done : ExitCode::BadInput;
  };
  Limits limits;
  limits.memory = 400U << 20U;
  EXPECT_EQ(child_exit_of(eat, limits).cause, ChildExit::Cause::OutOfMemory);
  limits.memory = 0;
  EXPECT_EQ(child_exit_of(eat, limits).cause, ChildExit::Cause::Returned);
}

TEST(Supervisor, LeavesNoCoreDumps) {
  const ChildExit child_exit = child_exit_of([] {
    rlimit limit = {};
    ::getrlimit(RLIMIT_CORE, &limit);
    return limit.rlim_cur == 0 && limit.rlim_max == 0 ? ExitCode::Done : ExitCode::BadInput;
  });
  EXPECT_EQ(child_exit.code, ExitCode::Done);
}

TEST(Supervisor, RunsSeveralAtOnceAndNoMore) {
  const test::TemporaryFolder folder;
  const auto work = [&folder]() {
    const std::string own = folder.path(std::to_string(::getpid()));
    folder.add(std::to_string(::getpid()), "");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    std::printf("%zu", folder.names().size());
    return std::remove(own.c_str()) == 0 ? ExitCode::Done : ExitCode::BadInput;
  };
  const std::vector<std::function<ExitCode()>> nine(9, work);
  int most = 0;
  for (const auto& [job, child_exit] : child_exits_of(nine, {}, 3))
    most = std::max(most, std::stoi(child_exit.out));
  EXPECT_EQ(most, 3);
  for (const auto& [job, child_exit] : child_exits_of(nine, {}, 1)) EXPECT_EQ(child_exit.out, "1");
}

TEST(Supervisor, EndsTheOthersIfItsCallerThrows) {
  Jobs jobs;
  jobs.count = 2;
  jobs.at_once = 2;
  jobs.work = [](std::size_t job) -> ExitCode {
    if (job == 1) hang();
    return ExitCode::Done;
  };
  jobs.ended = [](std::size_t, const ChildExit&) { throw std::runtime_error("enough"); };
  std::vector<pid_t> left;
  EXPECT_THROW(run_supervised(jobs, {}, left), std::runtime_error);
  EXPECT_LT(::waitpid(-1, nullptr, WNOHANG), 0) << "there is no child any more";
}

/// Files whose job hangs, crashes or returns while it writes its output.
class FilesThatFail : public testing::Test {
 protected:
  test::TemporaryFolder folder_;

  FileWork work_for(const std::vector<std::string>& names) {
    FileWork work;
    work.inputs = names;
    for (const std::string& name : names) work.outputs.push_back(folder_.path(name));
    work.work = [this, names](std::size_t file) { return write(names[file]); };
    work.done = [this](const FileWork::Result& result) { results_.push_back(result); };
    return work;
  }

  ExitCode write(const std::string& name) const {
    grf::Diagnostics diagnostics;
    grf::replace_file(
        folder_.path(name),
        [&](const grf::FileWriter& writer) {
          writer("half");
          if (name == "hangs") hang();
          if (name == "dies") ::raise(SIGKILL);
          return writer(" and half");
        },
        diagnostics);
    return ExitCode::Done;
  }

  std::vector<FileWork::Result> results_;
};

TEST_F(FilesThatFail, LeaveNothingHalfWritten) {
  FileWork work = work_for({"dies", "hangs", "good"});
  work.limits.seconds = 2;
  testing::internal::CaptureStderr();
  EXPECT_EQ(run(work), ExitCode::BadInput);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "dies: error: the conversion crashed (Killed)\n"
            "hangs: error: exceeded the time limit of 2 s\n");
  EXPECT_THAT(folder_.names(), ElementsAre("good"));
  EXPECT_EQ(test::bytes_of(folder_.path("good")), "half and half");
  ASSERT_EQ(results_.size(), 3U);
  EXPECT_FALSE(results_[0].has_ended || results_[1].has_ended);
  EXPECT_TRUE(results_[2].has_ended);
}

TEST_F(FilesThatFail, AreEndedByASignal) {
  for (const int signal : {SIGINT, SIGTERM}) {
    FileWork work = work_for({"good", "hangs", "never"});
    const pid_t parent = ::fork();
    ASSERT_GE(parent, 0);
    if (parent == 0) ::_exit(static_cast<int>(run(work)));
    // Once the second child writes, it hangs.
    while (folder_.names().size() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ::kill(parent, signal);
    int status = 0;
    ASSERT_EQ(::waitpid(parent, &status, 0), parent);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_THAT(folder_.names(), ElementsAre("good"));
  }
}

}  // namespace
}  // namespace convert
