#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <mutex>
#include <thread>

namespace command {

/// Handles SIGINT and SIGTERM for its lifetime. During a render the first signal stops it, so that the image
/// so far can be written; before a render, and at the second signal, the program exits with code 130.
///
/// The signals are blocked in all threads started meanwhile, and one thread waits for them, so no system call
/// is interrupted half done. SIGPIPE is blocked too: a reader that closed the pipe is no reason to lose an
/// image.
class SignalHandler {
 public:
  SignalHandler();
  SignalHandler(const SignalHandler&) = delete;
  SignalHandler& operator=(const SignalHandler&) = delete;
  ~SignalHandler();

  /// Makes the first signal stop this render or bake, which must outlive this object.
  template <class Work>
  void stop_on_signal(Work& work) {
    const std::lock_guard lock(stop_lock_);
    stop_ = [&work] { work.stop(); };
  }
  bool was_signalled() const { return was_signalled_; }

 private:
  void wait();

  sigset_t set_ = {};
  sigset_t before_ = {};
  std::mutex stop_lock_;
  std::function<void()> stop_;
  std::atomic<bool> was_signalled_ = false;
  std::atomic<bool> ended_ = false;
  std::thread thread_;  ///< declared last, because it uses the other members
};

}  // namespace command
