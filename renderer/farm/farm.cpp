#include "renderer/farm/farm.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace farm {
namespace {

using transport::Digest;

constexpr const char* Contents = "granada_contents";
constexpr const char* Jobs = "granada_jobs";
constexpr const char* Tasks = "granada_tasks";
constexpr const char* Results = "granada_results";
constexpr const char* Workers = "granada_workers";

/// Contents travel in pieces, which any server takes: its limit is 1 MB unless it is configured otherwise.
constexpr std::size_t ChunkBytes = std::size_t{1} << 19U;
constexpr std::chrono::seconds WorkerAge{6};
constexpr std::chrono::seconds ResultLease{60};

std::string chunk_subject(const Digest& digest, std::size_t chunk) {
  return fmt::format("granada.content.{}.{}", transport::hex(digest), chunk);
}
std::string job_subject(std::string_view id) { return fmt::format("granada.job.{}", id); }
std::string progress_subject(std::string_view id) { return fmt::format("granada.job.{}.progress", id); }
std::string dropped_subject(std::string_view job, std::string_view worker) {
  return fmt::format("granada.job.{}.dropped.{}", job, worker);
}
std::string stopped_subject(std::string_view job) { return fmt::format("granada.job.{}.stopped", job); }
std::string task_subject(std::string_view job) { return fmt::format("granada.task.{}", job); }
std::string result_subject(std::string_view job) { return fmt::format("granada.result.{}", job); }
std::string worker_subject(std::string_view id) { return fmt::format("granada.worker.{}", id); }

/// Reads the last messages of subjects.
template <class Read>
auto records_of(const Connection& connection, const char* stream, const std::string& subjects,
                const Read& read) -> std::optional<std::vector<typename decltype(read(""))::value_type>> {
  const auto found = connection.subjects(stream, subjects);
  if (!found) return std::nullopt;
  std::vector<typename decltype(read(""))::value_type> records;
  for (const std::string& subject : *found) {
    const auto message = connection.last_message(stream, subject);
    auto record = message ? read(*message) : std::nullopt;
    if (record) records.push_back(std::move(*record));
  }
  return records;
}

}  // namespace

std::optional<Farm> Farm::join(const Access& access, const std::string& name, std::string& problem) {
  auto connection = Connection::open(access, name, problem);
  if (!connection) return std::nullopt;
  Farm farm(std::move(*connection));
  if (farm.add_streams()) return farm;
  problem = fmt::format("the server at {} keeps no streams: it runs without JetStream, or its disk is full",
                        access.url);
  return std::nullopt;
}

bool Farm::add_streams() const {
  const std::array<StreamSettings, 5> streams = {
      StreamSettings{.name = Contents, .subjects = "granada.content.>"},
      StreamSettings{.name = Jobs, .subjects = "granada.job.>"},
      StreamSettings{.name = Tasks, .subjects = "granada.task.*", .is_queue = true},
      StreamSettings{.name = Results, .subjects = "granada.result.>", .is_queue = true},
      StreamSettings{
          .name = Workers, .subjects = "granada.worker.*", .is_in_memory = true, .age = WorkerAge}};
  return std::ranges::all_of(streams,
                             [&](const StreamSettings& stream) { return connection_.add_stream(stream); });
}

bool Farm::put_content(const Digest& digest, std::string_view bytes) const {
  const auto there =
      connection_.subjects(Contents, fmt::format("granada.content.{}.*", transport::hex(digest)));
  if (!there) return false;
  for (std::size_t chunk = 0; chunk * ChunkBytes < bytes.size(); ++chunk) {
    const std::string subject = chunk_subject(digest, chunk);
    if (std::ranges::find(*there, subject) != there->end()) continue;
    if (!connection_.publish(subject, bytes.substr(chunk * ChunkBytes, ChunkBytes))) return false;
  }
  return true;
}

std::optional<std::string> Farm::content(const Digest& digest, std::uint64_t bytes) const {
  std::string content;
  for (std::size_t chunk = 0; content.size() < bytes; ++chunk) {
    const auto piece = connection_.last_message(Contents, chunk_subject(digest, chunk));
    if (!piece || piece->empty() || piece->size() > ChunkBytes) return std::nullopt;
    content += *piece;
  }
  return transport::digest_of(content) == digest ? std::optional(std::move(content)) : std::nullopt;
}

bool Farm::put_job(const JobInfo& job) const {
  const auto lease = std::chrono::milliseconds(static_cast<std::int64_t>(1000 * job.lease_seconds));
  return connection_.add_queue(Tasks, job.id, task_subject(job.id), lease) &&
         connection_.add_queue(Results, job.id, result_subject(job.id) + ".>", ResultLease) &&
         connection_.publish(job_subject(job.id), json_of(job));
}

std::optional<std::vector<JobInfo>> Farm::jobs() const {
  auto jobs = records_of(connection_, Jobs, job_subject("*"), job_info_of);
  if (jobs) {
    std::ranges::sort(*jobs, [](const JobInfo& a, const JobInfo& b) {
      return std::pair(a.created, a.id) < std::pair(b.created, b.id);
    });
  }
  return jobs;
}

std::optional<bool> Farm::has_job(const std::string& id) const {
  const auto found = connection_.subjects(Jobs, job_subject(id));
  return found ? std::optional(!found->empty()) : std::nullopt;
}

bool Farm::remove_job(const JobInfo& job) const {
  // The job goes first: whoever sees it finds all of it.
  if (!connection_.purge(Jobs, job_subject(job.id)) || !connection_.purge(Jobs, job_subject(job.id) + ".>")) {
    return false;
  }
  connection_.remove_queue(Tasks, job.id);
  connection_.remove_queue(Results, job.id);
  bool is_done = connection_.purge(Tasks, task_subject(job.id));
  is_done &= connection_.purge(Results, result_subject(job.id) + ".>");
  const auto others = jobs();
  const bool is_needed = !others || std::ranges::any_of(*others, [&](const JobInfo& other) {
    return other.content == job.content;
  });
  return is_done && (is_needed || connection_.purge(Contents, fmt::format("granada.content.{}.*",
                                                                          transport::hex(job.content))));
}

bool Farm::stop_job(const JobInfo& job) const {
  return remove_job(job) && connection_.publish(stopped_subject(job.id), "stopped");
}

bool Farm::was_stopped(const std::string& id) const {
  const bool is_stopped = connection_.last_message(Jobs, stopped_subject(id)).has_value();
  if (is_stopped) connection_.purge(Jobs, stopped_subject(id));
  return is_stopped;
}

bool Farm::put_progress(const std::string& job, const Progress& progress) const {
  return connection_.publish(progress_subject(job), json_of(progress));
}

std::optional<Progress> Farm::progress(const std::string& job) const {
  const auto message = connection_.last_message(Jobs, progress_subject(job));
  return message ? progress_of(*message) : std::nullopt;
}

bool Farm::put_tasks(const std::string& job, const std::vector<Task>& tasks) const {
  std::vector<std::string> messages;
  messages.reserve(tasks.size());
  for (const Task& task : tasks) messages.push_back(json_of(task));
  return connection_.publish(task_subject(job), messages);
}

bool Farm::clear_tasks(const std::string& job) const { return connection_.purge(Tasks, task_subject(job)); }

std::optional<QueueState> Farm::task_state(const std::string& job) const {
  return connection_.queue_state(Tasks, job);
}

std::optional<Subscription> Farm::tasks(const std::string& job) const {
  return connection_.subscribe(Tasks, job, task_subject(job));
}

bool Farm::put_result(const std::string& job, const Result& result) const {
  return connection_.publish(fmt::format("{}.{}.{}", result_subject(job), result.worker, result.task),
                             result.bytes);
}

std::optional<Subscription> Farm::results(const std::string& job) const {
  return connection_.subscribe(Results, job, result_subject(job) + ".>");
}

std::optional<Result> Farm::result_of(const Message& message) {
  // granada.result.JOB.WORKER.TASK
  const std::string_view subject = message.subject();
  const std::size_t last = subject.rfind('.');
  const std::size_t before = subject.rfind('.', last - 1);
  if (last == std::string_view::npos || before == std::string_view::npos) return std::nullopt;
  Result result{std::string(subject.substr(before + 1, last - before - 1)), 0, message.data()};
  const std::string_view digits = subject.substr(last + 1);
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), result.task);
  const bool is_number = problem == std::errc() && end == digits.data() + digits.size() && result.task >= 0;
  return is_number && is_identifier(result.worker) ? std::optional(std::move(result)) : std::nullopt;
}

bool Farm::put_worker(const WorkerInfo& worker) const {
  return connection_.publish(worker_subject(worker.id), json_of(worker));
}

std::optional<std::vector<WorkerInfo>> Farm::workers() const {
  return records_of(connection_, Workers, worker_subject("*"), worker_info_of);
}

bool Farm::drop_worker(const std::string& job, const std::string& worker, std::string_view why) const {
  return connection_.publish(dropped_subject(job, worker), why);
}

std::optional<std::string> Farm::why_dropped(const std::string& job, const std::string& worker) const {
  return connection_.last_message(Jobs, dropped_subject(job, worker));
}

}  // namespace farm
