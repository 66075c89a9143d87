#include "renderer/farm/job_cache.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "grf/text_file.h"

namespace farm {

namespace fs = std::filesystem;

fs::path JobCache::path_of(const transport::Digest& digest) const {
  return folder_ / (transport::hex(digest) + ".grfjob");
}

std::optional<std::string> JobCache::find(const transport::Digest& digest) const {
  const fs::path path = path_of(digest);
  std::error_code error;
  if (!fs::exists(path, error)) return std::nullopt;
  grf::Diagnostics ignored_diagnostics;  // what cannot be read is fetched again
  const auto bytes = grf::read_file(path.string(), ignored_diagnostics);
  if (!bytes || transport::digest_of(*bytes) != digest) return std::nullopt;
  fs::last_write_time(path, fs::file_time_type::clock::now(), error);  // it was used
  return path.string();
}

std::optional<std::string> JobCache::add(const transport::Digest& digest, std::string_view bytes,
                                         grf::Diagnostics& diagnostics) const {
  std::error_code error;
  fs::create_directories(folder_, error);
  const fs::path path = path_of(digest);
  if (!grf::replace_file(path.string(), bytes, diagnostics)) return std::nullopt;
  evict(path);
  return path.string();
}

void JobCache::evict(const fs::path& except) const {
  struct File {
    fs::file_time_type used;
    std::uint64_t bytes = 0;
    fs::path path;
  };
  std::error_code error;
  std::vector<File> files;
  std::uint64_t sum = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    if (entry.path().extension() != ".grfjob") continue;
    files.push_back({entry.last_write_time(error), entry.file_size(error), entry.path()});
    sum += files.back().bytes;
  }
  std::ranges::sort(files, {}, &File::used);
  for (const File& file : files) {
    if (sum <= limit_bytes_) return;
    if (file.path == except || !fs::remove(file.path, error)) continue;
    sum -= file.bytes;
  }
}

}  // namespace farm
