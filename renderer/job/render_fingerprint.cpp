#include "renderer/job/render_fingerprint.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "grf/text_file.h"

namespace job {
namespace {

/// Options that do not change the value of a sample. Files count by content, not by path.
constexpr std::array<std::string_view, 17> NotHashed = {
    "BPT_Scene",          "BPT_Output_Image",  "BPT_EM_Background",    "BPT_Pdf_Factors_File",
    "BPT_Samples",        "BPT_TargetError",   "BPT_MaxTime",          "BPT_Checkpoint",
    "BPT_DisplayWindow",  "BPT_DisplayServer", "BPT_Layers",           "BPT_Threads",
    "BPT_Exposure",       "BPT_Pdf_memstat",   "BPT_Chrono_Rendering", "BPT_Chrono_Sampling",
    "BPT_Chrono_Prebuild"};

transport::Digest digest_of_file(const std::string& path) {
  grf::Diagnostics ignored_diagnostics;  // the file was read a moment ago
  const auto bytes = grf::read_file(path, ignored_diagnostics);
  return transport::digest_of(bytes ? *bytes : std::string());
}

}  // namespace

transport::Fingerprint fingerprint_of(const options::RenderOptions& render_options,
                                      std::set<std::string> files) {
  transport::DigestBuilder of_options;
  for (const options::OptionInfo& option : options::option_table()) {
    if (std::find(NotHashed.begin(), NotHashed.end(), option.key) != NotHashed.end()) continue;
    of_options.add(option.key);
    for (const std::string& word : options::option_words(render_options, option))
      of_options.add(" ").add(word);
    of_options.add("\n");
  }
  // The first render writes these files, and the next one reads them.
  if (!render_options.factors_file.empty()) {
    for (const char* ending : {".txt", "_cdf.txt"}) files.insert(render_options.factors_file + ending);
  }
  transport::DigestBuilder of_files;
  for (const std::string& path : files) {
    // An OP file counts by its options, which were hashed above.
    if (!path.ends_with(".op")) of_files.add(transport::bytes_of(digest_of_file(path)));
  }
  return {of_options.digest(), of_files.digest(), digest_of_file("/proc/self/exe")};
}

}  // namespace job
