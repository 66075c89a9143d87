#include "renderer/farm/records.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace farm {
namespace {

using nlohmann::json;
using transport::Digest;
using transport::Fingerprint;
using transport::ImagePart;

constexpr std::size_t LongestText = 4096;

/// A record is wrong.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void require(bool is_right) {
  if (!is_right) throw Refused("a value is out of its range");
}

/// Names of files and hosts are bytes, and not always UTF-8.
std::string text_of(const json& object) {
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string text_in(const json& object, const char* name) {
  auto text = object.at(name).get<std::string>();
  require(text.size() <= LongestText);
  return text;
}

std::string identifier_in(const json& object, const char* name) {
  auto text = object.at(name).get<std::string>();
  require(is_identifier(text));
  return text;
}

Digest digest_in(const json& object, const char* name) {
  const auto digest = transport::digest_of_hex(object.at(name).get<std::string>());
  require(digest.has_value());
  return *digest;
}

int count_in(const json& object, const char* name) {
  const auto count = object.at(name).get<std::int64_t>();
  require(count >= 0 && count <= ImagePart::All);
  return static_cast<int>(count);
}

std::optional<double> number_in(const json& object, const char* name) {
  if (object.at(name).is_null()) return std::nullopt;
  return object.at(name).get<double>();
}

json number_or_null(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? json(*number) : json(nullptr);
}

json object_of(const ImagePart& part) {
  return {
      {"first_sample", part.first_sample}, {"end_sample", part.end_sample}, {"first_tile", part.first_tile},
      {"end_tile", part.end_tile},         {"index", part.index},           {"count", part.count}};
}

ImagePart part_in(const json& object) {
  const ImagePart part{count_in(object, "first_sample"), count_in(object, "end_sample"),
                       count_in(object, "first_tile"),   count_in(object, "end_tile"),
                       count_in(object, "index"),        count_in(object, "count")};
  require(part.first_sample < part.end_sample && part.first_tile < part.end_tile && part.index < part.count);
  return part;
}

/// The numbers of samples are a list for each tile: the first and the end of one half, and of the other.
json object_of(const Task& task) {
  auto samples = json::array();
  for (const transport::TileSamples& own : task.samples) {
    samples.push_back({own.first[0], own.end[0], own.first[1], own.end[1]});
  }
  return {{"number", task.number},
          {"first_tile", task.first_tile},
          {"samples", std::move(samples)},
          {"is_pilot", task.is_pilot}};
}

Task task_in(const json& object) {
  Task task{
      count_in(object, "number"), count_in(object, "first_tile"), {}, object.at("is_pilot").get<bool>()};
  for (const auto& numbers : object.at("samples").get<std::vector<std::array<std::int64_t, 4>>>()) {
    for (const std::int64_t number : numbers) require(number >= 0 && number <= ImagePart::All);
    require(numbers[0] <= numbers[1] && numbers[2] <= numbers[3]);
    const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(numbers[i]); };
    task.samples.push_back({{at(0), at(2)}, {at(1), at(3)}});
  }
  require(!task.samples.empty() &&
          std::cmp_less_equal(task.samples.size(), ImagePart::All - task.first_tile));
  return task;
}

/// Reads a record by a function that may throw; empty if it did.
template <class Read>
auto read(std::string_view text, const Read& of_object) -> std::optional<decltype(of_object(json()))> {
  try {
    return of_object(json::parse(text));
  } catch (const json::exception&) {
    return std::nullopt;
  } catch (const Refused&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<transport::TileSamples> Task::samples_by_tile(std::size_t tiles) const {
  std::vector<transport::TileSamples> all(tiles);
  std::ranges::copy(samples, all.begin() + first_tile);
  return all;
}

std::string host_name() {
  std::array<char, 256> name = {};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string new_identifier() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

bool is_identifier(std::string_view text) {
  return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string json_of(const JobInfo& job) {
  return text_of({{"id", job.id},
                  {"name", job.name},
                  {"host", job.host},
                  {"created", job.created},
                  {"content", transport::hex(job.content)},
                  {"bytes", job.bytes},
                  {"version", job.version},
                  {"instruction_set", job.instruction_set},
                  {"options", transport::hex(job.fingerprint.options)},
                  {"files", transport::hex(job.fingerprint.files)},
                  {"program", transport::hex(job.fingerprint.program)},
                  {"probe", object_of(job.probe)},
                  {"probe_digest", transport::hex(job.probe_digest)},
                  {"lease_seconds", job.lease_seconds}});
}

std::optional<JobInfo> job_info_of(std::string_view text) {
  return read(text, [](const json& object) {
    JobInfo job;
    job.id = identifier_in(object, "id");
    job.name = text_in(object, "name");
    job.host = text_in(object, "host");
    job.created = object.at("created").get<std::int64_t>();
    job.content = digest_in(object, "content");
    job.bytes = object.at("bytes").get<std::uint64_t>();
    require(job.bytes > 0 && job.bytes <= LargestJob);
    job.version = text_in(object, "version");
    job.instruction_set = text_in(object, "instruction_set");
    job.fingerprint = {digest_in(object, "options"), digest_in(object, "files"),
                       digest_in(object, "program")};
    job.probe = part_in(object.at("probe"));
    job.probe_digest = digest_in(object, "probe_digest");
    job.lease_seconds = object.at("lease_seconds").get<double>();
    require(job.lease_seconds >= 0.1 && job.lease_seconds <= 86400);
    return job;
  });
}

std::string json_of(const Task& task) { return text_of(object_of(task)); }

std::optional<Task> task_of(std::string_view text) { return read(text, task_in); }

std::string json_of(const StageTasks& stage) {
  auto tasks = json::array();
  for (const Task& task : stage.tasks) tasks.push_back(object_of(task));
  return text_of({{"end", stage.end}, {"image_begin", stage.image_begin}, {"tasks", std::move(tasks)}});
}

std::optional<StageTasks> stage_tasks_of(std::string_view text) {
  return read(text, [](const json& object) {
    StageTasks stage{count_in(object, "end"), count_in(object, "image_begin"), {}};
    for (const json& task : object.at("tasks")) stage.tasks.push_back(task_in(task));
    return stage;
  });
}

std::string json_of(const Progress& progress) {
  return text_of({{"parts", progress.parts},
                  {"parts_done", progress.parts_done},
                  {"workers", progress.workers},
                  {"estimated_error", number_or_null(progress.error)},
                  {"seconds_left", number_or_null(progress.seconds_left)},
                  {"time", progress.time}});
}

std::optional<Progress> progress_of(std::string_view text) {
  return read(text, [](const json& object) {
    Progress progress;
    progress.parts = count_in(object, "parts");
    progress.parts_done = count_in(object, "parts_done");
    progress.workers = count_in(object, "workers");
    progress.error = number_in(object, "estimated_error");
    progress.seconds_left = number_in(object, "seconds_left");
    progress.time = object.at("time").get<std::int64_t>();
    return progress;
  });
}

std::string json_of(const WorkerInfo& worker) {
  return text_of({{"id", worker.id},
                  {"host", worker.host},
                  {"threads", worker.threads},
                  {"version", worker.version},
                  {"job", worker.job},
                  {"refused", worker.refused}});
}

std::optional<WorkerInfo> worker_info_of(std::string_view text) {
  return read(text, [](const json& object) {
    WorkerInfo worker;
    worker.id = identifier_in(object, "id");
    worker.host = text_in(object, "host");
    worker.threads = count_in(object, "threads");
    worker.version = text_in(object, "version");
    worker.job = text_in(object, "job");
    require(worker.job.empty() || is_identifier(worker.job));
    worker.refused = text_in(object, "refused");
    return worker;
  });
}

}  // namespace farm
