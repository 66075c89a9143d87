#include "converters/command/supervisor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "confinement/address_space.h"

namespace convert {
namespace {

using grf::ExitCode;
using Clock = std::chrono::steady_clock;

/// A child's exit code after a failed allocation, different from all ExitCodes.
constexpr int OutOfMemoryCode = 3;

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// An in-memory file for a child's output, so that it never blocks on a full pipe.
class Capture {
 public:
  explicit Capture(const char* name) : descriptor_(::memfd_create(name, MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail("memfd_create");
  }
  Capture(Capture&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;
  Capture& operator=(Capture&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~Capture() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  int descriptor() const { return descriptor_; }
  std::string text() const {
    std::string text;
    std::array<char, 65536> part;
    for (;;) {
      const ssize_t count = ::pread(descriptor_, part.data(), part.size(), static_cast<off_t>(text.size()));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(part.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  int descriptor_;
};

/// Blocks the signals that are waited for, and restores the signal mask in the destructor.
class HeldSignals {
 public:
  HeldSignals() {
    ::sigemptyset(&set_);
    for (const int signal : {SIGCHLD, SIGINT, SIGTERM}) ::sigaddset(&set_, signal);
    ::sigprocmask(SIG_BLOCK, &set_, &before_);
    // If SIGCHLD were ignored, the end of a child would not be reported.
    struct sigaction heeded = {};
    heeded.sa_handler = SIG_DFL;
    ::sigaction(SIGCHLD, &heeded, &child_before_);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals() {
    ::sigaction(SIGCHLD, &child_before_, nullptr);
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }

  void release() const { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }

  /// Waits for the next signal; returns 0 after the timeout, if there is one.
  int wait(std::optional<Clock::duration> longest) const {
    if (!longest) return std::max(::sigwaitinfo(&set_, nullptr), 0);
    const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(*longest).count();
    constexpr std::int64_t Second = 1'000'000'000;
    const timespec timeout = {static_cast<time_t>(nanoseconds / Second),
                              static_cast<long>(nanoseconds % Second)};
    return std::max(::sigtimedwait(&set_, nullptr, &timeout), 0);
  }

 private:
  sigset_t set_ = {};
  sigset_t before_ = {};
  struct sigaction child_before_ = {};
};

struct Child {
  std::size_t job = 0;
  pid_t process = 0;
  std::optional<Clock::time_point> deadline;
  bool is_out_of_time = false;
  Capture out;
  Capture err;
};

void limit_resources(const Limits& limits) {
  const rlimit none = {0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  if (confinement::CanLimitAddressSpace && limits.memory > 0) {
    const rlimit memory = {limits.memory, limits.memory};
    ::setrlimit(RLIMIT_AS, &memory);
  }
}

/// Runs a job in the child and exits.
[[noreturn]] void work_and_exit(const Jobs& jobs, std::size_t job) {
  int code = 0;
  try {
    code = static_cast<int>(jobs.work(job));
  } catch (const std::bad_alloc&) {
    code = OutOfMemoryCode;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    code = static_cast<int>(ExitCode::BadInput);
  }
  std::fflush(nullptr);
  ::_exit(code);  // without the parent's exit handlers
}

ChildExit child_exit_of(const Child& child, int status) {
  ChildExit child_exit;
  child_exit.process = child.process;
  child_exit.out = child.out.text();
  child_exit.err = child.err.text();
  if (WIFSIGNALED(status)) {
    child_exit.cause = child.is_out_of_time ? ChildExit::Cause::OutOfTime : ChildExit::Cause::Crashed;
    child_exit.signal = WTERMSIG(status);
  } else if (WEXITSTATUS(status) == OutOfMemoryCode) {
    child_exit.cause = ChildExit::Cause::OutOfMemory;
  } else {
    child_exit.code = static_cast<ExitCode>(WEXITSTATUS(status));
  }
  return child_exit;
}

class Supervisor {
 public:
  Supervisor(const Jobs& jobs, const Limits& limits) : jobs_(jobs), limits_(limits) {}
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;
  ~Supervisor() { end_all(); }

  bool run() {
    while (next_ < jobs_.count || !children_.empty()) {
      while (next_ < jobs_.count && children_.size() < std::max<std::size_t>(jobs_.at_once, 1)) start();
      const int signal = signals_.wait(time_left());
      if (signal == SIGINT || signal == SIGTERM) return false;
      end_late_ones();
      reap();
    }
    return true;
  }

  /// Kills all children, and returns their process ids.
  std::vector<pid_t> end_all() {
    std::vector<pid_t> ended;
    for (const Child& child : children_) {
      ::kill(child.process, SIGKILL);
      while (::waitpid(child.process, nullptr, 0) < 0 && errno == EINTR) {
      }
      ended.push_back(child.process);
    }
    children_.clear();
    return ended;
  }

 private:
  void start() {
    std::fflush(nullptr);  // or the child would print the buffered output again
    Child child{next_++, 0, std::nullopt, false, Capture("out"), Capture("err")};
    const pid_t parent = ::getpid();
    child.process = ::fork();
    if (child.process < 0) fail("fork");
    if (child.process == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() != parent) ::_exit(OutOfMemoryCode);  // the parent died before
      ::dup2(child.out.descriptor(), STDOUT_FILENO);
      ::dup2(child.err.descriptor(), STDERR_FILENO);
      signals_.release();
      jobs_.prepare(child.job);
      limit_resources(limits_);
      work_and_exit(jobs_, child.job);
    }
    constexpr double Years = 1e9;  // in seconds, which does not overflow the clock
    const std::chrono::duration<double> longest(std::min(limits_.seconds, Years));
    if (limits_.seconds > 0) {
      child.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(longest);
    }
    children_.push_back(std::move(child));
  }

  std::optional<Clock::duration> time_left() const {
    std::optional<Clock::duration> left;
    const auto now = Clock::now();
    for (const Child& child : children_) {
      if (!child.deadline || child.is_out_of_time) continue;
      const auto until = std::max(*child.deadline - now, Clock::duration(0));
      left = left ? std::min(*left, until) : until;
    }
    return left;
  }

  void end_late_ones() {
    const auto now = Clock::now();
    for (Child& child : children_) {
      if (!child.deadline || child.is_out_of_time || now < *child.deadline) continue;
      child.is_out_of_time = true;
      ::kill(child.process, SIGKILL);
    }
  }

  // Pending SIGCHLD are merged: one signal can be for several children.
  void reap() {
    for (std::size_t i = 0; i < children_.size();) {
      int status = 0;
      if (::waitpid(children_[i].process, &status, WNOHANG) != children_[i].process) {
        ++i;
        continue;
      }
      std::swap(children_[i], children_.back());
      const Child child = std::move(children_.back());
      children_.pop_back();
      jobs_.ended(child.job, child_exit_of(child, status));
    }
  }

  const Jobs& jobs_;
  const Limits& limits_;
  HeldSignals signals_;
  std::size_t next_ = 0;
  std::vector<Child> children_;
};

}  // namespace

bool run_supervised(const Jobs& jobs, const Limits& limits, std::vector<pid_t>& left) {
  Supervisor supervisor(jobs, limits);
  if (supervisor.run()) return true;
  left = supervisor.end_all();
  return false;
}

}  // namespace convert
