#include "confinement/system_calls.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <memory>

#include <fcntl.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace confinement {
namespace {

struct Release {
  void operator()(void* filter) const { ::seccomp_release(filter); }
};
using Filter = std::unique_ptr<void, Release>;

/// What a program needs that computes, starts threads, and reads and writes files. Whether it may open a file
/// is up to Landlock. Not listed, among others: sockets, other programs, other processes and their memory,
/// signals to them, changes of permissions and times by a path, which Landlock does not confine, and
/// io_uring, which would get around this filter.
constexpr std::array FreeCalls = {
    // memory
    "brk", "madvise", "mincore", "mmap", "mprotect", "mremap", "msync", "munmap",
    // open files
    "close", "close_range", "copy_file_range", "dup", "dup2", "dup3", "fadvise64", "fallocate", "fchmod",
    "fdatasync", "flock", "fstat", "fstatfs", "fsync", "ftruncate", "getdents64", "lseek", "pipe2", "poll",
    "ppoll", "pread64", "preadv", "preadv2", "pselect6", "pwrite64", "pwritev", "read", "readv", "select",
    "sendfile", "write", "writev",
    // files by their paths
    "access", "faccessat", "faccessat2", "getcwd", "getdents", "link", "linkat", "lstat", "mkdir", "mkdirat",
    "newfstatat", "readlink", "readlinkat", "rename", "renameat", "renameat2", "rmdir", "stat", "statfs",
    "statx", "umask", "unlink", "unlinkat",
    // threads
    "futex", "futex_waitv", "get_robust_list", "getcpu", "gettid", "membarrier", "rseq", "sched_getaffinity",
    "sched_getparam", "sched_getscheduler", "sched_yield", "set_robust_list", "set_tid_address",
    // time
    "clock_getres", "clock_gettime", "clock_nanosleep", "gettimeofday", "nanosleep", "time", "times",
    // signals and the end of this process
    "exit", "exit_group", "restart_syscall", "rt_sigaction", "rt_sigpending", "rt_sigprocmask",
    "rt_sigreturn", "rt_sigsuspend", "rt_sigtimedwait", "pause", "sigaltstack",
    // facts
    "arch_prctl", "getegid", "geteuid", "getgid", "getgroups", "getpgrp", "getpid", "getppid", "getpriority",
    "getrandom", "getresgid", "getresuid", "getrlimit", "setrlimit", "getrusage", "getuid", "sysinfo",
    "uname"};

/// A condition on an argument of a call. The macros of libseccomp for it are compound literals, which are not
/// of C++.
scmp_arg_cmp argument(unsigned number, scmp_compare comparison, scmp_datum_t first, scmp_datum_t second = 0) {
  return {number, comparison, first, second};
}

bool allow(const Filter& filter, const char* name) {
  const int call = ::seccomp_syscall_resolve_name(name);
  // An architecture has some of them only, and libseccomp knows some of the newest only.
  if (call == __NR_SCMP_ERROR) return true;
  const int problem = ::seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, 0, nullptr);
  return problem == 0 || problem == -EDOM;
}

bool allow(const Filter& filter, int call, const scmp_arg_cmp& argument) {
  return ::seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, 1, &argument) == 0;
}

/// Opening to truncate without writing: the kernel does it, and Landlock before its version 3 lets it pass.
bool allow_opening(const Filter& filter, int call, unsigned flags) {
  const scmp_datum_t relevant = O_TRUNC | O_ACCMODE;
  for (const scmp_datum_t allowed : {scmp_datum_t(O_RDONLY), scmp_datum_t(O_WRONLY), scmp_datum_t(O_RDWR),
                                     scmp_datum_t(O_WRONLY | O_TRUNC), scmp_datum_t(O_RDWR | O_TRUNC)}) {
    if (!allow(filter, call, argument(flags, SCMP_CMP_MASKED_EQ, relevant, allowed))) return false;
  }
  return true;
}

bool allow_with_arguments(const Filter& filter) {
  const auto self = static_cast<scmp_datum_t>(::getpid());
  bool is_complete = allow_opening(filter, SCMP_SYS(openat), 2);
#ifdef SYS_open
  is_complete = is_complete && allow_opening(filter, SCMP_SYS(open), 1);
#endif
  // Threads, but no processes. The flags of clone3 are out of a filter's sight: the C library takes clone
  // where the kernel does not have clone3.
  is_complete =
      is_complete &&
      allow(filter, SCMP_SYS(clone), argument(0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD)) &&
      ::seccomp_rule_add_array(filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0, nullptr) == 0;
  // Signals to itself, for abort.
  for (const int call : {SCMP_SYS(kill), SCMP_SYS(tgkill)})
    is_complete = is_complete && allow(filter, call, argument(0, SCMP_CMP_EQ, self));
  // Whether a stream is a terminal, and its width. Other controls of a terminal could type into it.
  for (const unsigned long control :
       {static_cast<unsigned long>(TCGETS), static_cast<unsigned long>(TIOCGWINSZ)})
    is_complete = is_complete && allow(filter, SCMP_SYS(ioctl), argument(1, SCMP_CMP_EQ, control));
  // Flags, copies and locks of descriptors. Others would choose whom signals about a descriptor go to.
  for (const int command :
       {F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_DUPFD, F_DUPFD_CLOEXEC, F_GETLK, F_SETLK, F_SETLKW})
    is_complete = is_complete && allow(filter, SCMP_SYS(fcntl),
                                       argument(1, SCMP_CMP_EQ, static_cast<scmp_datum_t>(command)));
  // The names of threads.
  for (const int option : {PR_SET_NAME, PR_GET_NAME})
    is_complete = is_complete &&
                  allow(filter, SCMP_SYS(prctl), argument(0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(option)));
  // Limits of this process, and not of others.
  is_complete = is_complete && allow(filter, SCMP_SYS(prlimit64), argument(0, SCMP_CMP_EQ, 0));
  return is_complete;
}

}  // namespace

bool has_system_call_filters() {
  constexpr unsigned ReturnErrno = SECCOMP_RET_ERRNO;
  return ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &ReturnErrno) == 0;
}

bool confine_system_calls() {
  // An error, not a signal: libraries try calls that they can do without, and a reader reports a file that it
  // may not open as any other that it cannot open. Calls for another architecture end the process.
  const Filter filter(::seccomp_init(SCMP_ACT_ERRNO(EPERM)));
  if (!filter) return false;
  // It also confines threads that a sanitizer has started.
  if (::seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_TSYNC, 1) != 0) return false;
  // Rules are sorted by their number: the last of 130 would be compared with all others otherwise.
  static_cast<void>(::seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2));
  for (const char* call : FreeCalls) {
    if (!allow(filter, call)) return false;
  }
  return allow_with_arguments(filter) && ::seccomp_load(filter.get()) == 0;
}

}  // namespace confinement
