// The farm: what its coordinators and workers share on the server. All of it can be lost and made again: the
// truth about a job is its coordinator's ledger.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/farm/nats_client.h"
#include "renderer/farm/records.h"

namespace farm {

/// The result of a task, as a worker sent it; `bytes` points into the message.
struct Result {
  std::string worker;
  int task = 0;
  std::string_view bytes;
};

class Farm {
 public:
  /// Connects, and makes sure that the farm's streams exist. Empty, with the reason in `problem`, if not.
  static std::optional<Farm> join(const Access& access, const std::string& name, std::string& problem);

  bool is_closed() const { return connection_.is_closed(); }
  std::size_t largest_message() const { return connection_.largest_message(); }
  /// Makes sure that the farm's streams exist, which a server that lost its folder has not.
  bool add_streams() const;

  // Job files, by the digest of their contents.

  bool put_content(const transport::Digest& digest, std::string_view bytes) const;
  /// Returns the bytes with this digest, of which there must be so many; empty if they are not there.
  std::optional<std::string> content(const transport::Digest& digest, std::uint64_t bytes) const;

  // Jobs. The content of a job is put before it.

  bool put_job(const JobInfo& job) const;
  /// Returns all jobs, the oldest first; empty if the server does not answer.
  std::optional<std::vector<JobInfo>> jobs() const;
  /// Returns whether a job is there; empty if the server does not answer.
  std::optional<bool> has_job(const std::string& id) const;
  /// Removes a job with its tasks and results, and its content unless another job has it too.
  bool remove_job(const JobInfo& job) const;
  /// Removes a job likewise, and tells its coordinator.
  bool stop_job(const JobInfo& job) const;
  /// Returns whether a job was stopped; only once.
  bool was_stopped(const std::string& id) const;
  bool put_progress(const std::string& job, const Progress& progress) const;
  std::optional<Progress> progress(const std::string& job) const;

  // Tasks: of several workers, one gets each of them.

  bool put_tasks(const std::string& job, const std::vector<Task>& tasks) const;
  bool clear_tasks(const std::string& job) const;
  std::optional<QueueState> task_state(const std::string& job) const;
  std::optional<Subscription> tasks(const std::string& job) const;

  // Results.

  bool put_result(const std::string& job, const Result& result) const;
  std::optional<Subscription> results(const std::string& job) const;
  /// Reads a message of results; empty if it is none.
  static std::optional<Result> result_of(const Message& message);

  // Workers.

  /// Says that a worker is there, for some seconds.
  bool put_worker(const WorkerInfo& worker) const;
  std::optional<std::vector<WorkerInfo>> workers() const;
  /// Tells a worker that a job takes nothing from it any more, and why.
  bool drop_worker(const std::string& job, const std::string& worker, std::string_view why) const;
  std::optional<std::string> why_dropped(const std::string& job, const std::string& worker) const;

 private:
  explicit Farm(Connection connection) : connection_(std::move(connection)) {}

  Connection connection_;
};

}  // namespace farm
