#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace convert {

/// Combines another word into a hash, so that all of its bits count.
constexpr std::uint64_t mixed_hash(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15ULL;
  return hash ^ (hash >> 32U);
}

/// A hash table of indices of array elements, with open addressing, to find equal elements. The elements stay
/// in the array.
class IndexTable {
 public:
  /// Returns the index of an equal element, or else adds and returns `next`. `is_equal` compares the element
  /// with the one of an index; equal elements must have equal hashes.
  template <class IsEqual>
  std::uint32_t find_or_add(std::uint64_t hash, std::uint32_t next, const IsEqual& is_equal) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    const auto short_hash = static_cast<std::uint32_t>(hash);
    std::size_t place = short_hash & (slots_.size() - 1);
    for (; slots_[place].index != Empty; place = (place + 1) & (slots_.size() - 1)) {
      if (slots_[place].hash == short_hash && is_equal(slots_[place].index)) return slots_[place].index;
    }
    slots_[place] = {next, short_hash};
    ++count_;
    return next;
  }

 private:
  static constexpr std::uint32_t Empty = 0xFFFFFFFF;
  struct Slot {
    std::uint32_t index = Empty;
    std::uint32_t hash = 0;
  };

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.index == Empty) continue;
      std::size_t place = slot.hash & (slots_.size() - 1);
      while (slots_[place].index != Empty) place = (place + 1) & (slots_.size() - 1);
      slots_[place] = slot;
    }
  }

  std::vector<Slot> slots_;  // a power of two, at most half of them occupied
  std::size_t count_ = 0;
};

}  // namespace convert
