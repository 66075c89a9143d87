#include "editor/tools/tool_windows.h"

#include "editor/tools/brdf_viewer_window.h"
#include "editor/tools/study_window.h"
#include "renderer/studies/brdf_viewer/tool.h"

namespace editor {

std::unique_ptr<ToolWindow> new_tool_window(const studies::StudyTool& tool) {
  if (tool.name() == studies::brdf_viewer_tool().name()) return std::make_unique<BrdfViewerWindow>();
  return std::make_unique<StudyWindow>(tool);
}

}  // namespace editor
