// Background work of which only the latest request counts.
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <QPointer>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace editor {

/// A cancellation flag that work polls.
class StopFlag {
 public:
  bool is_set() const { return *flag_; }
  void set() const { *flag_ = true; }

 private:
  std::shared_ptr<std::atomic<bool>> flag_ = std::make_shared<std::atomic<bool>>(false);
};

/// Runs one request at a time in the application's thread pool. A new request cancels the running one and
/// replaces the queued one, so that requests never pile up. Work must own what it uses, since it may outlive
/// the job and its owner; results are delivered in the owner's thread.
template <class Result>
class BackgroundJob {
 public:
  using Work = std::function<Result(const StopFlag&)>;
  using Report = std::function<void(Result)>;

  /// Results are delivered while the owner lives; those of cancelled work are not.
  explicit BackgroundJob(QObject* owner) : state_(std::make_shared<State>()) { state_->owner = owner; }
  BackgroundJob(const BackgroundJob&) = delete;
  BackgroundJob& operator=(const BackgroundJob&) = delete;
  ~BackgroundJob() { stop(); }

  void start(Work work, Report report) {
    state_->waiting = Request{std::move(work), std::move(report), {}};
    if (state_->running) {
      state_->running->set();
    } else {
      run_waiting(state_);
    }
  }

  void stop() {
    state_->waiting.reset();
    if (state_->running) state_->running->set();
  }

  /// True until the result of the latest request was delivered.
  bool is_busy() const { return state_->waiting || (state_->running && !state_->running->is_set()); }

 private:
  struct Request {
    Work work;
    Report report;
    StopFlag stop;
  };
  /// Used only in the owner's thread.
  struct State {
    QPointer<QObject> owner;
    std::optional<StopFlag> running;
    std::optional<Request> waiting;
  };

  static void run_waiting(const std::shared_ptr<State>& state) {
    if (!state->waiting) return;
    const Request request = *std::exchange(state->waiting, std::nullopt);
    state->running = request.stop;
    // The pool keeps neither job nor owner alive, but detects whether they are.
    QThreadPool::globalInstance()->start([request, state] {
      auto result = std::make_shared<Result>(request.work(request.stop));
      QMetaObject::invokeMethod(
          qApp,
          [request, state, result] {
            state->running.reset();
            if (!request.stop.is_set() && state->owner) request.report(std::move(*result));
            if (state->owner && !state->running) run_waiting(state);
          },
          Qt::QueuedConnection);
    });
  }

  std::shared_ptr<State> state_;
};

}  // namespace editor
