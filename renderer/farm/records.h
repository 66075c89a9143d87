// The coordinator of a job and the workers of a farm exchange these records as JSON. What comes from the
// network is checked when it is read: numbers have ranges, and names that could become parts of paths are
// identifiers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/transport/checkpoint_frame.h"
#include "renderer/transport/image_part.h"

namespace farm {

/// The largest job file that a worker fetches, in bytes.
inline constexpr std::uint64_t LargestJob = std::uint64_t{1} << 34U;

/// The instructions that samples are computed with, by bpt and Embree alike.
inline constexpr std::string_view InstructionSet = "x86-64-v3";

/// A job: an image that is being rendered. Its number of parts is that of the coordinator's ledger.
struct JobInfo {
  std::string id;
  std::string name;                ///< of the scene's file, for people
  std::string host;                ///< where the coordinator runs
  std::int64_t created = 0;        ///< seconds since 1970
  transport::Digest content = {};  ///< of the job file
  std::uint64_t bytes = 0;         ///< of the job file
  std::string version;             ///< of bpt
  std::string instruction_set;
  transport::Fingerprint fingerprint;   ///< of the image
  transport::ImagePart probe;           ///< the samples that a worker has to compute
  transport::Digest probe_digest = {};  ///< of these samples
  double lease_seconds = 0;
};

/// Samples of a job that are to be rendered together.
struct Task {
  int number = 0;
  int first_tile = 0;                           ///< in the order of Film
  std::vector<transport::TileSamples> samples;  ///< of this tile and of those that follow it; not empty
  bool is_pilot = false;                        ///< whether they are the pilot of an adaptive image

  /// The number of the tile after the last one.
  int end_tile() const { return first_tile + static_cast<int>(samples.size()); }
  /// Returns its samples of each tile of an image that has so many, and all of its own.
  std::vector<transport::TileSamples> samples_by_tile(std::size_t tiles) const;
};

/// The tasks of a stage of a job, which its ledger has.
struct StageTasks {
  int end = 0;          ///< as in Stage
  int image_begin = 0;  ///< the number of the first task whose samples are those of the image
  std::vector<Task> tasks;
};

/// How far a job is.
struct Progress {
  int parts = 0;
  int parts_done = 0;
  int workers = 0;
  std::optional<double> error;         ///< empty while unknown
  std::optional<double> seconds_left;  ///< empty while unknown
  std::int64_t time = 0;               ///< seconds since 1970
};

/// A worker that is there.
struct WorkerInfo {
  std::string id;
  std::string host;
  int threads = 0;
  std::string version;
  std::string job;      ///< empty: none
  std::string refused;  ///< why it does not work for the latest job that it refused; empty: none
};

/// Returns the name of this machine.
std::string host_name();

/// Returns a new identifier: 16 random hexadecimal digits.
std::string new_identifier();
bool is_identifier(std::string_view text);

// Each record is written as JSON, and read from it; empty if it is no such record.

std::string json_of(const JobInfo& job);
std::optional<JobInfo> job_info_of(std::string_view json);
std::string json_of(const Task& task);
std::optional<Task> task_of(std::string_view json);
std::string json_of(const StageTasks& stage);
std::optional<StageTasks> stage_tasks_of(std::string_view json);
std::string json_of(const Progress& progress);
std::optional<Progress> progress_of(std::string_view json);
std::string json_of(const WorkerInfo& worker);
std::optional<WorkerInfo> worker_info_of(std::string_view json);

}  // namespace farm
