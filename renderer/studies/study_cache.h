#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace studies {

/// Costly values that a window's next study may use again, such as the tables of a sampling scheme or a
/// filtered environment map. The oldest are dropped when there are many or large ones. May be used from
/// several threads.
class StudyCache {
 public:
  /// Returns the value that was kept under a key, or null. A key names the type of its value, too.
  template <class Value>
  std::shared_ptr<const Value> find(const std::string& key) const {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_) {
      if (entry.key == key) return std::static_pointer_cast<const Value>(entry.value);
    }
    return nullptr;
  }

  /// Keeps a value of so many bytes, in place of one under the same key.
  template <class Value>
  void keep(const std::string& key, std::shared_ptr<const Value> value, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    std::erase_if(entries_, [&](const Entry& entry) {
      if (entry.key != key) return false;
      bytes_ -= entry.bytes;
      return true;
    });
    entries_.push_back({key, std::move(value), bytes});
    bytes_ += bytes;
    while (entries_.size() > MostValues || (entries_.size() > 1 && bytes_ > MostBytes)) {
      bytes_ -= entries_.front().bytes;
      entries_.pop_front();
    }
  }

 private:
  static constexpr std::size_t MostValues = 16;
  static constexpr std::size_t MostBytes = std::size_t{1} << 28U;

  struct Entry {
    std::string key;
    std::shared_ptr<const void> value;
    std::size_t bytes = 0;
  };

  mutable std::mutex mutex_;
  std::deque<Entry> entries_;  ///< the oldest first
  std::size_t bytes_ = 0;
};

}  // namespace studies
