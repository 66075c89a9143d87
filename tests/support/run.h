// Programs are run as by a shell, for tests of command lines.
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test {

/// The exit code and output of a program.
struct Outcome {
  int exit_code = 0;  ///< minus the signal, if a signal killed the program
  std::string out;
  std::string err;
};

namespace detail {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

/// Opens a temporary file, so that a program can print any amount without waiting for a reader.
inline File temporary_file() {
  File file(std::tmpfile());
  if (!file) throw std::system_error(errno, std::generic_category(), "tmpfile");
  return file;
}

inline std::string contents(std::FILE* file) {
  std::rewind(file);
  std::string bytes;
  std::array<char, 4096> part = {};
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), file)) {
    bytes.append(part.data(), count);
  }
  return bytes;
}

}  // namespace detail

/// A signal to send to a program, after a delay since its start or the signal before.
struct Interruption {
  int signal = SIGINT;
  std::chrono::milliseconds after = std::chrono::milliseconds(0);
};

/// Runs the program whose path is the first word, with the others as its arguments, and waits until it exits.
inline Outcome run(const std::vector<std::string>& command, std::string_view input = {},
                   const std::vector<Interruption>& interruptions = {}) {
  const std::array<detail::File, 3> files = {detail::temporary_file(), detail::temporary_file(),
                                             detail::temporary_file()};
  std::fwrite(input.data(), 1, input.size(), files[0].get());
  std::rewind(files[0].get());

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int i = 0; i < 3; ++i) posix_spawn_file_actions_adddup2(&actions, ::fileno(files[i].get()), i);
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t process = 0;
  const int failure = ::posix_spawn(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::system_error(failure, std::generic_category(), command[0]);

  for (const Interruption& interruption : interruptions) {
    std::this_thread::sleep_for(interruption.after);
    ::kill(process, interruption.signal);
  }
  int status = 0;
  if (::waitpid(process, &status, 0) != process) throw std::runtime_error("waitpid failed");
  const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return {exit_code, detail::contents(files[1].get()), detail::contents(files[2].get())};
}

}  // namespace test
