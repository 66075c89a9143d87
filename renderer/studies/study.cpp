#include "renderer/studies/study.h"

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/wording.h"
#include "renderer/image/image.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/studies/brdf_viewer/tool.h"
#include "renderer/studies/environment/viewer.h"
#include "renderer/studies/fit_plot.h"
#include "renderer/studies/mini/render.h"
#include "renderer/studies/rejection/tool.h"
#include "renderer/studies/subdivision/tool.h"

namespace studies {
namespace {

/// Reports a part that is missing or one too many.
bool check_count(const ToolState& state, std::size_t found, std::size_t expected, std::string_view what,
                 grf::Diagnostics& diagnostics) {
  if (found == expected) return true;
  diagnostics.error(state.settings.location,
                    fmt::format("'{}' takes {}, and the state has {}", state.settings.keyword,
                                grf::counted(expected, what, fmt::format("{}s", what)), found));
  return false;
}

}  // namespace

std::optional<grf::Scene> read_model(const ToolState::File& file, const StudyContext& context,
                                     grf::Diagnostics& diagnostics) {
  if (context.read_scene) return context.read_scene(file.path, diagnostics);
  if (image::has_extension(file.path, "grf") || image::has_extension(file.path, "igrf"))
    return grf::read(file.path, diagnostics);
  diagnostics.error(file.location,
                    fmt::format("'{}' is no GRF scene: convert it with grfconvert", file.path));
  return std::nullopt;
}

void open_files(const StudyTool& tool, const std::vector<std::string>& paths, ToolState& state,
                grf::Diagnostics& diagnostics) {
  for (const std::string& path : paths) {
    if (!tool.takes_many_files) state.files.clear();
    state.files.push_back({path, {}});
  }
  if (!paths.empty() && tool.open != nullptr) tool.open(state, diagnostics);
}

bool check(const ToolState& state, const StudyTool& tool, grf::Diagnostics& diagnostics) {
  bool is_valid = grf::check(state.settings, {tool.settings}, "tool", diagnostics);
  is_valid = check_count(state, state.distribution ? 1 : 0, tool.distributions.empty() ? 0 : 1,
                         "distribution", diagnostics) &&
             is_valid;
  is_valid = check_count(state, state.brdfs.size(), tool.brdfs, "BRDF", diagnostics) && is_valid;
  is_valid = check_count(state, state.pdfs.size(), tool.pdfs, "sampling scheme", diagnostics) && is_valid;
  if (state.distribution && !tool.distributions.empty())
    is_valid = grf::check(*state.distribution, tool.distributions, "distribution", diagnostics) && is_valid;
  for (const grf::BrdfModel& brdf : state.brdfs)
    is_valid = grf::check(brdf, reflectance::brdf_infos(), "BRDF", diagnostics) && is_valid;
  for (const grf::PdfModel& pdf : state.pdfs)
    is_valid = grf::check(pdf, reflectance::scheme_infos(), "PDF", diagnostics) && is_valid;
  return is_valid;
}

std::vector<StudyTool> study_tools() {
  return {mini_render_tool(), environment_viewer_tool(), rejection_tool(),
          brdf_viewer_tool(), subdivision_tool(),        fit_plot_tool()};
}

std::optional<StudyTool> study_tool(std::string_view name) {
  for (const StudyTool& tool : study_tools()) {
    if (grf::same_keyword(tool.name(), name)) return tool;
  }
  return std::nullopt;
}

std::vector<DataFile> data_files_of(const Study& study) {
  std::vector<DataFile> files;
  const auto add_text = [&](const char* extension, const char* title, const std::string& text) {
    if (text.empty()) return;
    files.push_back({extension, title, [text](const std::string& path, grf::Diagnostics& diagnostics) {
                       return grf::replace_file(path, text, diagnostics);
                     }});
  };
  add_text("csv", "Values", study.csv);
  add_text("fit", "Directions", study.fit);
  files.insert(files.end(), study.files.begin(), study.files.end());
  return files;
}

bool write_data(const Study& study, const std::string& path, grf::Diagnostics& diagnostics) {
  std::vector<std::string> extensions;
  for (const DataFile& file : data_files_of(study)) {
    if (image::has_extension(path, file.extension)) return file.write(path, diagnostics);
    extensions.push_back('.' + file.extension);
  }
  diagnostics.error(grf::whole_file(path),
                    fmt::format("the data of this study can be written as {}", fmt::join(extensions, ", ")));
  return false;
}

std::optional<Study> study_of(const ToolState& state, const StudyContext& context,
                              grf::Diagnostics& diagnostics) {
  const auto tool = study_tool(state.settings.keyword);
  if (!tool) {
    std::vector<grf::ModelInfo> infos;
    for (const StudyTool& each : study_tools()) infos.push_back(each.settings);
    grf::report_unknown(state.settings, infos, "tool", {}, diagnostics);
    return std::nullopt;
  }
  if (!check(state, *tool, diagnostics)) return std::nullopt;
  return tool->make(state, context, diagnostics);
}

}  // namespace studies
