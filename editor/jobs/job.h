#pragma once

#include <QCoreApplication>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QThreadPool>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace editor {

/// Lets the application's thread pool run more tasks than the processor has cores. QPainter draws parts of
/// large images in the same pool and waits for them: work that filled it would block the window until it is
/// done.
void leave_threads_to_painting();

class Job;

/// Description and functions of a job.
struct JobTask {
  QString title;
  QString queue;                      ///< jobs of one queue run one after another
  std::function<void(Job&)> begin;    ///< starts the work, which calls `end` when it is done
  std::function<void()> cancel = {};  ///< asks the running work to stop; empty: its result is dropped
  QString cancel_tip = {};  ///< effect of cancelling the running work; empty if it cannot be cancelled
};

/// A background job with progress, which can be cancelled. It works on a snapshot, and its result is applied
/// to the current document.
class Job : public QObject {
  Q_OBJECT

 public:
  enum class State { Waiting, Running, Ended };

  Job(JobTask task, QObject* parent) : QObject(parent), task_(std::move(task)) {}

  const QString& title() const { return task_.title; }
  const QString& queue() const { return task_.queue; }
  /// The effect of cancelling the job; empty if it cannot be cancelled.
  QString cancel_tip() const;
  State state() const { return state_; }
  /// Progress from 0 to 1; negative if unknown.
  double done() const { return done_; }
  std::optional<double> seconds_left() const { return seconds_left_; }

  void begin();
  void show_progress(double done, std::optional<double> seconds_left = {});
  /// Ends the job, perhaps with an error message. Later calls do nothing.
  void end(const QString& problem = {});
  /// Removes a queued job, and asks a running one to stop.
  void cancel();

  /// Runs `work` in a thread, then calls `take` with its result in this thread, and ends the job. `work` must
  /// own what it uses. If the job has ended by then, its result and its messages are dropped.
  template <class Work, class Take>
  void run(Work work, Take take);

 signals:
  /// Emitted when state or progress change.
  void changed();
  void ended(const QString& problem);

 private:
  JobTask task_;
  State state_ = State::Waiting;
  double done_ = -1;
  std::optional<double> seconds_left_;
};

template <class Work, class Take>
void Job::run(Work work, Take take) {
  using Result = std::invoke_result_t<Work>;
  // The pool does not keep the job alive, but detects whether it is.
  QThreadPool::globalInstance()->start(
      [work = std::move(work), take = std::move(take), job = QPointer(this)] {
        const auto result = std::make_shared<std::optional<Result>>();
        QString problem;
        try {
          result->emplace(work());
        } catch (const std::exception& error) {
          problem = QString::fromUtf8(error.what());
        }
        const auto bring = [job, take, result, problem] {
          if (!job || job->state() != State::Running) return;
          if (!*result) return job->end(tr("%1: %2").arg(job->title(), problem));
          take(std::move(**result));
          if (job) job->end();  // a question that was asked may have ended it
        };
        QMetaObject::invokeMethod(qApp, bring, Qt::QueuedConnection);
      });
}

}  // namespace editor
