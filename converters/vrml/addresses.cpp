#include "converters/vrml/addresses.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "grf/keywords.h"
#include "grf/text_file.h"

namespace convert::vrml {
namespace {

namespace fs = std::filesystem;

bool is_control_character(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; }

/// Returns whether a URL has a scheme such as `http:`. A single letter before a colon is a Windows drive.
bool has_scheme(std::string_view address) {
  const std::size_t colon = address.find(':');
  if (colon == std::string_view::npos || colon < 2) return false;
  return std::all_of(address.begin(), address.begin() + static_cast<std::ptrdiff_t>(colon),
                     [](char c) { return grf::is_word_character(c) || c == '+' || c == '-' || c == '.'; });
}

/// Returns the file name of a URL, or an empty text if it is not a local file.
std::string file_name(std::string_view address) {
  constexpr std::string_view FileScheme = "file:";
  if (grf::same_keyword(address.substr(0, FileScheme.size()), FileScheme)) {
    address.remove_prefix(FileScheme.size());
    if (address.starts_with("//")) address.remove_prefix(2);
  }
  const bool is_no_name = has_scheme(address) || address.find('"') != std::string_view::npos ||
                          std::any_of(address.begin(), address.end(), is_control_character);
  std::string name(is_no_name ? "" : address);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

}  // namespace

std::optional<std::string> local_file(const std::vector<std::string>& addresses, const std::string& folder,
                                      const std::string& main_path) {
  std::optional<std::string> first;
  for (const std::string& address : addresses) {
    const std::string name = file_name(address);
    if (name.empty()) continue;
    const std::string from_main = (fs::path(folder) / name).lexically_normal().string();
    std::error_code error;
    if (fs::is_regular_file(grf::path_beside(main_path, from_main), error)) return from_main;
    if (!first) first = from_main;
  }
  return first;
}

std::string folder_of(const std::string& name) { return fs::path(name).parent_path().string(); }

}  // namespace convert::vrml
