#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace grf {

/// Disjoint sets (union-find) of the integers below a count. Each is a set of its own at first.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// Merges the sets of two elements.
  void join(std::uint32_t a, std::uint32_t b) {
    a = set_of(a);
    b = set_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  /// Returns the representative of the member's set: its smallest member.
  std::uint32_t set_of(std::uint32_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];  // path halving
      member = parent_[member];
    }
    return member;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace grf
