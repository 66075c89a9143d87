#pragma once

#include <memory>
#include <utility>

namespace grf {

/// A value whose copies share memory until one of them is edited. Copies compare as their values do.
/// Copies in different threads may be read at once; a single object must not be edited meanwhile.
template <class T>
class Shared {
 public:
  /// The default value, which is made once for all.
  Shared() {
    static const auto value = std::make_shared<T>();
    value_ = value;
  }
  Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}  // NOLINT: a value is one of its kind

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }

  /// The value, to be changed: first copied if others share it.
  T& edit() {
    if (value_.use_count() > 1) {
      value_ = std::make_shared<T>(*value_);
    } else {
      // The count was read without order: what another thread read from a copy that it has let go since could
      // come after what is written here. Counting once more orders them; ThreadSanitizer knows no fences.
      const std::shared_ptr<T> counted(value_);
    }
    return *value_;
  }

  /// Whether this is a copy of the other that neither has edited: the same without a comparison.
  bool shares(const Shared& other) const { return value_ == other.value_; }

  friend bool operator==(const Shared& a, const Shared& b) {
    return a.value_ == b.value_ || *a.value_ == *b.value_;
  }

 private:
  std::shared_ptr<T> value_;
};

}  // namespace grf
