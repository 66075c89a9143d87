#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace test {

/// A folder of its own for a test, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(std::string_view name = {}) const;
  /// Makes a file, and the folders that its name needs; gives its path.
  std::string add(std::string_view name, std::string_view bytes) const;
  /// The names of what is in the folder, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::string bytes_of(const std::string& path);

}  // namespace test
