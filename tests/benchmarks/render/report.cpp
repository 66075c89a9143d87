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

/// Rays of all kinds, replayed one kind after the other.
RayKind total_of(const std::vector<RayKind>& kinds) {
  RayKind total{"all", 0, 0};
  double embree_seconds = 0;
  for (const RayKind& kind : kinds) {
    total.rays += kind.rays;
    if (kind.rays > 0) embree_seconds += kind.rays / kind.embree_per_second;
  }
  total.embree_per_second = total.rays / embree_seconds;
  return total;
}

std::string ray_table(const std::vector<Measurement>& measurements) {
  std::string text;
  for (const Measurement& m : measurements) {
    if (m.ray_kinds.empty()) continue;
    std::vector<RayKind> kinds = m.ray_kinds;
    const RayKind total = total_of(kinds);
    kinds.push_back(total);
    text += fmt::format("| {} |", m.scene);
    for (const RayKind& kind : kinds) text += fmt::format(" {:.2f} |", kind.rays / m.seconds / 1e6);
    for (const RayKind& kind : kinds) text += fmt::format(" {:.2f} |", kind.embree_per_second / 1e6);
    text += fmt::format(" {:.0f} |\n", 100 * total.rays / m.seconds / total.embree_per_second);
  }
  if (text.empty()) return text;
  return "\nMrays/s of bpt by kind in the whole render, and of Embree only for the same rays\n\n"
         "| scene | camera | shadow | bounce | all | Embree: camera | shadow | bounce | all | bpt of Embree, "
         "% |\n"
         "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n" +
         text;
}

std::string comparison(const std::vector<Measurement>& measurements) {
  const bool has_both = std::any_of(measurements.begin(), measurements.end(),
                                    [](const Measurement& m) { return m.renderer == Renderer::Cycles; });
  if (!has_both) return {};
  std::string text;
  for (const Measurement& ours : measurements) {
    if (ours.renderer != Renderer::Bpt) continue;
    const Measurement* theirs = find(measurements, ours.scene, Renderer::Cycles);
    if (theirs == nullptr) {
      text += fmt::format("| {} | not in Cycles | | | |\n", ours.scene);
      continue;
    }
    text += fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |\n", ours.scene,
                        ours.efficiency() / theirs->efficiency(),
                        ours.paths_per_second / theirs->paths_per_second, theirs->relmse / ours.relmse,
                        100 * largest_difference(ours.mean, theirs->mean));
  }
  return "\nRatios of bpt to Cycles: efficiency, paths per second, and accuracy per path\n\n"
         "| scene | efficiency | paths/s | relMSE | means differ by, % |\n|---|--:|--:|--:|--:|\n" +
         text;
}

}  // namespace

double largest_difference(const grf::Colour& a, const grf::Colour& b) {
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
  const auto rays_of = [](const Measurement& m) {
    if (m.ray_kinds.empty()) return nlohmann::json(nullptr);
    nlohmann::json rays = {{"counted", *m.counted_rays}};
    for (const RayKind& kind : m.ray_kinds) {
      rays[kind.name] = {{"rays", kind.rays},
                         {"per_second", kind.rays / m.seconds},
                         {"embree_per_second", kind.embree_per_second}};
    }
    return rays;
  };
  nlohmann::json rows = nlohmann::json::array();
  for (const Measurement& m : measurements) {
    rows.push_back({{"scene", m.scene},
                    {"renderer", name_of(m.renderer)},
                    {"paths_per_second", m.paths_per_second},
                    {"rays_per_second", or_null(m.rays_per_second)},
                    {"embree_share", or_null(m.embree_share)},
                    {"rays", rays_of(m)},
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
      "fireflies,peak_memory_bytes,camera_rays_per_second,shadow_rays_per_second,bounce_rays_per_second,"
      "embree_camera_rays_per_second,embree_shadow_rays_per_second,embree_bounce_rays_per_second\n";
  for (const Measurement& m : measurements) {
    text += fmt::format("{},{},{:.6g},{},{},{:.6g},{:.6g},{:.6g},{},{:.0f}", m.scene, name_of(m.renderer),
                        m.paths_per_second, number(m.rays_per_second, 1, 0), number(m.embree_share, 1, 4),
                        m.seconds, m.relmse, m.efficiency(), m.fireflies, m.peak_memory_bytes);
    for (const RayKind& kind : m.ray_kinds) text += fmt::format(",{:.0f}", kind.rays / m.seconds);
    for (const RayKind& kind : m.ray_kinds) text += fmt::format(",{:.0f}", kind.embree_per_second);
    text += m.ray_kinds.empty() ? ",,,,,,\n" : "\n";
  }
  return text;
}

std::string to_markdown(const std::vector<Measurement>& measurements) {
  std::string text =
      "| scene | renderer | Mpaths/s | Mrays/s | in Embree, % | seconds | relMSE | efficiency | fireflies | "
      "peak memory, MiB |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Measurement& m : measurements) text += row_of(m);
  return text + ray_table(measurements) + comparison(measurements);
}

}  // namespace benchmark
