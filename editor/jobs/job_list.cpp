#include "editor/jobs/job_list.h"

#include <algorithm>

namespace editor {

void JobList::add(JobTask task) {
  auto* job = new Job(std::move(task), this);
  jobs_.push_back(job);
  connect(job, &Job::changed, this, &JobList::changed);
  connect(job, &Job::ended, this, [this, job](const QString& problem) { remove(job, problem); });
  emit changed();
  begin_next(job->queue());
}

bool JobList::is_busy(const QString& queue) const {
  return std::ranges::any_of(jobs_, [&](const Job* job) { return job->queue() == queue; });
}

void JobList::remove(Job* job, const QString& problem) {
  const QString queue = job->queue();
  std::erase(jobs_, job);
  job->deleteLater();
  emit changed();
  if (!problem.isEmpty()) emit failed(problem);
  begin_next(queue);
  if (!is_busy(queue)) emit queue_emptied(queue);
}

void JobList::begin_next(const QString& queue) {
  const auto first = std::ranges::find_if(jobs_, [&](const Job* job) { return job->queue() == queue; });
  if (first != jobs_.end() && (*first)->state() == Job::State::Waiting) (*first)->begin();
}

}  // namespace editor
