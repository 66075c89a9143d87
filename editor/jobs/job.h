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

class Job;

/// What a job is and does.
struct JobTask {
  QString title;
  QString queue;                      ///< jobs of one queue run one after another
  std::function<void(Job&)> begin;    ///< begins the work, which calls `end` once it is done
  std::function<void()> cancel = {};  ///< asks the running work to end; empty: its result is dropped
  QString cancel_tip = {};            ///< what becomes of running work that is cancelled; empty: it cannot be
};

/// Long work that the window does not wait for: its author sees how far it is, and can cancel it. It works on
/// a snapshot, and brings its result to the document as that is by then.
class Job : public QObject {
  Q_OBJECT

 public:
  enum class State { Waiting, Running, Ended };

  Job(JobTask task, QObject* parent) : QObject(parent), task_(std::move(task)) {}

  const QString& title() const { return task_.title; }
  const QString& queue() const { return task_.queue; }
  /// What becomes of the work if it is cancelled; empty: it cannot be.
  QString cancel_tip() const;
  State state() const { return state_; }
  /// How much is done, from 0 to 1; negative: that is not known.
  double done() const { return done_; }
  std::optional<double> seconds_left() const { return seconds_left_; }

  void begin();
  void show_progress(double done, std::optional<double> seconds_left = {});
  /// Ends the job; a problem is why it failed. Later calls do nothing.
  void end(const QString& problem = {});
  /// Removes a job that waits, and asks one that runs to end.
  void cancel();

  /// Runs `work` in a thread, then calls `take` with its result in this one, and ends the job. `work` must
  /// own what it uses. Neither `take` is called nor anything said of a job that has ended by then.
  template <class Work, class Take>
  void run(Work work, Take take);

 signals:
  /// State or progress are others.
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
  // The pool does not keep the job alive, but finds whether it is.
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
