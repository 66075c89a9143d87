#include "editor/window/tools.h"

#include "editor/controls/text.h"
#include "editor/image/image_window.h"
#include "editor/options/options_window.h"
#include "editor/tools/tool_window.h"
#include "editor/tools/tool_windows.h"
#include "editor/window/viewer_window.h"
#include "renderer/studies/study.h"

namespace editor {
namespace {

QWidget* open_viewer(const QStringList& files) {
  auto* window = new ViewerWindow;
  if (!files.isEmpty()) window->open(files.front());
  return window;
}

QWidget* open_options(const QStringList& files) {
  auto* window = new OptionsWindow;
  if (!files.isEmpty()) window->editor().open(files.front());
  return window;
}

QWidget* open_images(const QStringList& files) {
  auto* window = new ImageWindow;
  window->browser().open_files(files);
  window->listen();
  return window;
}

QWidget* open_study(const studies::StudyTool& study, const QStringList& files) {
  auto window = new_tool_window(study);
  window->open(files);
  return window.release();
}

}  // namespace

std::vector<Tool> tools() {
  std::vector<Tool> all = {
      {"grfviewer", ToolWindow::tr("GRF &viewer"), ToolWindow::tr("View a scene without editing it"),
       open_viewer},
      {"op", ToolWindow::tr("Render &options"),
       ToolWindow::tr("Edit and check the render options of an OP file"), open_options},
      {"image", ToolWindow::tr("&Image view"),
       ToolWindow::tr("View and compare images, and renders in progress"), open_images},
  };
  for (const studies::StudyTool& study : studies::study_tools()) {
    const QString title = text_of(study.settings.title);
    all.push_back({text_of(study.name()), title, text_of(study.settings.description),
                   [study](const QStringList& files) { return open_study(study, files); }});
  }
  return all;
}

}  // namespace editor
