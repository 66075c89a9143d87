#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <mutex>
#include <thread>

namespace command {

/// What SIGINT and SIGTERM do while there is one of these. During a render the first one stops it, so that
/// the image so far can be kept; before, and the second time, the program ends at once with exit code 130.
///
/// The signals are held back from all threads that start meanwhile, and one thread waits for them: nothing is
/// interrupted half done. A broken pipe is held back too: a reader that went away is no reason to lose an
/// image.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// Has the first signal stop this render or bake, which must outlive this object.
  template <class Work>
  void stops(Work& work) {
    const std::lock_guard lock(stop_lock_);
    stop_ = [&work] { work.stop(); };
  }
  bool has_come() const { return has_come_; }

 private:
  void wait();

  sigset_t set_ = {};
  sigset_t before_ = {};
  std::mutex stop_lock_;
  std::function<void()> stop_;
  std::atomic<bool> has_come_ = false;
  std::atomic<bool> ended_ = false;
  std::thread thread_;  ///< the last member: it uses the others
};

}  // namespace command
