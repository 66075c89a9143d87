#include "renderer/farm/coordinator.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <iterator>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace farm {
namespace {

using grf::Diagnostics;
using std::chrono::milliseconds;
using transport::ImagePart;
using transport::SamplePart;

constexpr std::chrono::seconds CheckInterval{1};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The processor time of this thread, in seconds: that of a part on one thread, whatever else the machine
/// does.
double thread_seconds() {
  timespec time = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Returns when to do again what took this time, so that it takes 1/20 of the time at most.
std::chrono::steady_clock::time_point later_by(std::chrono::steady_clock::duration time) {
  return std::chrono::steady_clock::now() +
         std::max<std::chrono::steady_clock::duration>(CheckInterval, 20 * time);
}

/// Returns a part with a few samples all over the image: `samples` of about this many halves of tiles.
ImagePart spread_part(int tiles, int samples) {
  constexpr int HalvesWanted = 32;
  const int count = std::max(1, static_cast<int>(transport::FilmTile::Scramblings) * tiles / HalvesWanted);
  ImagePart part;
  part.end_sample = samples;
  part.count = count;
  return part;
}

/// A record of the ledger that has a part: a line of JSON, and the bytes of the part.
std::string record_of(int task, std::string_view worker, std::string_view bytes) {
  return fmt::format("{{\"task\":{},\"worker\":\"{}\"}}\n", task, worker).append(bytes);
}

bool is_part(std::string_view record) { return record.starts_with("{\"task\":"); }

}  // namespace

Coordinator::Coordinator(const Farm& farm, const OpenedJob& job, const CoordinatorSettings& settings)
    : farm_(farm), job_(job), settings_(settings) {
  info_.id = new_identifier();
  info_.name = settings.name;
  info_.host = host_name();
  info_.created = std::time(nullptr);
  info_.version = settings.version;
  info_.instruction_set = InstructionSet;
  info_.fingerprint = job.fingerprint;
  info_.lease_seconds = settings.lease_seconds;
}

void Coordinator::stop() {
  is_stopped_ = true;
  renders_.stop();
}

bool Coordinator::submit(std::string_view job_file, Diagnostics& diagnostics) {
  job_file_ = job_file;
  info_.content = transport::digest_of(job_file);
  info_.bytes = job_file.size();
  if (info_.bytes > LargestJob) {
    diagnostics.error({}, "the job file is too large for a farm");
    return false;
  }
  if (!measure(diagnostics) || !open_ledger(diagnostics)) return false;
  if (is_complete() || put_on_farm()) return true;
  diagnostics.error({}, "the farm's server takes no job: it does not answer, or its disk is full");
  return false;
}

/// Renders the probe, and measures the time that samples take.
bool Coordinator::measure(Diagnostics& diagnostics) {
  constexpr double Enough = 0.2;
  const transport::RenderSettings& settings = job_.job->settings;
  const int tiles = tile_count_of(settings);
  for (int samples = std::min(2, settings.samples);; samples = std::min(4 * samples, settings.samples)) {
    const ImagePart part = spread_part(tiles, samples);
    const double start = thread_seconds();
    const auto rendered = renders_.run_probe(job_, part);
    if (!rendered) return false;  // stopped
    const double seconds = thread_seconds() - start;
    info_.probe = part;
    info_.probe_digest = transport::digest_of(*rendered);
    const double paths = std::max<double>(1, static_cast<double>(rendered->totals.paths));
    seconds_per_sample_ = seconds / paths;
    if (seconds >= Enough || samples == settings.samples) break;
  }
  if (tile_bytes(tiles) <= farm_.largest_message()) return true;
  diagnostics.error({}, "the image is too large for the messages of the farm's server");
  return false;
}

bool Coordinator::open_ledger(Diagnostics& diagnostics) {
  bool has_records = false;
  const auto take = [&](std::string_view record) {
    has_records = true;
    return is_part(record) || take_line(record, diagnostics);
  };
  ledger_ = Ledger::open(settings_.ledger, take, diagnostics);
  if (!ledger_ || !(has_records ? rebuild(diagnostics) : begin_ledger(diagnostics))) return false;
  if (lacks_earlier_stage()) start_over();
  return advance(diagnostics);
}

/// Writes what the job is: another run of the coordinator goes on with its identifier.
bool Coordinator::begin_ledger(Diagnostics& diagnostics) {
  const nlohmann::json start = {{"job", info_.id},
                                {"created", info_.created},
                                {"content", transport::hex(info_.content)},
                                {"program", transport::hex(info_.fingerprint.program)}};
  return was_written(ledger_->append(start.dump()) && ledger_->sync(), diagnostics);
}

/// Returns whether the ledger was written, after an error if not.
bool Coordinator::was_written(bool is_written, Diagnostics& diagnostics) const {
  if (!is_written) diagnostics.error(grf::whole_file(ledger_->path()), "cannot write the ledger");
  return is_written;
}

/// Takes a record of the ledger that is no part: its beginning, a stage, or that a worker was dropped. The
/// file is our own, and has check sums: what does not fit is of another image.
bool Coordinator::take_line(std::string_view record, Diagnostics& diagnostics) try {
  const auto fail = [&](std::string_view why) {
    diagnostics.error(
        grf::whole_file(settings_.ledger),
        fmt::format("the ledger belongs to {}; remove it, or name another output, to start over", why));
    return false;
  };
  if (auto stage = stage_tasks_of(record)) {
    take_stage(std::move(*stage));
    return true;
  }
  const auto line = nlohmann::json::parse(record);
  if (line.contains("dropped")) {
    dropped_.insert(line.at("dropped").get<std::string>());
    return true;
  }
  if (line.at("content") != transport::hex(info_.content)) return fail("another scene, or other options");
  if (line.at("program") != transport::hex(info_.fingerprint.program)) return fail("another build of bpt");
  info_.id = line.at("job");
  info_.created = line.at("created");
  return true;
} catch (const nlohmann::json::exception&) {
  diagnostics.error(grf::whole_file(settings_.ledger), "it is no ledger of this version of bpt");
  return false;
}

/// Adds up the parts of the ledger, without those of workers that were dropped.
bool Coordinator::rebuild(Diagnostics& diagnostics) {
  merge_ = {};
  done_.clear();
  return ledger_->read([&](std::string_view record) {
    if (!is_part(record)) return true;
    const std::size_t end = record.find('\n');
    const auto line = nlohmann::json::parse(record.substr(0, end));
    const std::string worker = line.at("worker");
    const int task = line.at("task");
    if (task < image_begin_ || dropped_.contains(worker)) return true;
    auto part = transport::parse_part(std::string(record.substr(end + 1)), settings_.ledger, diagnostics);
    if (!part) return false;
    done_[task] = {transport::digest_of(*part), worker};
    return merge_.add(std::move(*part), settings_.ledger, diagnostics);
  });
}

void Coordinator::take_stage(StageTasks stage) {
  stage_begin_ = static_cast<int>(tasks_.size());
  stage_end_ = stage.end;
  if (stage.image_begin == stage_begin_) {
    merge_ = {};
    done_.clear();
  }
  image_begin_ = stage.image_begin;
  std::ranges::move(stage.tasks, std::back_inserter(tasks_));
}

bool Coordinator::is_stage_done() const {
  return done_.size() + static_cast<std::size_t>(image_begin_) == tasks_.size();
}

/// Returns whether an earlier stage lacks parts: those of a worker that was dropped. What followed from them
/// was wrong.
bool Coordinator::lacks_earlier_stage() const {
  return std::distance(done_.begin(), done_.lower_bound(stage_begin_)) < stage_begin_ - image_begin_;
}

void Coordinator::start_over() {
  image_begin_ = stage_begin_ = static_cast<int>(tasks_.size());
  stage_end_ = 0;
  merge_ = {};
  done_.clear();
}

/// Begins the next stage if the parts of this one are merged. False only if that failed.
bool Coordinator::advance(Diagnostics& diagnostics) {
  if (is_complete_ || !is_stage_done()) return true;
  constexpr std::size_t MostTasks = 1'000'000;
  std::optional<transport::Film> film;
  if (stage_end_ > 0) film = merge_.film();
  const auto stage = next_stage(job_.job->settings, stage_end_, film ? &*film : nullptr);
  is_complete_ = !stage;
  if (is_complete_) return true;
  const auto number = static_cast<int>(tasks_.size());
  const TaskLimits limits{settings_.part_seconds, farm_.largest_message() * 9 / 10};
  StageTasks tasks{stage->end, stage->starts_over ? number : image_begin_,
                   divide(*stage, number, seconds_per_sample_, limits)};
  if (tasks_.size() + tasks.tasks.size() > MostTasks) {
    diagnostics.error({}, fmt::format("the image has {} parts, more than a farm can hold: make them longer "
                                      "(--part-seconds)",
                                      tasks.tasks.size()));
    return false;
  }
  if (!was_written(ledger_->append(json_of(tasks)) && ledger_->sync(), diagnostics)) return false;
  take_stage(std::move(tasks));
  return true;
}

/// Advances, and gives the tasks of the next stage to workers. False only if that failed in the ledger.
bool Coordinator::advance_on_farm(Diagnostics& diagnostics) {
  const std::size_t before = tasks_.size();
  if (!advance(diagnostics)) return false;
  if (tasks_.size() == before) return true;
  farm_.clear_tasks(info_.id);  // of what was given twice, or starts over
  farm_.put_tasks(info_.id, missing());
  last_given_ = Clock::now();
  return true;
}

std::vector<Task> Coordinator::missing() const {
  std::vector<Task> tasks;
  for (auto number = static_cast<std::size_t>(image_begin_); number < tasks_.size(); ++number) {
    if (!done_.contains(static_cast<int>(number))) tasks.push_back(tasks_[number]);
  }
  return tasks;
}

bool Coordinator::put_on_farm() {
  last_given_ = Clock::now();
  return farm_.add_streams() && farm_.put_content(info_.content, job_file_) && farm_.put_job(info_) &&
         farm_.clear_tasks(info_.id) && farm_.put_tasks(info_.id, missing());
}

bool Coordinator::run(const std::function<void(const Progress&)>& show, Diagnostics& diagnostics) {
  constexpr int MostAtOnce = 64;
  constexpr milliseconds Wait{100};
  start_ = Clock::now();
  done_before_ = done_.size();
  std::optional<Subscription> results;
  while (!is_complete() && !is_stopped_) {
    if (!results) results = farm_.results(info_.id);
    const auto messages = results ? results->fetch(MostAtOnce, Wait) : std::vector<Message>();
    if (!results) std::this_thread::sleep_for(Wait);
    for (const Message& message : messages) {
      const auto result = Farm::result_of(message);
      if (result && !take(*result, diagnostics)) return false;
    }
    if (!messages.empty() && !was_written(ledger_->sync(), diagnostics)) return false;
    for (const Message& message : messages) message.acknowledge();
    if (!advance_on_farm(diagnostics)) return false;
    if (Clock::now() >= next_check_) {
      if (!check_farm(diagnostics)) return false;
      next_check_ = Clock::now() + CheckInterval;
    }
    progress_.parts = static_cast<int>(tasks_.size()) - image_begin_;
    progress_.parts_done = static_cast<int>(done_.size());
    show(progress_);
  }
  return true;
}

/// Returns why a part is not what was asked for; empty if it is.
std::string Coordinator::defect_of(const SamplePart& part, const Task& task) const {
  const transport::RenderSettings& settings = job_.job->settings;
  if (part.fingerprint != info_.fingerprint) return "it is of another image";
  if (std::cmp_not_equal(part.width, settings.width) || std::cmp_not_equal(part.height, settings.height) ||
      std::cmp_not_equal(part.image_samples, settings.samples) ||
      (part.is_adaptive != 0) != settings.is_adaptive()) {
    return "it has another size";
  }
  const auto wanted = task.samples_by_tile(part.tiles.size());
  for (std::size_t tile = 0; tile < part.tiles.size(); ++tile) {
    for (std::size_t half = 0; half < wanted[tile].first.size(); ++half) {
      transport::SampleIntervals samples;
      const transport::SampleInterval own{wanted[tile].first[half], wanted[tile].end[half]};
      if (own.end > own.first) samples = {own};
      if (part.tiles[tile].samples[half] != samples) return "it has other samples";
      const double spread = part.tiles[tile].spreads[half];
      if (task.is_pilot ? !(spread >= 0) : spread != 0) return "its pilot is impossible";
    }
  }
  const bool has_time = part.totals.seconds >= 0 && part.totals.seconds < 1e9;  // false for NaN
  return has_time && part.description.empty() ? "" : "its totals are impossible";
}

/// Takes a part that a worker brought. False only if the ledger failed.
bool Coordinator::take(const Result& result, Diagnostics& diagnostics) {
  const bool is_replaced = result.task < image_begin_;  // with its stage
  if (is_replaced || dropped_.contains(result.worker)) return true;
  Diagnostics of_part;
  auto part = transport::parse_part(std::string(result.bytes), "part", of_part);
  const bool is_task = std::cmp_less(result.task, tasks_.size());
  std::string defect = "it is no part file, or is damaged";
  if (part && is_task) defect = defect_of(*part, tasks_[static_cast<std::size_t>(result.task)]);
  if (!defect.empty()) return drop(result.worker, fmt::format("of a part, {}", defect), diagnostics);
  const transport::Digest digest = transport::digest_of(*part);
  if (done_.contains(result.task)) return take_repeated(result, digest, diagnostics);
  const std::string record = record_of(result.task, result.worker, result.bytes);
  if (!was_written(ledger_->append(record), diagnostics)) return false;
  done_[result.task] = {digest, result.worker};
  last_given_ = Clock::now();
  return merge_.add(std::move(*part), settings_.ledger, diagnostics);
}

/// Takes a part that was merged already. If it has other values, the coordinator renders it, and drops
/// whoever was wrong.
bool Coordinator::take_repeated(const Result& result, const transport::Digest& digest,
                                Diagnostics& diagnostics) {
  const Done earlier = done_.at(result.task);
  if (earlier.digest == digest) return true;
  const auto own = renders_.run(job_, tasks_[static_cast<std::size_t>(result.task)]);
  if (!own) return true;  // stopped
  const std::string why = "a part has other values than those that are right";
  if (transport::digest_of(*own) != digest && !drop(result.worker, why, diagnostics)) return false;
  if (transport::digest_of(*own) == earlier.digest) return true;
  return drop(earlier.worker, why, diagnostics);
}

/// Takes nothing more from a worker, and does its parts again.
bool Coordinator::drop(const std::string& worker, const std::string& why, Diagnostics& diagnostics) {
  if (!dropped_.insert(worker).second) return true;
  warnings_.push_back(fmt::format("worker {} was dropped: {}", worker, why));
  farm_.drop_worker(info_.id, worker, why);
  const nlohmann::json record = {{"dropped", worker}};
  if (!was_written(ledger_->append(record.dump()), diagnostics)) return false;
  std::vector<Task> again;
  for (const auto& [task, done] : done_) {
    if (done.worker == worker) again.push_back(tasks_[static_cast<std::size_t>(task)]);
  }
  if (!again.empty() && !rebuild(diagnostics)) return false;
  if (lacks_earlier_stage()) {
    start_over();
    return true;
  }
  farm_.put_tasks(info_.id, again);
  return true;
}

/// Looks after the queue. False if the job was stopped by somebody else, or the server refuses the
/// coordinator.
bool Coordinator::check_farm(Diagnostics& diagnostics) {
  if (farm_.is_closed()) {
    diagnostics.error({}, "the server refuses the connection; the same command resumes the work");
    return false;
  }
  if (farm_.was_stopped(info_.id)) {
    diagnostics.error({}, "the job was stopped; the same command resumes it");
    return false;
  }
  // A server that lost its folder gets all anew; one that does not answer takes nothing now, and is asked
  // again.
  const auto state = farm_.task_state(info_.id);
  if (!state || !farm_.has_job(info_.id).value_or(false)) {
    put_on_farm();
  } else {
    give_again(*state);
  }
  update_progress();
  return true;
}

/// Gives tasks again whose parts are late, once no task waits for a worker.
void Coordinator::give_again(const QueueState& state) {
  if (state.waiting > 0) {
    last_given_ = Clock::now();
    retry_seconds_ = 0;
    return;
  }
  const double least = std::min(settings_.lease_seconds, std::max(2 * settings_.part_seconds, 1.0));
  retry_seconds_ = std::max(retry_seconds_, least);
  if (seconds_since(last_given_) < retry_seconds_) return;
  farm_.put_tasks(info_.id, missing());
  last_given_ = Clock::now();
  retry_seconds_ *= 2;
}

void Coordinator::update_progress() {
  const double seconds = seconds_since(start_);
  const double rate = static_cast<double>(done_.size() - std::min(done_before_, done_.size())) / seconds;
  progress_.seconds_left.reset();
  // How many stages there are before a target error is not known.
  if (rate > 0 && stage_end_ == job_.job->settings.samples) {
    progress_.seconds_left = static_cast<double>(progress_.parts - progress_.parts_done) / rate;
  }
  if (Clock::now() >= next_count_) {
    const auto start = Clock::now();
    const auto workers = farm_.workers().value_or(std::vector<WorkerInfo>());
    progress_.workers = static_cast<int>(
        std::ranges::count_if(workers, [&](const WorkerInfo& worker) { return worker.job == info_.id; }));
    next_count_ = later_by(Clock::now() - start);
  }
  if (!done_.empty() && Clock::now() >= next_estimate_) {
    const auto start = Clock::now();
    const auto estimate = merge_.film().error_estimate();
    progress_.error.reset();
    if (estimate) progress_.error = transport::with_bias(*estimate, job_.job->settings.bias).error;
    next_estimate_ = later_by(Clock::now() - start);
  }
  progress_.time = std::time(nullptr);
  farm_.put_progress(info_.id, progress_);
}

void Coordinator::finish() {
  farm_.remove_job(info_);
  ::unlink(settings_.ledger.c_str());
}

}  // namespace farm
