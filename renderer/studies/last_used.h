#pragma once

#include <memory>
#include <mutex>
#include <optional>

namespace studies {

/// Remembers the last costly value that was made, while something else still uses it: a window makes its next
/// study while it shows the last one. May be used from several threads.
template <class Key, class Value>
class LastUsed {
 public:
  /// Returns the value of this key, or null.
  std::shared_ptr<const Value> find(const Key& key) const {
    const std::lock_guard lock(mutex_);
    return key_ && *key_ == key ? value_.lock() : nullptr;
  }

  void remember(const Key& key, const std::shared_ptr<const Value>& value) {
    const std::lock_guard lock(mutex_);
    key_ = key;
    value_ = value;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<Key> key_;
  std::weak_ptr<const Value> value_;
};

}  // namespace studies
