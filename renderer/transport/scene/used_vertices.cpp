#include "renderer/transport/scene/used_vertices.h"

namespace transport {

UsedVertices::UsedVertices(const grf::Mesh& mesh) : count_(mesh.geometry->positions.size()) {
  std::vector<bool> is_used(mesh.geometry->positions.size());
  for (const std::uint32_t corner : mesh.geometry->corners) is_used[corner] = true;
  const auto used = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), true));
  if (used == count_) return;
  count_ = used;
  vertices_.reserve(used);
  for (std::uint32_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i]) vertices_.push_back(i);
  }
}

}  // namespace transport
