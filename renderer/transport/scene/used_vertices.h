#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grf/mesh.h"

namespace transport {

/// The vertices that faces of a mesh use, in the mesh's order. Others are not compiled: a mesh may have many
/// more vertices than faces, and be placed many times.
class UsedVertices {
 public:
  explicit UsedVertices(const grf::Mesh& mesh);

  std::size_t count() const { return count_; }
  /// Returns the mesh's vertex for an index among the used ones.
  std::uint32_t operator[](std::size_t number) const {
    return are_all() ? static_cast<std::uint32_t>(number) : vertices_[number];
  }
  /// Returns the index of a used vertex among the used ones.
  std::uint32_t index_of(std::uint32_t vertex) const {
    if (are_all()) return vertex;
    const auto place = std::lower_bound(vertices_.begin(), vertices_.end(), vertex);
    return static_cast<std::uint32_t>(place - vertices_.begin());
  }

 private:
  bool are_all() const { return vertices_.empty(); }

  std::size_t count_ = 0;
  std::vector<std::uint32_t> vertices_;  ///< empty if all are used
};

}  // namespace transport
