#include "renderer/farm/worker.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "renderer/farm/stages.h"
#include "renderer/parallel/loops.h"

namespace farm {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds Pause{200};
constexpr milliseconds LongestPause{1000};
/// Between signs of life: many workers ask one server.
constexpr milliseconds SignInterval{2000};

/// The first digits of a digest, for messages.
std::string short_name(const transport::Digest& digest) { return transport::hex(digest).substr(0, 12); }

}  // namespace

Worker::Worker(const Farm& farm, WorkerSettings settings, std::function<void(const std::string&)> say)
    : farm_(farm),
      settings_(std::move(settings)),
      say_(std::move(say)),
      cache_(settings_.cache_folder, settings_.cache_bytes),
      renders_(std::make_unique<RunningRenders>()) {
  settings_.threads = parallel::threads_for(settings_.threads);
  info_ = {new_identifier(), host_name(), settings_.threads, settings_.version, "", ""};
}

void Worker::stop() {
  is_stopped_ = true;
  const std::lock_guard lock(lock_);
  renders_->stop();
}

bool Worker::run() {
  std::thread heartbeat([this] { run_heartbeat(); });
  milliseconds pause = Pause;
  while (!is_stopped_ && !farm_.is_closed()) {
    const auto job = next_job();
    if (!job) {
      std::this_thread::sleep_for(pause);
      pause = std::min(2 * pause, LongestPause);
      continue;
    }
    pause = Pause;
    const std::string reason = work_for(*job);
    if (reason.empty()) continue;
    refused_[job->id] = reason;
    say_(fmt::format("refused {} ({}): {}", job->id, job->name, reason));
    const std::lock_guard lock(lock_);
    info_.refused = reason;
  }
  const bool is_stopped = is_stopped_;
  is_stopped_ = true;
  heartbeat.join();
  return is_stopped;
}

/// Says from time to time that the worker is there, and keeps the leases of the tasks in work.
void Worker::run_heartbeat() {
  auto next_extension = Clock::now();
  auto next_sign = Clock::now();
  while (!is_stopped_) {
    std::this_thread::sleep_for(milliseconds(50));
    WorkerInfo info;
    {
      const std::lock_guard lock(lock_);
      if (Clock::now() >= next_extension) {
        for (const Message* message : in_work_) message->extend();
        next_extension = Clock::now() + extension_interval_;
      }
      info = info_;
    }
    if (Clock::now() < next_sign) continue;
    farm_.put_worker(info);
    next_sign = Clock::now() + SignInterval;
    if (info.job.empty()) continue;
    if (farm_.has_job(info.job) == false || farm_.why_dropped(info.job, info.id)) {
      const std::lock_guard lock(lock_);
      job_has_ended_ = true;
      renders_->stop();
    }
  }
}

/// Returns the oldest job that has tasks waiting and that the worker does not refuse.
std::optional<JobInfo> Worker::next_job() {
  const auto jobs = farm_.jobs();
  if (!jobs) return std::nullopt;
  std::erase_if(refused_, [&](const auto& refused) {
    return std::ranges::none_of(*jobs, [&](const JobInfo& job) { return job.id == refused.first; });
  });
  for (const JobInfo& job : *jobs) {
    if (refused_.contains(job.id)) continue;
    const auto state = farm_.task_state(job.id);
    if (state && state->waiting > 0) return job;
  }
  return std::nullopt;
}

/// Works for a job until it has ended or has no tasks; returns why not, or an empty text.
std::string Worker::work_for(const JobInfo& info) {
  {
    const std::lock_guard lock(lock_);
    renders_ = std::make_unique<RunningRenders>();
    if (is_stopped_) renders_->stop();
    job_has_ended_ = false;
    info_.job = info.id;
    extension_interval_ = milliseconds(static_cast<int>(1000 * info.lease_seconds / 3));
  }
  std::string reason = loaded_ == info.id ? "" : load(info);
  if (loaded_ == info.id) work_on_tasks(info);
  if (reason.empty()) reason = farm_.why_dropped(info.id, info_.id).value_or("");
  const std::lock_guard lock(lock_);
  info_.job.clear();
  return reason;
}

/// Fetches and reads a job, and renders its probe. Returns why it is refused, or an empty text; it is not
/// loaded, either, if the server did not answer or the worker was stopped.
std::string Worker::load(const JobInfo& info) {
  loaded_.clear();
  opened_.reset();
  if (info.version != settings_.version) {
    return fmt::format("it needs bpt {}, and this is bpt {}", info.version, settings_.version);
  }
  if (info.instruction_set != InstructionSet) {
    return fmt::format("it needs the instruction set {}, and this bpt uses {}", info.instruction_set,
                       InstructionSet);
  }
  grf::Diagnostics diagnostics;
  auto path = cache_.find(info.content);
  if (!path) {
    const auto bytes = farm_.content(info.content, info.bytes);
    if (!bytes) return "";
    path = cache_.add(info.content, *bytes, diagnostics);
  }
  if (path) opened_ = open_job(*path, diagnostics);
  if (!opened_) return "its scene cannot be read:\n" + diagnostics.to_text();
  const transport::Fingerprint& own = opened_->fingerprint;
  if (own.program != info.fingerprint.program) {
    return fmt::format("it needs the build {} of bpt {}, and this is the build {}",
                       short_name(info.fingerprint.program), info.version, short_name(own.program));
  }
  if (own != info.fingerprint) return "its scene or its options differ from what its description says";
  const auto probe = renders_->run_probe(*opened_, info.probe);
  if (!probe) return "";
  if (transport::digest_of(*probe) != info.probe_digest) {
    return fmt::format(
        "this machine computes other samples: the probe has the digest {} instead of {} (bpt {}, {})",
        short_name(transport::digest_of(*probe)), short_name(info.probe_digest), settings_.version,
        InstructionSet);
  }
  loaded_ = info.id;
  say_(fmt::format("joined {} ({})", info.id, info.name));
  return "";
}

/// Renders tasks, one per thread at a time, until none waits.
void Worker::work_on_tasks(const JobInfo& info) {
  constexpr milliseconds Wait{500};
  const auto work = [&] {
    const auto tasks = farm_.tasks(info.id);
    while (tasks && !is_stopped_ && !job_has_ended_) {
      const auto messages = tasks->fetch(1, Wait);
      if (messages.empty() && is_idle()) return;
      if (messages.empty()) continue;
      const auto task = task_of(messages.front().data());
      if (!task || task->end_tile() > tile_count_of(opened_->job->settings)) {
        messages.front().acknowledge();  // nobody could read it
      } else if (!render(info, messages.front(), *task)) {
        return;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < settings_.threads; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
}

bool Worker::is_idle() {
  const std::lock_guard lock(lock_);
  return in_work_.empty();
}

/// Renders a task and sends its part; false if it was stopped.
bool Worker::render(const JobInfo& info, const Message& message, const Task& task) {
  {
    const std::lock_guard lock(lock_);
    in_work_.push_back(&message);
  }
  const auto part = renders_->run(*opened_, task);
  bool is_sent = false;
  if (part) {
    const std::string bytes = transport::bytes_of(*part);
    if (bytes.size() > farm_.largest_message()) job_has_ended_ = true;  // no coordinator asks for that
    // A server that is away, or full, takes it later.
    while (!is_stopped_ && !job_has_ended_ && !is_sent) {
      is_sent = farm_.put_result(info.id, {info_.id, task.number, bytes});
      if (!is_sent) std::this_thread::sleep_for(Pause);
    }
  }
  {
    const std::lock_guard lock(lock_);
    in_work_.remove(&message);
  }
  if (is_sent) message.acknowledge();
  if (!is_sent) message.give_back();
  return is_sent;
}

}  // namespace farm
