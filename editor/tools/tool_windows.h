#pragma once

#include <memory>

#include "editor/tools/tool_window.h"

namespace editor {

/// Creates the window of a tool, which for most shows a figure.
std::unique_ptr<ToolWindow> new_tool_window(const studies::StudyTool& tool);

}  // namespace editor
