#include "converters/embedded_files.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "grf/text_file.h"

namespace convert {
namespace {

/// Returns the n-th candidate name: the name itself, then with `_2`, `_3` and so on before its extension.
std::string candidate(const std::string& name, int attempt) {
  if (attempt == 1) return name;
  const std::filesystem::path path(name);
  return fmt::format("{}_{}{}", path.stem().string(), attempt, path.extension().string());
}

bool holds(const std::string& path, const std::string& bytes) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) != bytes.size() || error) return false;
  grf::Diagnostics ignored_diagnostics;
  const auto present = grf::read_file(path, ignored_diagnostics);
  return present && *present == bytes;
}

/// Writes a file under a free name and returns its path; empty after an error.
std::string write_beside(const EmbeddedFile& file, const std::string& output,
                         std::vector<std::string>& created, grf::Diagnostics& diagnostics) {
  for (int attempt = 1;; ++attempt) {
    const std::filesystem::path folder = std::filesystem::path(output).parent_path();
    std::string path = (folder / candidate(file.name, attempt)).string();
    switch (grf::create_file(path, file.bytes, diagnostics)) {
      case grf::Creation::Done:
        created.push_back(path);
        return path;
      case grf::Creation::Exists:
        if (holds(path, file.bytes)) return path;
        break;
      case grf::Creation::Failed:
        return {};
    }
  }
}

bool is_own_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find_first_of("/\\") == std::string::npos &&
         name.find('\0') == std::string::npos;
}

}  // namespace

std::optional<WrittenFiles> write_embedded_files(std::span<const EmbeddedFile> files,
                                                 const std::string& output, grf::Diagnostics& diagnostics) {
  WrittenFiles written;
  for (const EmbeddedFile& file : files) {
    std::string path;
    if (is_own_name(file.name)) {
      path = write_beside(file, output, written.created, diagnostics);
    } else {
      diagnostics.error(grf::whole_file(output), fmt::format("'{}' is not a valid file name", file.name));
    }
    if (path.empty()) {
      remove_created(written);
      return std::nullopt;
    }
    const std::string name = std::filesystem::path(path).filename().string();
    if (name != file.name) {
      diagnostics.note(
          grf::whole_file(path),
          fmt::format("'{}' is written under this name, since another file has its own", file.name));
    }
    written.names[file.name] = name;
    written.paths.push_back(path);
  }
  return written;
}

void remove_created(const WrittenFiles& files) {
  std::error_code ignored;
  for (const std::string& path : files.created) std::filesystem::remove(path, ignored);
}

}  // namespace convert
