#include "renderer/command/render_fingerprint.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "grf/text_file.h"

namespace command {
namespace {

/// Options that do not change the value of a sample. Files count by content, not by path.
constexpr std::array<std::string_view, 17> NotHashed = {
    "BPT_Scene",          "BPT_Output_Image",  "BPT_EM_Background",    "BPT_Pdf_Factors_File",
    "BPT_Samples",        "BPT_TargetError",   "BPT_MaxTime",          "BPT_Checkpoint",
    "BPT_DisplayWindow",  "BPT_DisplayServer", "BPT_Layers",           "BPT_Threads",
    "BPT_Exposure",       "BPT_Pdf_memstat",   "BPT_Chrono_Rendering", "BPT_Chrono_Sampling",
    "BPT_Chrono_Prebuild"};

std::uint32_t sum_of_file(std::uint32_t before, const std::string& path) {
  grf::Diagnostics ignored_diagnostics;  // the file was read a moment ago
  const auto bytes = grf::read_file(path, ignored_diagnostics);
  const std::uint64_t size = bytes ? bytes->size() : 0;
  // The size separates consecutive files.
  before = transport::check_sum(before, {reinterpret_cast<const char*>(&size), sizeof(size)});
  return bytes ? transport::check_sum(before, *bytes) : before;
}

}  // namespace

transport::Fingerprint fingerprint_of(const options::RenderOptions& render_options,
                                      std::set<std::string> files) {
  transport::Fingerprint fingerprint;
  for (const options::OptionInfo& option : options::option_table()) {
    if (std::find(NotHashed.begin(), NotHashed.end(), option.key) != NotHashed.end()) continue;
    std::string line(option.key);
    for (const std::string& word : options::option_words(render_options, option)) line += " " + word;
    fingerprint.options = transport::check_sum(fingerprint.options, line + "\n");
  }
  // The first render writes these files, and the next one reads them.
  if (!render_options.factors_file.empty()) {
    for (const char* ending : {".txt", "_cdf.txt"}) files.insert(render_options.factors_file + ending);
  }
  for (const std::string& path : files) {
    // An OP file counts by its options, which were hashed above.
    if (!path.ends_with(".op")) fingerprint.files = sum_of_file(fingerprint.files, path);
  }
  fingerprint.program = sum_of_file(0, "/proc/self/exe");
  return fingerprint;
}

}  // namespace command
