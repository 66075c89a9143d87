#include "renderer/parallel/loops.h"

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <set>
#include <thread>

#include <gtest/gtest.h>

namespace {

using namespace std::chrono_literals;

/// A barrier at which threads wait until the expected number has arrived, with a timeout.
class MeetingPlace {
 public:
  explicit MeetingPlace(std::size_t expected, std::chrono::milliseconds timeout)
      : expected_(expected), end_(std::chrono::steady_clock::now() + timeout) {}

  void come() {
    std::unique_lock lock(lock_);
    present_.insert(std::this_thread::get_id());
    changed_.notify_all();
    changed_.wait_until(lock, end_, [&] { return present_.size() >= expected_; });
  }
  std::size_t present() {
    const std::lock_guard lock(lock_);
    return present_.size();
  }

 private:
  const std::size_t expected_;
  const std::chrono::steady_clock::time_point end_;
  std::mutex lock_;
  std::condition_variable changed_;
  std::set<std::thread::id> present_;
};

/// Counts the threads that take part in a job's loops; waits for `expected` ones.
std::size_t threads_of_job(int threads, std::size_t expected, std::chrono::milliseconds timeout) {
  MeetingPlace place(expected, timeout);
  parallel::run_with_threads(threads, [&] { parallel::for_each_index(100, [&](int) { place.come(); }); });
  return place.present();
}

TEST(RunWithThreads, UsesAsManyAsWereAskedFor) {
  for (const std::size_t threads : {1, 2, 7}) {
    EXPECT_EQ(threads_of_job(static_cast<int>(threads), threads, 10s), threads);
  }
  const std::size_t cores = std::thread::hardware_concurrency();
  EXPECT_EQ(threads_of_job(0, cores, 10s), cores);
}

TEST(RunWithThreads, UsesNoMoreThanThat) {
  EXPECT_EQ(threads_of_job(1, 2, 50ms), 1U);
  EXPECT_EQ(threads_of_job(3, 4, 50ms), 3U);
}

TEST(RunWithThreads, SaysHowManyThereAre) {
  for (const int threads : {1, 2, 7}) {
    parallel::run_with_threads(threads, [&] { EXPECT_EQ(parallel::thread_count(), threads); });
  }
}

// An editor previews with few threads while it renders with more.
TEST(RunWithThreads, IsNotLimitedByJobsThatRunBesides) {
  for (const std::size_t others : {1, 3}) {
    MeetingPlace other_place(others, 10s);
    std::promise<void> started;
    std::promise<void> ended;
    std::thread other([&] {
      parallel::run_with_threads(static_cast<int>(others), [&] {
        parallel::on_each_thread([&] { other_place.come(); });
        started.set_value();
        // Keeps its threads busy with a loop that is as long as the other job.
        const std::shared_future<void> end = ended.get_future().share();
        parallel::on_each_thread([&] { end.wait(); });
      });
    });
    started.get_future().wait();
    EXPECT_EQ(threads_of_job(4, 4, 10s), 4U) << "beside " << others;
    EXPECT_EQ(threads_of_job(1, 2, 50ms), 1U) << "beside " << others;
    ended.set_value();
    other.join();
    EXPECT_EQ(other_place.present(), others);
  }
}

}  // namespace
