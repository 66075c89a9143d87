// A worker renders parts of the jobs of a farm.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/farm/farm.h"
#include "renderer/farm/job_cache.h"
#include "renderer/farm/opened_job.h"

namespace farm {

struct WorkerSettings {
  int threads = 0;      ///< 0: one per core
  std::string version;  ///< of bpt
  std::string cache_folder;
  std::uint64_t cache_bytes = std::uint64_t{10} << 30U;
};

/// Takes tasks of one job after another, those of the oldest first. Before the first task of a job it renders
/// the probe, and refuses the job if that differs.
///
/// It runs nothing that comes from the network but renders, and reads no file outside of the job's folder.
class Worker {
 public:
  /// `say` is called with what happens, as lines for people. All must outlive the worker.
  Worker(const Farm& farm, WorkerSettings settings, std::function<void(const std::string&)> say);

  /// Works until `stop`, or until the server refuses the connection: then returns false.
  bool run();

  /// Makes `run` return soon; tasks in work return to their queue. Safe to call from another thread.
  void stop();

 private:
  void run_heartbeat();
  std::optional<JobInfo> next_job();
  std::string work_for(const JobInfo& info);
  std::string load(const JobInfo& info);
  bool is_idle();
  void work_on_tasks(const JobInfo& info);
  bool render(const JobInfo& info, const Message& message, const Task& task);

  const Farm& farm_;
  WorkerSettings settings_;
  std::function<void(const std::string&)> say_;
  JobCache cache_;
  std::map<std::string, std::string> refused_;  ///< jobs that it does not work for, and why
  std::string loaded_;                          ///< the job that `opened_` is
  std::unique_ptr<OpenedJob> opened_;
  std::unique_ptr<RunningRenders> renders_;

  std::atomic<bool> is_stopped_ = false;
  std::atomic<bool> job_has_ended_ = false;
  std::mutex lock_;  ///< guards the members below
  WorkerInfo info_;
  std::chrono::milliseconds extension_interval_{1000};
  std::list<const Message*> in_work_;
};

}  // namespace farm
