#include "renderer/command/render_reports.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "grf/text_file.h"

namespace command {
namespace {

/// Writes a table with tabs between columns, because texts of BRDFs have spaces and quotes.
std::string memory_report(const std::vector<transport::TableInfo>& tables) {
  std::string text = "# brdf\tpdf\tbytes\n";
  std::size_t sum = 0;
  for (const transport::TableInfo& table : tables) {
    text += fmt::format("{}\t{}\t{}\n", table.brdf, table.scheme, table.bytes);
    sum += table.bytes;
  }
  return text + fmt::format("sum\t\t{}\n", sum);
}

bool append_seconds(const std::filesystem::path& path, double seconds, grf::Diagnostics& diagnostics) {
  std::ofstream file(path, std::ios::app);
  file << fmt::format("{:.9g}\n", seconds) << std::flush;
  if (!file) diagnostics.error(grf::whole_file(path.string()), "cannot write to the file");
  return bool(file);
}

}  // namespace

bool write_reports(const transport::Render& render, const transport::CompiledScene& scene,
                   const options::RenderOptions& render_options, const std::string& image,
                   grf::Diagnostics& diagnostics) {
  const std::filesystem::path folder = std::filesystem::path(image).parent_path();
  bool written = true;
  if (render_options.writes_memory) {
    written &= grf::replace_file((folder / "mem.op").string(), memory_report(scene.tables()), diagnostics);
  }
  if (render_options.writes_sampling_time) {
    written &= append_seconds(folder / "samplingTime", render.sampling_seconds(), diagnostics);
  }
  if (render_options.writes_rendering_time) {
    written &= append_seconds(folder / "renderingTime", render.seconds(), diagnostics);
  }
  if (render_options.writes_prebuild_time) {
    written &= append_seconds(folder / "prebuildTime", scene.table_seconds(), diagnostics);
  }
  return written;
}

}  // namespace command
