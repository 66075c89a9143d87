#include "samples/studies/thesis/equal_time.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "samples/studies/markdown.h"
#include "samples/studies/thesis/tables.h"

namespace study {
namespace {

std::vector<EqualTime> of_scene(const Results& results, const std::string& scene, const std::string& brdf,
                                const std::string& integrator) {
  const auto curve_of = [&](const std::string& technique) {
    return Curve(results.select({scene, brdf, technique, integrator}));
  };
  if (results.select({scene, brdf, "warp", integrator}).empty()) return {};
  EqualTime line{scene, brdf, integrator};
  const Curve warp = curve_of("warp");
  line.is_glossy = is_glossy(brdf);
  line.seconds = warp.last_total();
  line.warp = warp.error_at(line.seconds).value();
  for (const std::string& technique : results.names({scene, brdf, {}, integrator}, &Row::technique)) {
    if (technique == "warp" || technique.ends_with("-ris")) continue;
    const auto error = curve_of(technique).error_at(line.seconds);
    if (technique == "own") {
      line.own = error;
    } else if (error && (line.rival.empty() || *error < line.rival_error)) {
      line.rival = technique;
      line.rival_error = *error;
    }
  }
  return {line};
}

std::string verdict(bool holds) { return holds ? "yes" : "**no**"; }

void add_to(Table& table, const EqualTime& line) {
  table.add({fmt::format("{}, {}{}, {}", line.scene, line.brdf, line.is_glossy ? "*" : "", line.integrator),
             figure(line.seconds), figure(100 * line.warp), line.rival.empty() ? "none in time" : line.rival,
             line.rival.empty() ? "" : figure(100 * line.rival_error),
             line.rival.empty() ? "" : figure(line.warp / line.rival_error), verdict(line.is_best()),
             line.own ? figure(100 * *line.own) : "", line.own ? figure(line.warp / *line.own) : "",
             verdict(line.is_near_own())});
}

/// Counts the glossy lines on which a claim holds, and lists those on which it does not.
Verdict count(const std::vector<EqualTime>& lines, const std::string& claim,
              bool (EqualTime::*holds)() const) {
  std::size_t glossy = 0, won = 0;
  std::string lost;
  for (const EqualTime& line : lines) {
    if (!line.is_glossy) continue;
    ++glossy;
    if ((line.*holds)()) {
      ++won;
    } else {
      lost +=
          fmt::format("{}{} in {} by {}", lost.empty() ? "" : ", ", line.brdf, line.scene, line.integrator);
    }
  }
  return {claim, won == glossy,
          fmt::format("on {} of {} glossy lines{}", won, glossy, lost.empty() ? "" : "; not on " + lost)};
}

}  // namespace

Curve::Curve(const std::vector<const Row*>& rows) {
  for (const Row* row : rows) {
    build_ = row->build;
    points_.push_back({row->render, std::max(row->error, 1e-9)});
  }
  std::sort(points_.begin(), points_.end(),
            [](const Point& a, const Point& b) { return a.seconds < b.seconds; });
}

double Curve::last_total() const { return build_ + points_.back().seconds; }

std::optional<double> Curve::error_at(double total_seconds) const {
  const double seconds = total_seconds - build_;
  if (points_.empty() || !(seconds > 0)) return std::nullopt;
  const auto scaled = [&](const Point& from) { return from.error * std::sqrt(from.seconds / seconds); };
  if (seconds <= points_.front().seconds) return scaled(points_.front());
  if (seconds >= points_.back().seconds) return scaled(points_.back());
  const auto after =
      std::find_if(points_.begin(), points_.end(), [&](const Point& p) { return p.seconds >= seconds; });
  const Point& a = *(after - 1);
  const double fraction = std::log(seconds / a.seconds) / std::log(after->seconds / a.seconds);
  return a.error * std::pow(after->error / a.error, fraction);
}

std::vector<EqualTime> equal_times(const Results& results) {
  std::vector<EqualTime> lines;
  for (const std::string& scene : results.names({}, &Row::scene)) {
    for (const std::string& integrator : results.names({scene}, &Row::integrator)) {
      for (const std::string& brdf : results.names({scene, {}, {}, integrator}, &Row::brdf)) {
        for (EqualTime& line : of_scene(results, scene, brdf, integrator)) lines.push_back(std::move(line));
      }
    }
  }
  return lines;
}

std::string equal_time_section(const Results& results) {
  const std::vector<EqualTime> lines = equal_times(results);
  Table table({"image", "s", "`warp`, %", "best other generic", "its error, %", "`warp` / it", "best?",
               "`own`, %", "`warp` / `own`", "at most 1.3?"});
  for (const EqualTime& line : lines) add_to(table, line);
  return "\n## Error at equal time\n\nThis table compares the average relative error in the time that `warp` "
         "takes for its most samples, including building tables. Errors are interpolated between "
         "measurements, and extrapolated by the power -1/2 of the time. A scheme whose tables take longer to "
         "build is left out. Glossy BRDFs are marked by a star; the targets apply to them only. Differences "
         "of up to 3 % are ignored.\n\n" +
         table.str() +
         sentences({count(lines, "at equal time `warp` is the best generic scheme on every glossy BRDF",
                          &EqualTime::is_best),
                    count(lines, "its error is at most 1.3 times that of the BRDF's own sampler",
                          &EqualTime::is_near_own)});
}

}  // namespace study
