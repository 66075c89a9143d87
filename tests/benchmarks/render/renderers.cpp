#include "tests/benchmarks/render/renderers.h"

#include <fstream>
#include <regex>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/options/op_file.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"

namespace benchmark {
namespace {

namespace fs = std::filesystem;

constexpr const char* CyclesScene = GRANADA_SOURCE_DIR "/tests/benchmarks/render/cycles_scene.py";

fs::path meter_file_of(const Job& job) { return job.image.string() + ".embree"; }
fs::path rays_file_of(const Job& job) { return job.image.string() + ".rays"; }

/// The eye of an OP file, as three numbers.
std::string eye_of(const fs::path& op) {
  grf::Diagnostics diagnostics;
  const auto read = options::read_op_file(op.string(), diagnostics);
  if (!read || !read->eye)
    throw std::runtime_error(op.string() + ": no BPT_Viewer\n" + diagnostics.to_text());
  return fmt::format("{} {} {}", read->eye->x, read->eye->y, read->eye->z);
}

test::Outcome run(const Job& job, std::vector<std::string> command) {
  if (job.measures_embree) {
    command.insert(command.begin(), {"/usr/bin/env", "LD_PRELOAD=" EMBREE_METER,
                                     "EMBREE_METER=" + meter_file_of(job).string()});
  }
  if (job.records_rays) {
    command.insert(command.begin(),
                   {"/usr/bin/env", "LD_PRELOAD=" RAY_RECORDER, "RAY_RECORDER=" + rays_file_of(job).string(),
                    "RAY_RECORDER_EYE=" + eye_of(job.op)});
  }
  auto outcome = test::run(command);
  if (outcome.exit_code != 0) {
    throw std::runtime_error(
        fmt::format("{} ended with {}: {}", fmt::join(command, " "), outcome.exit_code, outcome.err));
  }
  return outcome;
}

EmbreeTime embree_time(const Job& job, double render_seconds) {
  EmbreeTime time;
  double cost = 0;
  std::ifstream file(meter_file_of(job));
  if (!(file >> time.queries >> time.seconds >> cost) || !(time.queries > 0)) {
    throw std::runtime_error("the Embree meter recorded no query");
  }
  time.share = time.seconds / (job.threads * render_seconds - time.queries * cost);
  return time;
}

std::vector<RayKind> ray_kinds(const Job& job) {
  std::ifstream file(rays_file_of(job));
  std::vector<RayKind> kinds;
  RayKind kind;
  for (double seconds = 0; file >> kind.name >> kind.rays >> seconds;) {
    kind.embree_per_second = seconds > 0 ? kind.rays * job.threads / seconds : 0;
    kinds.push_back(kind);
  }
  if (kinds.size() != 3) throw std::runtime_error("the ray recorder recorded no rays");
  return kinds;
}

Outcome render_by_bpt(const Job& job) {
  const auto ran =
      run(job, {GRANADA_BIN_DIR "/bpt", "render", job.op.string(), "--output", job.image.string(), "--size",
                fmt::format("{0}x{0}", job.size), "--samples", std::to_string(job.samples), "--seed",
                std::to_string(job.seed), "--threads", std::to_string(job.threads), "--json"});
  const auto summary = nlohmann::json::parse(ran.out);
  const double seconds = summary.at("render_seconds");
  const double rays_per_second = summary.at("rays_per_second");
  return {seconds, summary.at("peak_memory_bytes"), rays_per_second * seconds, {}, {}};
}

/// Returns the number that follows a text in a log.
double number_after(const std::string& log, const std::string& text) {
  std::smatch found;
  if (std::regex_search(log, found, std::regex(text + " *([0-9.]+)"))) return std::stod(found[1]);
  throw std::runtime_error("no '" + text + "' in Blender's log: " + log);
}

// The wall time of "Path Tracing" in Cycles' own report: without scene synchronisation, acceleration
// structures and files, as bpt's render_seconds.
Outcome render_by_cycles(const Job& job) {
  const auto ran =
      run(job, {"/usr/bin/blender", "--background", "--factory-startup", "--debug-cycles", "--python",
                CyclesScene, "--", job.op.string(), job.image.string(), std::to_string(job.size),
                std::to_string(job.samples), std::to_string(job.seed), std::to_string(job.threads)});
  const std::string log = ran.out + ran.err;
  return {number_after(log, "\n *Path Tracing "), number_after(log, "peak memory:"), {}, {}, {}};
}

}  // namespace

std::string name_of(Renderer renderer) { return renderer == Renderer::Bpt ? "bpt" : "cycles"; }

Outcome render(Renderer renderer, const Job& job) {
  Outcome outcome = renderer == Renderer::Bpt ? render_by_bpt(job) : render_by_cycles(job);
  if (job.measures_embree) outcome.embree = embree_time(job, outcome.seconds);
  if (job.records_rays) outcome.ray_kinds = ray_kinds(job);
  return outcome;
}

std::optional<std::string> blender_version() {
  if (!fs::exists("/usr/bin/blender")) return std::nullopt;
  const std::string out = test::run({"/usr/bin/blender", "--version"}).out;
  return out.substr(0, out.find('\n'));
}

std::string required_blender_version() {
  const auto version = blender_version();
  if (!version) throw std::runtime_error("Blender is not installed: apt-get install blender python3-numpy");
  return *version;
}

}  // namespace benchmark
