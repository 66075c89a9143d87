#include "tests/benchmarks/render/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace benchmark {
namespace {

std::string number(const std::optional<double>& value, double unit, int decimals) {
  return value ? fmt::format("{:.{}f}", *value / unit, decimals) : "";
}

std::string row_of(const Measurement& m) {
  return fmt::format("| {} | {} | {:.2f} | {} | {} | {:.3g} | {:.3g} | {:.3g} | {} | {:.0f} |\n", m.scene,
                     name_of(m.renderer), m.paths_per_second / 1e6, number(m.rays_per_second, 1e6, 2),
                     number(m.embree_share, 0.01, 0), m.seconds, m.relmse, m.efficiency(), m.fireflies,
                     m.peak_memory_bytes / 1048576);
}

const Measurement* find(const std::vector<Measurement>& measurements, const std::string& scene,
                        Renderer renderer) {
  const auto found = std::find_if(measurements.begin(), measurements.end(), [&](const Measurement& m) {
    return m.scene == scene && m.renderer == renderer;
  });
  return found == measurements.end() ? nullptr : &*found;
}

std::string comparison(const std::vector<Measurement>& measurements) {
  std::string text;
  for (const Measurement& ours : measurements) {
    if (ours.renderer != Renderer::Bpt) continue;
    const Measurement* theirs = find(measurements, ours.scene, Renderer::Cycles);
    if (theirs == nullptr) continue;
    text += fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |\n", ours.scene,
                        ours.efficiency() / theirs->efficiency(),
                        ours.paths_per_second / theirs->paths_per_second, theirs->relmse / ours.relmse,
                        100 * largest_difference(ours.mean, theirs->mean));
  }
  if (text.empty()) return text;
  return "\nRatios of bpt to Cycles: efficiency, paths per second, and accuracy per path\n\n"
         "| scene | efficiency | paths/s | relMSE | means differ by, % |\n|---|--:|--:|--:|--:|\n" +
         text;
}

}  // namespace

double largest_difference(const reflectance::Rgb& a, const reflectance::Rgb& b) {
  double largest = 0;
  for (int channel = 0; channel < 3; ++channel) {
    largest = std::max(largest, std::abs(static_cast<double>(a[channel]) / b[channel] - 1));
  }
  return largest;
}

nlohmann::json to_json(const std::vector<Measurement>& measurements) {
  const auto or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
  };
  nlohmann::json rows = nlohmann::json::array();
  for (const Measurement& m : measurements) {
    rows.push_back({{"scene", m.scene},
                    {"renderer", name_of(m.renderer)},
                    {"paths_per_second", m.paths_per_second},
                    {"rays_per_second", or_null(m.rays_per_second)},
                    {"embree_share", or_null(m.embree_share)},
                    {"render_seconds", m.seconds},
                    {"relmse", m.relmse},
                    {"efficiency", m.efficiency()},
                    {"fireflies", m.fireflies},
                    {"peak_memory_bytes", m.peak_memory_bytes},
                    {"mean", {m.mean.x, m.mean.y, m.mean.z}}});
  }
  return rows;
}

std::string to_csv(const std::vector<Measurement>& measurements) {
  std::string text =
      "scene,renderer,paths_per_second,rays_per_second,embree_share,render_seconds,relmse,efficiency,"
      "fireflies,"
      "peak_memory_bytes\n";
  for (const Measurement& m : measurements) {
    text += fmt::format("{},{},{:.6g},{},{},{:.6g},{:.6g},{:.6g},{},{:.0f}\n", m.scene, name_of(m.renderer),
                        m.paths_per_second, number(m.rays_per_second, 1, 0), number(m.embree_share, 1, 4),
                        m.seconds, m.relmse, m.efficiency(), m.fireflies, m.peak_memory_bytes);
  }
  return text;
}

std::string to_markdown(const std::vector<Measurement>& measurements) {
  std::string text =
      "| scene | renderer | Mpaths/s | Mrays/s | in Embree, % | seconds | relMSE | efficiency | fireflies | "
      "peak memory, MiB |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Measurement& m : measurements) text += row_of(m);
  return text + comparison(measurements);
}

}  // namespace benchmark
