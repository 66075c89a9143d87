// Windows that stand alone, each for one task: `wannabe --tool NAME`.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

class QWidget;

namespace editor {

struct Tool {
  QString name;   ///< on the command line
  QString title;  ///< in menus
  QString about;  ///< a sentence
  /// Makes its window with these files opened; the caller shows and deletes it.
  std::function<QWidget*(const QStringList& files)> open;
};

/// All of them. A new tool is a new row here.
std::vector<Tool> tools();

}  // namespace editor
