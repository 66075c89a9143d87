#include "renderer/command/farm_command.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "renderer/command/json_values.h"
#include "renderer/command/printed.h"
#include "renderer/command/render_progress.h"
#include "renderer/command/signal_handler.h"
#include "renderer/farm/server.h"
#include "renderer/farm/worker.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using nlohmann::ordered_json;

/// Reads the token that a file has; empty after an error.
std::optional<std::string> token_in(const std::string& path, Diagnostics& diagnostics) {
  if (path.empty()) return "";
  const auto bytes = grf::read_file(path, diagnostics);
  if (!bytes) return std::nullopt;
  constexpr const char* Space = " \t\r\n";
  const std::size_t first = bytes->find_first_not_of(Space);
  if (first != std::string::npos) return bytes->substr(first, bytes->find_last_not_of(Space) + 1 - first);
  diagnostics.error(grf::whole_file(path), "expected a token: any text that others cannot guess");
  return std::nullopt;
}

std::optional<farm::Access> access_of(const FarmArguments& arguments, Diagnostics& diagnostics) {
  const auto token = token_in(arguments.token_file, diagnostics);
  if (!token) return std::nullopt;
  return farm::Access{arguments.server, *token, arguments.tls_authority, arguments.tls_certificate,
                      arguments.tls_key};
}

/// The flags that another command needs for the same access, with its files.
std::string flags_text(const FarmArguments& access, const std::string& server) {
  std::string flags;
  if (server != FarmArguments().server) flags += " --server " + server;
  if (!access.token_file.empty()) flags += " --token-file " + access.token_file;
  if (!access.tls_certificate.empty() && access.tls_authority.empty()) flags += " --tls-ca CA.pem";
  if (!access.tls_authority.empty()) {
    flags += fmt::format(" --tls-ca {} --tls-cert CERTIFICATE.pem --tls-key KEY.pem", access.tls_authority);
  }
  return flags;
}

/// Says who can use the server, and what to type elsewhere.
void print_commands(const farm::ServerSettings& settings, const FarmArguments& access, bool is_ours) {
  const bool is_local = farm::is_loopback(settings.host);
  const std::string host = is_local ? settings.host : farm::host_name();
  const bool has_tls = !settings.tls_certificate.empty();
  const std::string url = fmt::format("{}://{}:{}", has_tls ? "tls" : "nats", host, settings.port);
  const std::string flags = flags_text(access, url);
  std::string reach = is_local ? ", for this machine alone" : "";
  if (!settings.has_access_control()) reach += ": --token-file or --tls-ca open it to others";
  fmt::print("{} {}{}\n", is_ours ? "The farm's server listens at" : "The farm's server already runs at", url,
             reach);
  if (!settings.token.empty() && !has_tls && !is_local) {
    fmt::print("Connections are not encrypted (--tls-cert): whoever reads the network learns the token.\n");
  }
  fmt::print(
      "On each machine that is to work:\n  bpt farm work{}\nTo render:\n"
      "  bpt farm render SCENE.op -o image.exr{}\n",
      flags, flags);
  std::fflush(stdout);
}

/// Something that a signal stops.
struct Waiting {
  std::atomic<bool> is_stopped = false;
  void stop() { is_stopped = true; }
};

ordered_json json_of(const farm::JobInfo& job, const std::optional<farm::Progress>& progress) {
  ordered_json result = {{"id", job.id},
                         {"scene", job.name},
                         {"host", job.host},
                         {"created", job.created},
                         {"version", job.version},
                         {"parts", nullptr},
                         {"parts_done", nullptr},
                         {"workers", nullptr},
                         {"estimated_error", nullptr},
                         {"seconds_left", nullptr},
                         {"seconds_since_progress", nullptr}};
  if (!progress) return result;
  result["parts"] = progress->parts;
  result["parts_done"] = progress->parts_done;
  result["workers"] = progress->workers;
  result["estimated_error"] = number_or_null(progress->error);
  result["seconds_left"] = number_or_null(progress->seconds_left);
  result["seconds_since_progress"] = std::max<std::int64_t>(0, std::time(nullptr) - progress->time);
  return result;
}

void print_job(const ordered_json& job) {
  fmt::print("{}  {} of {}", job["id"].get<std::string>(), job["scene"].get<std::string>(),
             job["host"].get<std::string>());
  if (!job["parts"].is_null()) {
    fmt::print(", {} of {} parts, {} workers", job["parts_done"].get<int>(), job["parts"].get<int>(),
               job["workers"].get<int>());
    if (!job["seconds_left"].is_null())
      fmt::print(", {} left", duration_text(job["seconds_left"].get<double>()));
    const auto age = job["seconds_since_progress"].get<std::int64_t>();
    constexpr std::int64_t Long = 30;
    if (age > Long) fmt::print("; nobody waits for it since {}", duration_text(static_cast<double>(age)));
  }
  fmt::print("\n");
}

/// Returns the farm's jobs; empty if the server does not answer.
std::optional<ordered_json> jobs_of(const farm::Farm& farm) {
  const auto jobs = farm.jobs();
  if (!jobs) return std::nullopt;
  auto list = ordered_json::array();
  for (const farm::JobInfo& job : *jobs) list.push_back(json_of(job, farm.progress(job.id)));
  return list;
}

ExitCode no_answer() {
  fmt::print(stderr, "error: the farm's server does not answer\n");
  return ExitCode::BadInput;
}

void print_worker(const farm::WorkerInfo& worker) {
  fmt::print("{}  {}, {} threads, {}{}\n", worker.id, worker.host, worker.threads,
             worker.job.empty() ? "idle" : "works for " + worker.job,
             worker.refused.empty() ? "" : "; refused a job: " + worker.refused);
}

/// Returns the folder for job files of workers.
std::string cache_folder() {
  namespace fs = std::filesystem;
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value != nullptr ? value : "");
  };
  if (const fs::path cache = folder("XDG_CACHE_HOME"); cache.is_absolute())
    return (cache / "granada" / "farm").string();
  if (const fs::path home = folder("HOME"); home.is_absolute())
    return (home / ".cache" / "granada" / "farm").string();
  return (fs::temp_directory_path() / "granada_farm").string();
}

}  // namespace

std::optional<farm::Farm> join_farm(const FarmArguments& arguments, const std::string& name) {
  Diagnostics diagnostics;
  const auto access = access_of(arguments, diagnostics);
  print(diagnostics);
  if (!access) return std::nullopt;
  std::string problem;
  auto farm = farm::Farm::join(*access, name, problem);
  if (!farm) fmt::print(stderr, "error: {}\n", problem);
  return farm;
}

ExitCode farm_serve(const FarmServeArguments& arguments) {
  Waiting waiting;
  SignalHandler signal_handler;
  signal_handler.stop_on_signal(waiting);
  Diagnostics diagnostics;
  const FarmArguments& access = arguments.access;
  const auto token = token_in(access.token_file, diagnostics);
  print(diagnostics);
  if (!token) return ExitCode::BadInput;
  farm::ServerSettings settings{arguments.folder,       arguments.host, arguments.port,      *token,
                                access.tls_certificate, access.tls_key, access.tls_authority};
  if (settings.host.empty()) settings.host = settings.has_access_control() ? "0.0.0.0" : "127.0.0.1";
  const bool has_key = settings.tls_certificate.empty() == settings.tls_key.empty();
  if (!has_key || (settings.tls_certificate.empty() && !settings.tls_authority.empty())) {
    fmt::print(stderr, "error: TLS needs both --tls-cert and --tls-key\n");
    return ExitCode::BadCommandLine;
  }
  if (!settings.has_access_control() && !farm::is_loopback(settings.host)) {
    fmt::print(stderr,
               "error: --host {}: without --token-file or --tls-ca, the server listens on 127.0.0.1 alone\n",
               settings.host);
    return ExitCode::BadCommandLine;
  }
  // The server itself is asked from this machine, and not by TLS, for which it may ask for a certificate.
  farm::Access own;
  own.url = fmt::format("nats://127.0.0.1:{}", settings.port);
  own.token = settings.token;
  const bool can_ask = settings.tls_certificate.empty();
  std::string problem;
  if (can_ask && farm::Farm::join(own, "serve", problem)) {
    print_commands(settings, access, false);
    return ExitCode::Done;
  }
  auto server = farm::Server::start(settings, diagnostics);
  print(diagnostics);
  if (!server) return ExitCode::BadInput;
  constexpr int Attempts = 50;
  bool has_answered = !can_ask;
  for (int i = 0; i < Attempts && !has_answered && server->is_running() && !waiting.is_stopped; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    has_answered = farm::Farm::join(own, "serve", problem).has_value();
  }
  if (has_answered) print_commands(settings, access, true);
  while (has_answered && server->is_running() && !waiting.is_stopped) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (waiting.is_stopped) return ExitCode::Interrupted;
  fmt::print(stderr, "error: the server ended{}; its log is {}\n", has_answered ? "" : ": " + problem,
             (std::filesystem::path(settings.folder) / "nats-server.log").string());
  return ExitCode::BadInput;
}

ExitCode farm_work(const FarmWorkArguments& arguments) {
  std::optional<farm::Worker> worker;
  SignalHandler signal_handler;  // destroyed before the worker that it stops
  const auto farm = join_farm(arguments.access, "work");
  if (!farm) return ExitCode::BadInput;
  farm::WorkerSettings settings;
  settings.threads = arguments.threads;
  settings.version = GRANADA_VERSION;
  settings.cache_folder = arguments.cache_folder.empty() ? cache_folder() : arguments.cache_folder;
  settings.cache_bytes = static_cast<std::uint64_t>(arguments.cache_gigabytes * 1e9);
  const auto say = [](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  };
  worker.emplace(*farm, settings, say);
  signal_handler.stop_on_signal(*worker);
  say(fmt::format("waiting for jobs at {}", arguments.access.server));
  if (worker->run()) return ExitCode::Interrupted;
  fmt::print(stderr, "error: the server refuses the connection\n");
  return ExitCode::BadInput;
}

ExitCode farm_list(const FarmArguments& arguments) {
  const auto farm = join_farm(arguments, "list");
  if (!farm) return ExitCode::BadInput;
  const auto jobs = jobs_of(*farm);
  if (!jobs) return no_answer();
  if (arguments.json) fmt::print("{}\n", json_text(ordered_json{{"jobs", *jobs}}, false));
  for (const ordered_json& job : *jobs) {
    if (!arguments.json) print_job(job);
  }
  return ExitCode::Done;
}

ExitCode farm_status(const FarmArguments& arguments) {
  const auto farm = join_farm(arguments, "status");
  if (!farm) return ExitCode::BadInput;
  const auto jobs = jobs_of(*farm);
  const auto workers = farm->workers();
  if (!jobs || !workers) return no_answer();
  if (arguments.json) {
    auto list = ordered_json::array();
    for (const farm::WorkerInfo& worker : *workers)
      list.push_back(ordered_json::parse(farm::json_of(worker)));
    const ordered_json status = {{"server", arguments.server}, {"jobs", *jobs}, {"workers", list}};
    fmt::print("{}\n", json_text(status, false));
    return ExitCode::Done;
  }
  fmt::print("{}: {} jobs, {} workers\n", arguments.server, jobs->size(), workers->size());
  for (const ordered_json& job : *jobs) print_job(job);
  for (const farm::WorkerInfo& worker : *workers) print_worker(worker);
  return ExitCode::Done;
}

ExitCode farm_stop(const std::string& id, const FarmArguments& arguments) {
  const auto farm = join_farm(arguments, "stop");
  if (!farm) return ExitCode::BadInput;
  const auto jobs = farm->jobs();
  if (!jobs) return no_answer();
  const auto job = std::ranges::find(*jobs, id, &farm::JobInfo::id);
  if (job == jobs->end()) {
    fmt::print(stderr, "error: the farm has no job {}: `bpt farm list` prints its jobs\n", id);
    return ExitCode::BadInput;
  }
  if (!farm->stop_job(*job)) return no_answer();
  if (arguments.json) fmt::print("{}\n", json_text(ordered_json{{"stopped", id}}, false));
  if (!arguments.json) fmt::print("stopped {} ({})\n", id, job->name);
  return ExitCode::Done;
}

}  // namespace command
