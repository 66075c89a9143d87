#include "editor/jobs/job.h"

#include <QThread>

namespace editor {

void leave_threads_to_painting() {
  // Of each kind of background work one task runs at a time, and there are fewer kinds than that.
  constexpr int Tasks = 32;
  QThreadPool::globalInstance()->setMaxThreadCount(QThread::idealThreadCount() + Tasks);
}

QString Job::cancel_tip() const {
  return state_ == State::Waiting ? tr("Remove this job from the queue") : task_.cancel_tip;
}

void Job::begin() {
  state_ = State::Running;
  emit changed();
  task_.begin(*this);
}

void Job::show_progress(double done, std::optional<double> seconds_left) {
  done_ = done;
  seconds_left_ = seconds_left;
  emit changed();
}

void Job::end(const QString& problem) {
  if (std::exchange(state_, State::Ended) != State::Ended) emit ended(problem);
}

void Job::cancel() {
  if (cancel_tip().isEmpty()) return;
  if (state_ == State::Running && task_.cancel) return task_.cancel();
  end();
}

}  // namespace editor
