#pragma once

#include <memory>
#include <utility>

namespace grf {

/// A copy-on-write value: copies share memory until one of them is edited, and compare as their values do.
/// Copies in different threads may be read concurrently; a single object must not be edited meanwhile.
template <class T>
class Shared {
 public:
  /// Holds the default value, which all default-constructed objects share.
  Shared() {
    static const auto value = std::make_shared<T>();
    value_ = value;
  }
  Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}  // NOLINT: a value is one of its kind

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }

  /// Returns the value to modify it, after copying it if others share it.
  T& edit() {
    if (value_.use_count() > 1) {
      value_ = std::make_shared<T>(*value_);
    } else {
      // use_count is a relaxed load: reads by another thread through a copy that it has released since could
      // be ordered after the writes here. Another count orders them; ThreadSanitizer does not know fences.
      const std::shared_ptr<T> counted(value_);
    }
    return *value_;
  }

  /// Returns whether both share the same value, which takes no comparison of values.
  bool shares(const Shared& other) const { return value_ == other.value_; }

  friend bool operator==(const Shared& a, const Shared& b) {
    return a.value_ == b.value_ || *a.value_ == *b.value_;
  }

 private:
  std::shared_ptr<T> value_;
};

}  // namespace grf
