#pragma once

#include <QObject>
#include <vector>

#include "editor/jobs/job.h"

namespace editor {

/// The queued and running jobs. Jobs of one queue run in the order in which they were added.
class JobList : public QObject {
  Q_OBJECT

 public:
  explicit JobList(QObject* parent = nullptr) : QObject(parent) {}

  /// Adds a job, which starts at once if its queue is idle.
  void add(JobTask task);
  const std::vector<Job*>& jobs() const { return jobs_; }
  /// Whether jobs of a queue are queued or running.
  bool is_busy(const QString& queue) const;

 signals:
  /// Emitted when jobs are added, change or end.
  void changed();
  void failed(const QString& problem);
  void queue_emptied(const QString& queue);

 private:
  void remove(Job* job, const QString& problem);
  void begin_next(const QString& queue);

  std::vector<Job*> jobs_;  ///< children of this
};

}  // namespace editor
