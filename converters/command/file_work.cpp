#include "converters/command/file_work.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "confinement/confinement.h"
#include "grf/text_file.h"

namespace convert {
namespace {

std::string size_text(std::uint64_t bytes) {
  constexpr double Giga = 1U << 30U;
  constexpr double Mega = 1U << 20U;
  const auto size = static_cast<double>(bytes);
  return size < Giga ? fmt::format("{:.4g} MB", size / Mega) : fmt::format("{:.4g} GB", size / Giga);
}

/// Returns the error message for a child that crashed or exceeded a limit.
std::string reason_of_failure(const ChildExit& child_exit, const Limits& limits) {
  switch (child_exit.cause) {
    case ChildExit::Cause::OutOfMemory:
      return limits.memory == 0 ? "out of memory"
                                : fmt::format("exceeded the memory limit of {}", size_text(limits.memory));
    case ChildExit::Cause::OutOfTime:
      return fmt::format("exceeded the time limit of {:g} s", limits.seconds);
    case ChildExit::Cause::Crashed:
      return fmt::format("the conversion crashed ({})", ::strsignal(child_exit.signal));
    case ChildExit::Cause::Returned:
      break;
  }
  return {};
}

std::string folder_of(const std::string& path) {
  return std::filesystem::path(grf::canonical_path(path)).parent_path().string();
}

/// Removes what killed processes have left in the folders of outputs.
void remove_what_is_left(const FileWork& work, const std::vector<pid_t>& processes) {
  std::set<std::string> folders;
  for (const std::string& output : work.outputs) folders.insert(folder_of(output));
  for (const std::string& output : work.other_outputs) folders.insert(folder_of(output));
  for (const pid_t process : processes) {
    for (const std::string& folder : folders) grf::remove_temporary_files(folder, process);
  }
}

/// Returns what the child for a file may use: what is around its input, and around its outputs what it might
/// replace. The shared libraries are loaded by now.
confinement::Policy policy_for(const FileWork& work, std::size_t file) {
  confinement::Policy policy;
  policy.readable = confinement::paths_around(work.inputs[file]);
  policy.readable.insert(policy.readable.end(), work.limits.readable.begin(), work.limits.readable.end());
  std::vector<std::string> outputs = work.other_outputs;
  if (!work.outputs.empty()) outputs.push_back(work.outputs[file]);
  for (const std::string& output : outputs) {
    for (std::string& path : confinement::paths_beside(output)) policy.readable.push_back(std::move(path));
    policy.writable.push_back(folder_of(output));
  }
  return policy;
}

FileWork::Result result_of(std::size_t file, const ChildExit& child_exit) {
  FileWork::Result result;
  result.file = file;
  result.has_ended = child_exit.cause == ChildExit::Cause::Returned;
  result.code = result.has_ended ? child_exit.code : ExitCode::BadInput;
  if (result.has_ended) result.out = child_exit.out;
  return result;
}

}  // namespace

ExitCode run(const FileWork& work) {
  ExitCode code = ExitCode::Done;
  Jobs jobs;
  jobs.count = work.inputs.size();
  jobs.at_once = work.at_once;
  // libseccomp crashes if it runs out of memory.
  jobs.prepare = [&work](std::size_t file) { confinement::confine(policy_for(work, file)); };
  jobs.work = work.work;
  jobs.ended = [&](std::size_t file, const ChildExit& child_exit) {
    const FileWork::Result result = result_of(file, child_exit);
    work.before_errors(result);
    fmt::print(stderr, "{}", child_exit.err);
    if (!result.has_ended) {
      grf::Diagnostics diagnostics;
      diagnostics.error(grf::whole_file(work.inputs[file]), reason_of_failure(child_exit, work.limits));
      print(diagnostics, true);
      remove_what_is_left(work, {child_exit.process});
    }
    if (result.code != ExitCode::Done) code = jobs.count == 1 ? result.code : ExitCode::BadInput;
    work.done(result);
  };
  std::vector<pid_t> left;
  if (run_supervised(jobs, work.limits, left)) return code;
  remove_what_is_left(work, left);
  return ExitCode::Interrupted;
}

}  // namespace convert
