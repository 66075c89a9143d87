// The coordinator of a job gives out its tasks, and merges what workers bring.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/farm/division.h"
#include "renderer/farm/farm.h"
#include "renderer/farm/ledger.h"
#include "renderer/farm/opened_job.h"
#include "renderer/transport/part_merge.h"

namespace farm {

struct CoordinatorSettings {
  std::string name;           ///< of the scene, for people
  std::string version;        ///< of bpt
  std::string ledger;         ///< path
  double part_seconds = 2;    ///< of one thread, which a part takes about
  double lease_seconds = 20;  ///< after which a part is given to another worker, if its own is silent
};

/// Renders a job on a farm, stage by stage. The ledger is the truth: it has each part that was merged. The
/// farm's queue only says who works on what; a part that lacks is given again, and any valid part is taken
/// whoever brings it.
class Coordinator {
 public:
  /// All must outlive the coordinator.
  Coordinator(const Farm& farm, const OpenedJob& job, const CoordinatorSettings& settings);

  /// Measures the cost of samples, or reads the ledger of the job if that exists, and puts the job and what
  /// lacks of it on the farm. An error if the ledger is that of another image, or the farm takes nothing.
  bool submit(std::string_view job_file, grf::Diagnostics& diagnostics);

  /// Runs until the image is complete or `stop`, and calls `show` several times a second. An error if the
  /// ledger cannot be written, or if the job was stopped by somebody else.
  bool run(const std::function<void(const Progress&)>& show, grf::Diagnostics& diagnostics);

  /// Makes `run` return soon. Safe to call from another thread.
  void stop();

  bool is_complete() const { return is_complete_; }
  /// The sum of the parts.
  const transport::PartMerge& merge() const { return merge_; }
  const JobInfo& info() const { return info_; }
  /// Warnings since the last call, such as that a worker was dropped.
  std::vector<std::string> take_warnings() { return std::exchange(warnings_, {}); }

  /// Removes the job from the farm, and its ledger, after the image was written.
  void finish();

 private:
  /// A task whose part was merged.
  struct Done {
    transport::Digest digest = {};
    std::string worker;
  };
  using Clock = std::chrono::steady_clock;

  bool measure(grf::Diagnostics& diagnostics);
  bool open_ledger(grf::Diagnostics& diagnostics);
  bool take_line(std::string_view record, grf::Diagnostics& diagnostics);
  bool was_written(bool is_written, grf::Diagnostics& diagnostics) const;
  bool begin_ledger(grf::Diagnostics& diagnostics);
  bool rebuild(grf::Diagnostics& diagnostics);
  void take_stage(StageTasks stage);
  bool is_stage_done() const;
  bool lacks_earlier_stage() const;
  void start_over();
  bool advance(grf::Diagnostics& diagnostics);
  bool advance_on_farm(grf::Diagnostics& diagnostics);
  std::vector<Task> missing() const;
  bool put_on_farm();
  bool take(const Result& result, grf::Diagnostics& diagnostics);
  std::string defect_of(const transport::SamplePart& part, const Task& task) const;
  bool take_repeated(const Result& result, const transport::Digest& digest, grf::Diagnostics& diagnostics);
  bool drop(const std::string& worker, const std::string& why, grf::Diagnostics& diagnostics);
  bool check_farm(grf::Diagnostics& diagnostics);
  void give_again(const QueueState& state);
  void update_progress();

  const Farm& farm_;
  const OpenedJob& job_;
  CoordinatorSettings settings_;
  JobInfo info_;
  std::string_view job_file_;
  double seconds_per_sample_ = 0;
  std::vector<Task> tasks_;  ///< of all stages, by number
  int image_begin_ = 0;      ///< the first task whose samples are in the image: earlier stages were replaced
  int stage_begin_ = 0;      ///< the first task of the latest stage
  int stage_end_ = 0;        ///< as in Stage; 0 before the first one
  bool is_complete_ = false;
  std::map<int, Done> done_;  ///< by task, from `image_begin_` on
  std::set<std::string> dropped_;
  std::optional<Ledger> ledger_;
  transport::PartMerge merge_;
  RunningRenders renders_;
  std::atomic<bool> is_stopped_ = false;
  std::vector<std::string> warnings_;

  Progress progress_;
  std::size_t done_before_ = 0;  ///< when `run` began
  Clock::time_point start_;
  Clock::time_point next_check_;
  Clock::time_point next_count_;
  Clock::time_point next_estimate_;
  Clock::time_point last_given_;  ///< when tasks were put on the farm, or nothing waited there any more
  double retry_seconds_ = 0;      ///< seconds until what is late is given again
};

}  // namespace farm
