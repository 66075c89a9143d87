#include "renderer/command/cost_sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/transport/sobol.h"

namespace command {
namespace {

using transport::Integrator;
using transport::Render;
using transport::RenderSettings;

RenderSettings with_samples(RenderSettings settings, int samples) {
  if (settings.integrator.integrator == Integrator::Naive) {
    settings.integrator.secondary_rays = samples / settings.samples;
  } else {
    settings.samples = samples;
  }
  return settings;
}

double mean_with(double mean, double value, std::size_t count) {
  return mean + (value - mean) / static_cast<double>(count);
}

}  // namespace

double CostRow::error() const { return std::sqrt(relmse); }

double CostRow::efficiency() const { return 1 / (relmse * render_seconds); }

CostSweep::CostSweep(CostPlan plan)
    : plan_(std::move(plan)),
      sampling_rates_(plan_.lines.size() + 1),
      start_(std::chrono::steady_clock::now()),
      rates_(plan_.lines.size() + 1) {
  plan_tasks();
}

void CostSweep::plan_tasks() {
  const std::size_t lines = plan_.lines.size();
  const int middle = plan_.samples[(plan_.samples.size() - 1) / 2];
  for (std::size_t line = 0; line < lines; ++line) {
    for (const int samples : plan_.samples) rows_.push_back({line, samples, {}});
  }
  add_known_rows();
  const auto is_missing = [&](const CostRow& row) {
    return row.seeds.size() < static_cast<std::size_t>(plan_.rounds);
  };
  for (std::size_t line = 0; line < lines; ++line) {
    const auto of_line = [&](const CostRow& row) { return row.line == line && is_missing(row); };
    if (std::ranges::any_of(rows_, of_line)) tasks_.push_back({Purpose::WarmUp, line, middle, 0});
  }
  if (!plan_.given) {
    tasks_.push_back({Purpose::WarmUp, lines, std::min(middle, plan_.reference_samples), 0});
    tasks_.push_back({Purpose::Reference, lines, plan_.reference_samples, 0});
  }
  for (int round = 0; round < plan_.rounds; ++round) {
    for (std::size_t i = 0; i < plan_.samples.size(); ++i) {
      for (std::size_t line = 0; line < lines; ++line) {
        const std::size_t row = line * plan_.samples.size() + i;
        if (rows_[row].seeds.size() > static_cast<std::size_t>(round)) continue;
        tasks_.push_back({Purpose::Row, line, plan_.samples[i], row});
      }
    }
  }
}

void CostSweep::add_known_rows() {
  for (const CostRow& known : plan_.known) {
    for (CostRow& row : rows_) {
      if (row.line == known.line && row.samples == known.samples) row = known;
    }
  }
}

/// Returns a seed that no other round of the row has.
std::uint32_t CostSweep::seed_of(const Task& task) const {
  std::uint32_t seed = transport::hash(plan_.seed, static_cast<std::uint32_t>(next_));
  if (task.purpose != Purpose::Row) return seed;
  const std::vector<std::uint32_t>& others = rows_[task.row].seeds;
  while (std::ranges::find(others, seed) != others.end()) seed = transport::hash(seed, 1);
  return seed;
}

const CostSubject& CostSweep::subject(std::size_t index) const {
  return index < plan_.lines.size() ? plan_.lines[index] : plan_.reference;
}

void CostSweep::run() {
  if (plan_.given) reference_ = std::move(*plan_.given);
  for (const Task& task : tasks_) {
    if (!render(task)) return;
    const std::lock_guard lock(lock_);
    ++next_;
  }
}

/// Returns false if the sweep was stopped.
bool CostSweep::render(const Task& task) {
  const CostSubject& what = subject(task.subject);
  RenderSettings settings = with_samples(what.settings, task.samples);
  settings.seed = seed_of(task);
  settings.integrator.measures_sampling = task.purpose == Purpose::WarmUp;
  Render render(*what.scene, settings);
  {
    const std::lock_guard lock(lock_);
    if (is_stopped_) return false;
    current_ = &render;
  }
  try {
    render.run();
  } catch (...) {
    const std::lock_guard lock(lock_);
    current_ = nullptr;
    throw;
  }
  {
    const std::lock_guard lock(lock_);
    current_ = nullptr;
  }
  if (render.end() == transport::RenderEnd::Stopped) return false;
  keep(task, render);
  return true;
}

void CostSweep::keep(const Task& task, const Render& render) {
  switch (task.purpose) {
    case Purpose::WarmUp: {
      sampling_rates_[task.subject] = render.sampling_seconds() / task.samples;
      const std::lock_guard lock(lock_);
      rates_[task.subject] = render.seconds() / task.samples;
      return;
    }
    case Purpose::Reference: {
      const double error = render.error_estimate().value_or(transport::ErrorEstimate()).error;
      reference_ = CostReference{render.film().mean(), render.seconds(), error * error};
      return;
    }
    case Purpose::Row:
      add_to_row(render, rows_[task.row]);
  }
}

void CostSweep::add_to_row(const Render& render, CostRow& row) {
  const image::ImageError error = image::error_of(render.film().mean(), reference_->image);
  const std::lock_guard lock(lock_);
  row.seeds.push_back(render.settings().seed);
  row.rounds.push_back({render.seconds(), error.relmse});
  ++measured_;
  const std::size_t count = row.seeds.size();
  row.relmse = mean_with(row.relmse, error.relmse, count);
  if (error.average_relative_error) {
    row.average_relative_error =
        mean_with(row.average_relative_error.value_or(0), *error.average_relative_error, count);
  }
  const double seconds = render.seconds();
  row.render_seconds = count == 1 ? seconds : std::min(seconds, row.render_seconds);
  row.sampling_seconds = sampling_rates_[row.line] * row.samples;
}

void CostSweep::stop() {
  const std::lock_guard lock(lock_);
  is_stopped_ = true;
  if (current_ != nullptr) current_->stop();
}

transport::RenderProgress CostSweep::progress() const {
  transport::RenderProgress progress;
  progress.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const std::lock_guard lock(lock_);
  if (next_ == tasks_.size()) {
    progress.done = 1;
    progress.seconds_left = 0;
    return progress;
  }
  // Before the warm-up is over, the time per sample is unknown.
  if (tasks_[next_].purpose == Purpose::WarmUp) return progress;
  double left = 0;
  for (std::size_t i = next_; i < tasks_.size(); ++i) left += rates_[tasks_[i].subject] * tasks_[i].samples;
  if (current_ != nullptr) {
    left -= current_->progress().done * rates_[tasks_[next_].subject] * tasks_[next_].samples;
  }
  progress.seconds_left = left;
  progress.done = progress.seconds / (progress.seconds + left);
  return progress;
}

std::size_t CostSweep::measured() const {
  const std::lock_guard lock(lock_);
  return measured_;
}

std::vector<CostRow> CostSweep::rows() const {
  const std::lock_guard lock(lock_);
  std::vector<CostRow> rows;
  for (const CostRow& row : rows_) {
    if (!row.seeds.empty()) rows.push_back(row);
  }
  return rows;
}

}  // namespace command
