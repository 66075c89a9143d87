// Job files are kept on a worker's disk between parts and jobs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "grf/diagnostics.h"
#include "renderer/transport/digest.h"

namespace farm {

/// Files by the digest of their contents, in a folder that several workers may share. When they exceed a
/// limit, those that were used longest ago are removed.
class JobCache {
 public:
  JobCache(std::filesystem::path folder, std::uint64_t limit_bytes)
      : folder_(std::move(folder)), limit_bytes_(limit_bytes) {}

  /// Returns the path of a file, if it is there and has these contents.
  std::optional<std::string> find(const transport::Digest& digest) const;
  /// Adds a file, and returns its path. It stays even if it exceeds the limit by itself.
  std::optional<std::string> add(const transport::Digest& digest, std::string_view bytes,
                                 grf::Diagnostics& diagnostics) const;

 private:
  std::filesystem::path path_of(const transport::Digest& digest) const;
  void evict(const std::filesystem::path& except) const;

  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
};

}  // namespace farm
