// `wannabe --tool NAME` opens the window of a single tool.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

class QWidget;

namespace editor {

struct Tool {
  QString name;   ///< name on the command line
  QString title;  ///< title in menus
  QString about;  ///< a sentence
  /// Creates the tool's window with these files open; the caller shows and deletes it.
  std::function<QWidget*(const QStringList& files)> open;
};

/// The table of all tools. A new tool is a new row here.
std::vector<Tool> tools();

}  // namespace editor
